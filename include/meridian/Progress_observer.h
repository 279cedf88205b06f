// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_PROGRESS_OBSERVER_H
#define MERIDIAN_PROGRESS_OBSERVER_H

#include <meridian/exceptions.h>

#include <string>

namespace meridian {

/// \ingroup PkgMeridianProgress
/// the stages of a cut, in the order they run.
enum class Stage { EXTREMA, FIELD, ORDER, CONTOURS, MERIDIANS, LINKS, OPEN, VERIFY };

/// \ingroup PkgMeridianProgress
/// \returns the name of a stage as it stands in reports
inline const char* name_of(Stage stage)
{
  switch (stage)
  {
  case Stage::EXTREMA: return "extrema";
  case Stage::FIELD: return "field";
  case Stage::ORDER: return "order";
  case Stage::CONTOURS: return "contours";
  case Stage::MERIDIANS: return "meridians";
  case Stage::LINKS: return "links";
  case Stage::OPEN: return "open";
  case Stage::VERIFY: return "verify";
  }
  return "";
}

/// \ingroup PkgMeridianProgress
/// base class of the objects that watch a run. Virtual, so that `override` rejects a misspelt hook.
class Progress_observer
{
public:
  virtual ~Progress_observer() = default;
  virtual void stage_started(Stage) {}                     ///< called once before each stage
  virtual void stage_progressed(Stage, double /*done*/) {} ///< `done` grows from 0 to 1; told by the links, the longest loop
  virtual void stage_finished(Stage) {}                    ///< not called if the stage throws
  /// asked between steps. \returns `false` to end the run with `Cancelled`
  virtual bool go_further() { return true; }
};

namespace internal {

// Reports one stage to an observer that may be absent.
class Stage_scope
{
public:
  Stage_scope(Progress_observer* observer, Stage stage) : m_observer(observer), m_stage(stage)
  {
    if (m_observer) { m_observer->stage_started(m_stage); }
    if (m_observer && !m_observer->go_further())
      throw Cancelled(std::string("cancelled during stage '") + name_of(m_stage) + "'");
  }
  void finish() const { if (m_observer) { m_observer->stage_finished(m_stage); } }

private:
  Progress_observer* m_observer;
  Stage m_stage;
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_PROGRESS_OBSERVER_H
