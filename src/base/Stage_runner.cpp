// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/base/Stage_runner.h>

#include <meridian/base/exceptions.h>

#include <string>

namespace meridian {

namespace internal {

Stage_scope::Stage_scope(Progress_observer* observer, Stage stage) : m_observer(observer), m_stage(stage)
{
  if (m_observer) { m_observer->stage_started(m_stage); }
  if (m_observer && !m_observer->go_further())
    throw Cancelled(std::string("cancelled during stage '") + name_of(m_stage) + "'");
}

} // namespace internal

void Stage_runner::progress(Stage stage, double done) const
{
  if (!observer) { return; }
  observer->stage_progressed(stage, done);
  if (!observer->go_further()) { throw Cancelled(std::string("cancelled during stage '") + name_of(stage) + "'"); }
}

} // namespace meridian
