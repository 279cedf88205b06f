// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_BASE_PROGRESS_OBSERVER_H
#define MERIDIAN_BASE_PROGRESS_OBSERVER_H

#include <functional>
#include <utility>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianProgress
/// the stages of a cut, of a search for generators or of an unwrapping, in the order they run.
enum class Stage
{
  EXTREMA,
  FIELD,
  ORDER,
  CONTOURS,
  MERIDIANS,
  FLOW,
  LONGITUDES,
  TIGHTEN,
  INSERT,
  CLASSIFY,
  LINKS,
  SHORTEN,
  OPEN,
  PARAMETERIZE,
  VERIFY
};

/// \ingroup PkgMeridianProgress
/// \returns the name of a stage as it stands in reports
const char* name_of(Stage stage);

/// \ingroup PkgMeridianProgress
/// base class of the objects that watch a run. Virtual, so that `override` rejects a misspelt hook.
class Progress_observer
{
public:
  virtual ~Progress_observer() = default;
  virtual void stage_started(Stage) {} ///< called once before each stage
  /// `done` grows from 0 to 1; told by the links, the longest loop
  virtual void stage_progressed(Stage, double /*done*/) {}
  virtual void stage_finished(Stage) {} ///< not called if the stage throws
  /// asked between steps. \returns `false` to end the run with `Cancelled`
  virtual bool go_further() { return true; }
};

/// \ingroup PkgMeridianProgress
/// how long each stage took, in seconds.
using Stage_times = std::vector<std::pair<Stage, double>>;

/// \ingroup PkgMeridianProgress
/// calls its second argument; the first is the stage. For clocks and observers.
using Run_stage = std::function<void(Stage, const std::function<void()>&)>;

/// \ingroup PkgMeridianProgress
/// runs a stage that nobody watches.
inline void run_unwatched(Stage, const std::function<void()>& work) { work(); }

} // namespace meridian

#endif // MERIDIAN_BASE_PROGRESS_OBSERVER_H
