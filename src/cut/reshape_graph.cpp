// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/internal/reshape_graph.h>

#include <meridian/base/Progress_observer.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/tighten_curves.h>
#include <meridian/cut/edge_cuts.h>
#include <meridian/cut/edge_cuts_near.h>
#include <meridian/cut/internal/name_paths.h>
#include <meridian/cut/shorten_cut_graph.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/insert_curves.h>
#include <meridian/surface/seam_paths.h>
#include <meridian/surface/seams.h>

#include <utility>
#include <vector>

namespace meridian {

namespace internal {

namespace {

// Takes over another graph. Its paths keep the names of what they stand for, if the graph had links.
void name_anew(const Triangle_surface& root, Refined_surface&& s, std::vector<std::vector<Index>> paths, bool has_links,
               Cut& cut)
{
  std::vector<Named_curve> curves;
  if (has_links) { curves = name_paths(root, s, std::move(paths), walks_of_meridians(root, cut)); }
  else
  {
    for (auto& path : paths) { curves.push_back({Curve_kind::PATH, std::move(path)}); }
  }
  cut.surface = std::move(s);
  cut.curves = std::move(curves);
  cut.choices.clear();
}

} // namespace

void reshape_graph(const Triangle_surface& root, const Cut_options& options, const Stage_runner& run, Cut& cut)
{
  const bool is_on_edges = cut.surface.origins.empty();
  const bool is_sphere = cut.genus == 0 && cut.boundary_loops == 0; // opened along one shortest path
  const bool shorten = options.tightening == Tightening::GRAPH && !is_sphere;
  if (!shorten && (!options.on_edges || is_on_edges || options.refine_where_needed)) { return; }
  run(Stage::SHORTEN, [&] {
    Refined_surface s(root);
    std::vector<Index> edges = cut_of_edges_near(root, cut.surface, shorten ? 0 : 5);
    if (shorten && options.on_edges)
    {
      edges = straighten_edge_cut(root, exchange_in_edge_cut(root, edges, 10), Path_ends::SLIDE, 5);
    }
    flag_seam(s, edges);
    std::vector<std::vector<Index>> paths = seam_paths(s);
    if (!options.on_edges)
    {
      const auto curves = shorten_cut_graph(root, paths, options.tighten_options,
                                            [&](double done) { run.progress(Stage::SHORTEN, done); });
      s = Refined_surface(root);
      paths = insert_curves(root, s, curves).vertices;
    }
    name_anew(root, std::move(s), std::move(paths), !cuts_edges(options.method), cut);
  });
}

} // namespace internal

} // namespace meridian
