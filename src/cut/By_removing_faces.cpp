// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/By_removing_faces.h>

#include <meridian/cut/Cut_job.h>
#include <meridian/cut/edge_cuts.h>
#include <meridian/surface/seam_paths.h>
#include <meridian/surface/seams.h>

namespace meridian {

void By_removing_faces::cut_handles(Cut_job& job) const
{
  Refined_surface& s = job.cut.surface;
  s = Refined_surface(job.root);
  job.run(Stage::MERIDIANS, [&] { flag_seam(s, cut_by_removing_faces(job.root)); });
  add_curves(job.cut, Curve_kind::PATH, seam_paths(s));
}

} // namespace meridian
