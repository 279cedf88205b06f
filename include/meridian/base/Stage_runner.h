// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_BASE_STAGE_RUNNER_H
#define MERIDIAN_BASE_STAGE_RUNNER_H

#include <meridian/base/Progress_observer.h>

#include <chrono>

namespace meridian {

namespace internal {

// Reports one stage to an observer that may be absent.
class Stage_scope
{
public:
  Stage_scope(Progress_observer* observer, Stage stage);
  void finish() const
  {
    if (m_observer) { m_observer->stage_finished(m_stage); }
  }

private:
  Progress_observer* m_observer;
  Stage m_stage;
};

} // namespace internal

/// \ingroup PkgMeridianProgress
/// runs stages, with a clock, and tells an observer that may be absent.
struct Stage_runner
{
  Progress_observer* observer; ///< told of the stages, or null
  Stage_times& seconds;        ///< receives how long each stage took

  /// runs a stage; what it throws goes on.
  /// \param stage the stage
  /// \param work what it does: a function without arguments
  template <class Work> void operator()(Stage stage, const Work& work) const
  {
    const internal::Stage_scope scope(observer, stage);
    const auto begin = std::chrono::steady_clock::now();
    work();
    seconds.emplace_back(stage, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    scope.finish();
  }
  /// tells how much of a stage is done, and throws `Cancelled` if the observer wants to end the run.
  /// \param stage the stage
  /// \param done from 0 to 1
  void progress(Stage stage, double done) const;
};

} // namespace meridian

#endif // MERIDIAN_BASE_STAGE_RUNNER_H
