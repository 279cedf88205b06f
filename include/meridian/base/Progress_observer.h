// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_BASE_PROGRESS_OBSERVER_H
#define MERIDIAN_BASE_PROGRESS_OBSERVER_H

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include <meridian/base/names.h>

namespace meridian {

/// \ingroup PkgMeridianProgress
/// the stages of a cut, of a search for generators or of an unwrapping, in the order they run.
enum class Stage
{
  EXTREMA,      ///< two vertices far apart
  FIELD,        ///< the field is solved for
  ORDER,        ///< vertices are ordered, and the order simplified
  CONTOURS,     ///< level lines are traced
  MERIDIANS,    ///< those that cut the handles are chosen
  FLOW,         ///< flow lines are traced
  LONGITUDES,   ///< a loop across each meridian is found
  TIGHTEN,      ///< curves are shortened within their classes
  INSERT,       ///< faces are divided along the curves
  CLASSIFY,     ///< on which side of the surface curves bound
  LINKS,        ///< boundaries are joined
  SHORTEN,      ///< the whole cut graph is shortened
  OPEN,         ///< the surface is opened
  PARAMETERIZE, ///< discs are mapped into the plane
  VERIFY        ///< the result is recounted
};

/// the names of `Stage`.
template <> struct Names<Stage>
{
  static constexpr std::array<Named_value<Stage>, 15> table{{
    {Stage::EXTREMA, "extrema", "two vertices far apart"},
    {Stage::FIELD, "field", "the field is solved for"},
    {Stage::ORDER, "order", "vertices are ordered, and the order simplified"},
    {Stage::CONTOURS, "contours", "level lines are traced"},
    {Stage::MERIDIANS, "meridians", "those that cut the handles are chosen"},
    {Stage::FLOW, "flow", "flow lines are traced"},
    {Stage::LONGITUDES, "longitudes", "a loop across each meridian is found"},
    {Stage::TIGHTEN, "tighten", "curves are shortened within their classes"},
    {Stage::INSERT, "insert", "faces are divided along the curves"},
    {Stage::CLASSIFY, "classify", "on which side of the surface curves bound"},
    {Stage::LINKS, "links", "boundaries are joined"},
    {Stage::SHORTEN, "shorten", "the whole cut graph is shortened"},
    {Stage::OPEN, "open", "the surface is opened"},
    {Stage::PARAMETERIZE, "parameterize", "discs are mapped into the plane"},
    {Stage::VERIFY, "verify", "the result is recounted"},
  }};
};

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
  /// asked at the beginning of a stage, and within those that tell their progress; a factorization, which most of the
  /// field is, is not interrupted. Asked in the thread that runs. \returns `false` to end the run with `Cancelled`
  virtual bool go_further() { return true; }
};

/// \ingroup PkgMeridianProgress
/// told by a function that works alone how much of it is done, from 0 to 1; may throw to end it. May be empty.
using Progress = std::function<void(double)>;

/// \ingroup PkgMeridianProgress
/// how long each stage took, in seconds.
using Stage_times = std::vector<std::pair<Stage, double>>;

/// \ingroup PkgMeridianProgress
/// calls its second argument; the first is the stage. For clocks and observers.
using Run_stage = std::function<void(Stage, const std::function<void()>&)>;

/// \ingroup PkgMeridianProgress
/// runs a stage that nobody watches.
/// \param work what the stage does
inline void run_unwatched(Stage, const std::function<void()>& work) { work(); }

} // namespace meridian

#endif // MERIDIAN_BASE_PROGRESS_OBSERVER_H
