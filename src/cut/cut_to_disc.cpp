// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/cut_to_disc.h>

#include <meridian/base/Progress_observer.h>
#include <meridian/base/Stage_runner.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/Cut_job.h>
#include <meridian/cut/internal/reshape_graph.h>
#include <meridian/cut/link_boundaries.h>
#include <meridian/cut/link_on_edges.h>
#include <meridian/cut/open_cut.h>
#include <meridian/cut/planar_links.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/seams.h>

#include <utility>
#include <variant>
#include <vector>

namespace meridian {

namespace internal {

namespace {

// Links what boundaries there are: along edges, in the plane, or over the surface.
void link(const Triangle_surface& root, const Cut_options& options, const std::vector<Link_guide>& guides,
          const Stage_runner& run, Cut& cut)
{
  if (cuts_edges(options.method)) { return; }
  if (options.on_edges && options.tightening != Tightening::GRAPH
      && (cut.genus == 0 || moves_onto_edges(options.method)))
  {
    std::vector<Index> points;
    if (options.links.source >= 0) { points.push_back(options.links.source); }
    add_curves(cut, Curve_kind::LINK, link_boundaries_on_edges(cut.surface, points));
    return;
  }
  if (options.link_domain == Link_domain::PLANE)
  {
    std::vector<std::vector<Index>> lines;
    cut.link_note = link_boundaries_in_plane(root, cut.surface, options.links.source, lines, options.solvers.laplace);
    cut.links_in_plane = cut.link_note.empty();
    add_curves(cut, Curve_kind::LINK, std::move(lines));
    if (cut.links_in_plane) { return; }
  }
  add_curves(cut, Curve_kind::LINK, link_boundaries(root, cut.surface, options.links, guides, [&](double done) {
               run.progress(Stage::LINKS, done);
             }));
}

} // namespace

} // namespace internal

Cut cut_to_disc(const Triangle_surface& root, const Cut_options& chosen)
{
  check(root, chosen);
  Cut_options options = chosen;
  options.tightening = tightening_of(chosen);
  Cut cut;
  cut.tightening = *options.tightening;
  const Stage_runner run{options.observer, cut.seconds};
  cut.boundary_loops = static_cast<int>(boundary_loops(root).size());
  cut.genus = genus(root);
  cut.smallest_angle_before = smallest_angle(root);

  const bool is_disc = cut.genus == 0 && cut.boundary_loops == 1;
  Cut_job job{root, options, run, cut};
  if (cuts_edges(options.method) ? !is_disc : cut.genus > 0)
  {
    std::visit([&](const auto& method) { method.cut_handles(job); }, options.method);
  }
  else { cut.surface = Refined_surface(root); }
  run(Stage::LINKS, [&] { internal::link(root, options, job.guides, run, cut); });
  cut.length_found = seam_length(cut.surface);
  if (!is_disc) { internal::reshape_graph(root, options, run, cut); }
  run(Stage::OPEN, [&] { open_cut(cut); });
  return cut;
}

} // namespace meridian
