// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/cut_to_disc.h>

#include <meridian/base/Progress_observer.h>
#include <meridian/base/Stage_runner.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/internal/cut_methods.h>
#include <meridian/cut/internal/reshape_graph.h>
#include <meridian/cut/link_boundaries.h>
#include <meridian/cut/link_on_edges.h>
#include <meridian/cut/open_cut.h>
#include <meridian/cut/planar_links.h>
#include <meridian/field/Field.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/field/geodesic_distance.h>
#include <meridian/field/order_surface.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/seams.h>

#include <utility>
#include <vector>

namespace meridian {

namespace internal {

namespace {

// Cuts all handles along curves of a field. Returns guides for the links.
std::vector<Link_guide> cut_handles(const Triangle_surface& root, const Cut_options& options, const Stage_runner& run,
                                    Cut& cut)
{
  Field_options field = options;
  field.one_maximum = options.method == Cut_method::MORSE;
  if (options.method == Cut_method::GEODESIC)
    run(Stage::FIELD, [&] {
      const Closed_model g = make_closed_model(root);
      const Index source = options.source >= 0 ? options.source : g.representative[find_distant_nodes(root, g).first];
      field.values_name = "distance";
      field.values = geodesic_distance(root, {source}, options.solvers.symmetric);
    });
  const Ordered_surface m = order_surface(root, field, run);
  static_cast<Field_summary&>(cut) = summarize_field(root, m, field);
  switch (options.method)
  {
  case Cut_method::GEODESIC:
  case Cut_method::CONTOURS: cut_along_contours(root, m, options, run, cut); break;
  case Cut_method::GENERATORS: return cut_along_generators(root, m, options, run, cut);
  case Cut_method::MORSE: cut_along_flow_lines(root, m, run, cut); break;
  default: break;
  }
  return {};
}

// Links what boundaries there are: along edges, in the plane, or over the surface.
void link(const Triangle_surface& root, const Cut_options& options, const std::vector<Link_guide>& guides,
          const Stage_runner& run, Cut& cut)
{
  if (cuts_edges(options.method)) { return; }
  if (options.on_edges && options.tightening != Tightening::GRAPH
      && (cut.genus == 0 || (options.method != Cut_method::GENERATORS && options.method != Cut_method::MORSE)))
  {
    add_curves(cut, Curve_kind::LINK, link_boundaries_on_edges(cut.surface, options.links.source));
    return;
  }
  if (options.link_domain == Link_domain::PLANE)
  {
    std::vector<std::vector<Index>> lines;
    cut.link_note = link_boundaries_in_plane(root, cut.surface, options.links.source, lines, options.solvers.symmetric);
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

Cut cut_to_disc(const Triangle_surface& root, const Cut_options& options)
{
  check(root, options);
  Cut cut;
  const internal::Stage_runner run{options.observer, cut.seconds};
  cut.boundary_loops = static_cast<int>(boundary_loops(root).size());
  const int characteristic = root.number_of_vertices() - root.number_of_edges() + root.number_of_faces();
  cut.genus = (2 - characteristic - cut.boundary_loops) / 2;
  cut.smallest_angle_before = smallest_angle(root);
  cut.surface = Refined_surface(root);

  const bool is_disc = cut.genus == 0 && cut.boundary_loops == 1, is_of_edges = cuts_edges(options.method);
  std::vector<Link_guide> guides;
  if (is_of_edges && !is_disc) { internal::cut_along_edges(root, options, run, cut); }
  if (cut.genus > 0 && !is_of_edges) { guides = internal::cut_handles(root, options, run, cut); }
  run(Stage::LINKS, [&] { internal::link(root, options, guides, run, cut); });
  cut.length_found = seam_length(cut.surface);
  if (!is_disc) { internal::reshape_graph(root, options, run, cut); }
  run(Stage::OPEN, [&] { open_cut(cut); });
  return cut;
}

} // namespace meridian
