// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/By_own_method.h>

#include <meridian/cut/Cut_job.h>
#include <meridian/surface/Refined_surface.h>

namespace meridian {

void By_own_method::cut_handles(Cut_job& job) const
{
  job.cut.surface = Refined_surface(job.root);
  m_cut(job);
}

} // namespace meridian
