// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_TO_DISC_H
#define MERIDIAN_CUT_TO_DISC_H

#include <meridian/Progress_observer.h>
#include <meridian/link_boundaries.h>
#include <meridian/open_along.h>
#include <meridian/planar_links.h>

#include <meridian/project_contours.h>
#include <meridian/select_meridians.h>
#include <meridian/solve_harmonic_field.h>

#include <chrono>
#include <string>

namespace meridian {

/// \ingroup PkgMeridianCut
/// where links run.
enum class Link_domain
{
  SURFACE, ///< shortest paths on the surface
  PLANE    ///< counterimages of segments in a planar embedding, where one exists in double precision
};

/// \ingroup PkgMeridianCut
/// what one may choose about a cut. Vertices are those of the surface that is cut.
struct Cut_options
{
  Weights weights = Weights::POSITIVE;
  std::vector<Index> minima, maxima; ///< vertices where the field is 0 and 1; both empty: two vertices far apart
  Preference preference = preference::gaussian_curvature;
  Link_domain link_domain = Link_domain::SURFACE;
  Link_options links;
  Progress_observer* observer = nullptr;
};

/// \ingroup PkgMeridianCut
/// a cut graph of one connected surface, and what was counted on the way.
struct Disc_cut
{
  Refined_surface surface;                       ///< the input, refined; the cut graph is its seam
  Opened_surface opened;                         ///< the disc
  std::vector<std::vector<Index>> meridians;     ///< closed, as vertices of `surface`, the most preferred first
  std::vector<std::vector<Index>> links;         ///< open, as vertices of `surface`
  std::vector<Meridian_choice> choices;          ///< the count after each meridian
  std::vector<double> field;                     ///< at the vertices of the input; empty where no field was needed
  std::vector<Index> saddles;                    ///< for each meridian, a vertex of its saddle
  std::vector<Critical_point> critical;          ///< of the closed model, as vertices of the input or -1
  Critical_counts counts;
  int genus = 0, boundary_loops = 0;
  int order_rounds = 0, flat_regions = 0;
  bool order_numbered = false;
  bool links_in_plane = false;
  std::string link_note;                         ///< why links were not taken through the plane, if asked for
  double length = 0;                             ///< of the seams
  double smallest_angle_before = 0, smallest_angle_after = 0; ///< in radians
  std::vector<std::pair<Stage, double>> seconds;
};

namespace internal {

// The field, its order, and the surface on which all saddles are simple.
template <class SymmetricTraits, class GeneralTraits, class Run>
Ordered_surface order_surface(const Triangle_surface& root, const Cut_options& options, const Run& run)
{
  Ordered_surface m;
  std::vector<Dirichlet_value> prescribed;
  std::vector<Index> minima, maxima;
  run(Stage::EXTREMA, [&] {
    m.surface = divide_chords(root);
    m.graph = make_node_graph(m.surface);
    if (options.minima.empty() && options.maxima.empty())
    {
      const auto [a, b] = find_distant_nodes(m.surface, m.graph);
      minima = {std::min(a, b)};
      maxima = {std::max(a, b)};
    }
    for (Index v : options.minima) { minima.push_back(m.graph.node[v]); }
    for (Index v : options.maxima) { maxima.push_back(m.graph.node[v]); }
    for (auto* nodes : {&minima, &maxima})
    {
      std::sort(nodes->begin(), nodes->end());
      nodes->erase(std::unique(nodes->begin(), nodes->end()), nodes->end());
    }
    for (Index a : maxima)
      if (std::binary_search(minima.begin(), minima.end(), a))
        throw Invalid_input_error("a minimum and a maximum of the field lie on "
                                  + std::string(m.graph.is_loop(a) ? "one boundary loop, which is one place of the field"
                                                                   : "the same vertex")
                                  + " (vertex " + std::to_string(m.graph.representative[a]) + "); choose them apart");
    for (Index a : minima) { prescribed.push_back({a, 0}); }
    for (Index a : maxima) { prescribed.push_back({a, 1}); }
  });
  run(Stage::FIELD, [&] {
    const auto weights = edge_weights(m.surface, options.weights);
    m.field = options.weights == Weights::MEAN_VALUE
                ? solve_harmonic_field<GeneralTraits>(m.surface, m.graph, weights, prescribed)
                : solve_harmonic_field<SymmetricTraits>(m.surface, m.graph, weights, prescribed);
  });
  run(Stage::ORDER, [&] {
    m.order = order_nodes(m.graph, m.field);
    simplify_order(m.graph, m.order, minima, maxima);
    for (Index a : m.graph.node) { m.rank.push_back(m.order.rank[a]); }
    m.critical = find_critical_points(m.surface, m.rank);
    unfold_saddles(root, m);
  });
  return m;
}

// The root vertex nearest to a vertex of a refined surface.
inline Index root_vertex(const Triangle_surface& root, const Refined_surface& s, Index v)
{
  const Origin o = s.origin(v);
  if (o.kind == Origin::FACE)
  {
    const auto w = std::max_element(o.weight.begin(), o.weight.end()) - o.weight.begin();
    return root.triangles[o.index[0]][w];
  }
  return o.kind == Origin::EDGE && o.weight[0] > 0.5 ? o.index[1] : o.index[0];
}

} // namespace internal

/*!
 * \ingroup PkgMeridianCut
 *
 * cuts a connected surface into a disc along smooth curves (Patane 2007, section 3).
 *
 * A harmonic field is ordered, simplified and unfolded; of its saddles' contours as many as there are handles are cut
 * as meridians; the boundaries that this leaves are joined by a tree of links. A disc stays as it is.
 *
 * \tparam SymmetricTraits, GeneralTraits models of CGAL's `SparseLinearAlgebraWithFactorTraits_d`; the second serves
 *         mean-value weights
 * \param root the surface
 * \param options see there
 *
 * \returns the cut, which is topologically right however bad the shape of the faces is
 * \pre `root` is connected
 * \throws Invalid_input_error if minima and maxima coincide, Solver_error if the field cannot be solved, Cancelled if the
 *         observer says so, Internal_error if an invariant broke
 * \par Complexity
 * One factorization, \f$ O(n^{1.5}) \f$, and \f$ O(n \log n) \f$ beside it.
 */
template <class SymmetricTraits = Symmetric_solver_traits, class GeneralTraits = General_solver_traits>
Disc_cut cut_to_disc(const Triangle_surface& root, const Cut_options& options = Cut_options())
{
  Disc_cut cut;
  const auto run = [&](Stage stage, const auto& work) {
    const internal::Stage_scope scope(options.observer, stage);
    const auto begin = std::chrono::steady_clock::now();
    work();
    cut.seconds.emplace_back(stage, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    scope.finish();
  };

  cut.boundary_loops = static_cast<int>(boundary_loops(root).size());
  const int characteristic = root.number_of_vertices() - root.number_of_edges() + root.number_of_faces();
  cut.genus = (2 - characteristic - cut.boundary_loops) / 2;
  cut.smallest_angle_before = smallest_angle(root);
  cut.surface = Refined_surface(root);

  if (cut.genus > 0)
  {
    Ordered_surface m = internal::order_surface<SymmetricTraits, GeneralTraits>(root, options, run);
    cut.critical = m.critical;
    cut.counts = count(m.critical);
    for (Critical_point& p : cut.critical) { if (p.vertex >= root.number_of_vertices()) { p.vertex = -1; } }
    cut.order_rounds = m.order.rounds;
    cut.order_numbered = m.order.numbered;
    cut.flat_regions = static_cast<int>(m.field.regions.size()) - 1;
    for (Index v = 0; v < root.number_of_vertices(); ++v) { cut.field.push_back(m.field(m.graph.node[v])); }

    std::vector<Contour> loops;
    run(Stage::CONTOURS, [&] { loops = trace_saddle_loops(m); });
    run(Stage::MERIDIANS, [&] {
      std::vector<Loop_candidate> candidates;
      for (const Contour& loop : loops)
      {
        const Index v = internal::root_vertex(root, m.surface, loop.saddle);
        candidates.push_back({v, root.points[v], curvature(root, v), length(m, loop), loop.is_longer});
      }
      cut.choices = select_meridians(m, loops, rank_by_preference(candidates, options.preference));
      if (static_cast<int>(cut.choices.size()) != cut.genus)
        throw Internal_error("cut_to_disc: " + std::to_string(cut.choices.size()) + " meridians on a surface of genus "
                             + std::to_string(cut.genus));
      std::vector<const Contour*> chosen;
      for (const auto& choice : cut.choices)
      {
        chosen.push_back(&loops[choice.loop]);
        cut.saddles.push_back(candidates[choice.loop].saddle);
      }
      cut.meridians = insert_curves(root, cut.surface, project_contours(root, m, chosen)).vertices;
    });
  }
  run(Stage::LINKS, [&] {
    if (options.link_domain == Link_domain::PLANE)
    {
      cut.link_note = link_boundaries_in_plane<SymmetricTraits>(root, cut.surface, options.links.source, cut.links);
      cut.links_in_plane = cut.link_note.empty();
      if (cut.links_in_plane) { return; }
    }
    Link_options links = options.links;
    if (options.observer)
    {
      links.progress = [&](double done) {
        options.observer->stage_progressed(Stage::LINKS, done);
        if (!options.observer->go_further()) { throw Cancelled("cancelled during stage 'links'"); }
      };
    }
    cut.links = link_boundaries(root, cut.surface, cut.meridians, links);
  });
  run(Stage::OPEN, [&] {
    cut.opened = open_along(cut.surface);
    for (const auto& seam : cut.opened.seams) { cut.length += cut.surface.length(seam[0]); }
    cut.smallest_angle_after = smallest_angle(cut.surface);
  });
  return cut;
}

} // namespace meridian

#endif // MERIDIAN_CUT_TO_DISC_H
