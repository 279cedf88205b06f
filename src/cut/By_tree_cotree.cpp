// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/By_tree_cotree.h>

#include <meridian/base/exceptions.h>
#include <meridian/cut/Cut_job.h>
#include <meridian/cut/edge_cuts.h>
#include <meridian/surface/check_surface.h>
#include <meridian/surface/seam_paths.h>
#include <meridian/surface/seams.h>

#include <string>

namespace meridian {

void check(const By_tree_cotree& method)
{
  if (method.bases < 1)
  {
    throw Invalid_input_error(std::to_string(method.bases) + " base points were asked for; one is the least");
  }
}

void check(const Triangle_surface& s, const By_tree_cotree& method)
{
  check(method);
  if (method.source != -1) { check_vertices(s, {method.source}, "the vertex to begin at"); }
}

void By_tree_cotree::cut_handles(Cut_job& job) const
{
  Refined_surface& s = job.cut.surface;
  s = Refined_surface(job.root);
  job.run(Stage::MERIDIANS, [&] {
    flag_seam(s, source >= 0
                   ? cut_by_tree_cotree(job.root, source, metric)
                   : find_short_tree_cotree_cut(
                     job.root, bases, [&](double done) { job.run.progress(Stage::MERIDIANS, done); }, metric));
  });
  add_curves(job.cut, Curve_kind::PATH, seam_paths(s));
}

} // namespace meridian
