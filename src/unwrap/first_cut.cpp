// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/internal/first_cut.h>

#include <meridian/base/exceptions.h>
#include <meridian/cut/By_contours.h>
#include <meridian/cut/complete_cut.h>
#include <meridian/cut/cut_to_disc.h>
#include <meridian/cut/keep_out.h>
#include <meridian/surface/seams.h>

#include <variant>

namespace meridian {

namespace internal {

bool completes_seams(const Cut_options& o)
{
  return std::holds_alternative<By_contours>(o.method) && o.tightening != Tightening::GRAPH
         && o.link_domain == Link_domain::SURFACE && o.links.source < 0 && !o.refine_where_needed;
}

void check_wishes(const Unwrap_options& options)
{
  if (options.seams.empty() && options.keep_out.empty()) { return; }
  if (!completes_seams(options.cut))
  {
    throw Invalid_input_error(
      "seams that are given, or faces to keep out of, are completed by contours and links over the surface, and stay "
      "where they are: no other method, domain or source of links, and no tightening of the graph");
  }
  if (options.family != 1 || options.stretch_weight > 0 || options.image_size > 0)
  {
    throw Invalid_input_error("seams that are given, or faces to keep out of, leave no choice of cuts: no family, no "
                              "weight of stretch, no geometry image");
  }
}

Cut first_cut(const Triangle_surface& root, const std::vector<Index>& seams, const Unwrap_options& options)
{
  const Cut_options& o = options.cut;
  if (seams.empty() && options.keep_out.empty()) { return cut_to_disc(root, o); }
  return complete_cut(root, seams,
                      {o.on_edges, o.links.bifurcations, o.tighten_options, o.solvers, o.observer, options.keep_out});
}

std::vector<char> kept_out_of(const Triangle_surface& root, const Unwrap_options& options)
{
  check_wishes(options);
  if (options.keep_out.empty()) { return {}; }
  check_seams(root, options.seams);
  Refined_surface s(root);
  flag_seam(s, options.seams);
  return find_kept_out(s, options.keep_out);
}

} // namespace internal

} // namespace meridian
