// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_FILL_BOUNDARY_H
#define MERIDIAN_SURFACE_FILL_BOUNDARY_H

#include <meridian/curves/project_contours.h>
#include <meridian/field/order_surface.h>

namespace meridian {

/// \ingroup PkgMeridianOrder
/// a surface with a fan over each boundary loop. Vertices and faces of the surface come first and keep their numbers;
/// then, for each loop, one vertex and one face an edge.
struct Filled_surface
{
  Triangle_surface surface;
  Index vertices = 0, faces = 0; ///< of the surface that was filled
};

/// \ingroup PkgMeridianOrder
/// \returns `root` with its boundary loops filled
/// \par Complexity
/// Linear.
inline Filled_surface fill_boundary(const Triangle_surface& root)
{
  Filled_surface filled{root, root.number_of_vertices(), root.number_of_faces()};
  Triangle_surface& s = filled.surface;
  for (const auto& loop : boundary_loops(root))
  {
    const Index centre = s.number_of_vertices(), first = s.number_of_faces(), n = static_cast<Index>(loop.size());
    Point sum{0, 0, 0};
    for (Index i = 0; i < n; ++i)
    {
      const Index h = loop[i], f = first + i;
      sum = sum + root.points[root.source(h)];
      s.triangles.push_back({root.target(h), root.source(h), centre});
      s.opposite[h] = 3 * f;
      s.opposite.insert(s.opposite.end(), {h, 3 * (first + (i + n - 1) % n) + 2, 3 * (first + (i + 1) % n) + 1});
    }
    s.points.push_back((1. / n) * sum);
  }
  find_outgoing(s);
  return filled;
}

/*!
 * \ingroup PkgMeridianOrder
 *
 * orders a filled surface by a harmonic field whose boundary is free (without flux): level lines may end on the
 * boundary.
 *
 * The field is solved on the surface alone; the middle of each fan takes the mean of its loop, which makes no extremum.
 * So with one minimum and one maximum there are 2g saddles on the filled surface, and its contours, arcs continued
 * through the fans, are closed.
 *
 * \param filled the filled surface
 * \param options weights and extrema
 * \param run calls its second argument; the first is the stage
 * \returns the ordered surface
 * \throws Invalid_input_error if minima and maxima coincide, Solver_error if the field cannot be solved
 * \par Complexity
 * that of `order_surface()`
 */
inline Ordered_surface order_with_free_boundary(const Filled_surface& filled, const Field_options& options, const Run_stage& run)
{
  Ordered_surface m;
  std::vector<Index> minima = options.minima, maxima = options.maxima;
  run(Stage::EXTREMA, [&] {
    m.surface = Refined_surface(filled.surface);
    m.graph = make_closed_model(m.surface);
    if (options.weights == Weights::INTRINSIC_DELAUNAY && options.values.empty())
      throw Invalid_input_error(
        "intrinsic Delaunay weights are made for the closed model; choose others where the boundary is free");
    if (minima.empty() && maxima.empty() && options.values.empty())
    {
      auto [a, b] = find_distant_nodes(m.surface, m.graph);
      for (Index* v : {&a, &b}) // the middle of a fan is no place of the surface
        if (*v >= filled.vertices) { *v = m.surface.target(m.surface.outgoing[*v]); }
      if (a == b) { b = m.surface.target(m.surface.outgoing[a]); }
      minima = {std::min(a, b)};
      maxima = {std::max(a, b)};
    }
    for (auto* nodes : {&minima, &maxima})
    {
      std::sort(nodes->begin(), nodes->end());
      nodes->erase(std::unique(nodes->begin(), nodes->end()), nodes->end());
    }
    for (Index a : maxima)
      if (std::binary_search(minima.begin(), minima.end(), a))
        throw Invalid_input_error("a minimum and a maximum of the field lie on the same vertex (vertex "
                                  + std::to_string(a) + "); choose them apart");
  });
  run(Stage::FIELD, [&] {
    const Triangle_surface& s = m.surface;
    const auto fill = [&] {
      for (Index c = filled.vertices; c < s.number_of_vertices(); ++c)
      {
        double sum = 0;
        int count = 0;
        s.for_each_outgoing(c, [&](Index h) {
          sum += m.field.value[s.target(h)];
          ++count;
        });
        m.field.value[c] = sum / count;
      }
    };
    if (!options.values.empty())
    {
      std::vector<double> values = options.values;
      if (static_cast<Index>(values.size()) != filled.vertices)
        throw Invalid_input_error("a field has " + std::to_string(values.size()) + " values for "
                                  + std::to_string(filled.vertices) + " vertices; it needs one a vertex");
      values.resize(s.number_of_vertices(), 0);
      m.field = internal::field_of_values(filled.surface, m.surface, m.graph, values);
      fill();
      return;
    }
    auto weights = edge_weights(s, options.weights);
    for (Index h = 0; h < s.number_of_halfedges(); ++h)
      if (s.source(h) >= filled.vertices || s.target(h) >= filled.vertices) { weights[h] = 0; }
    m.field = Scalar_field(m.graph.number_of_nodes);
    std::vector<char> is_known(m.graph.number_of_nodes, 0);
    for (Index v : minima) { is_known[v] = 1; }
    for (Index v : maxima)
    {
      is_known[v] = 1;
      m.field.value[v] = 1;
    }
    std::vector<Index> unknown;
    for (Index v = 0; v < filled.vertices; ++v)
    {
      if (!is_known[v]) { unknown.push_back(v); }
    }
    internal::Laplace_system system(m.graph, weights, options.weights == Weights::MEAN_VALUE ? options.solvers.general : options.solvers.symmetric);
    system.solve(unknown, [&](Index a) { return m.field.value[a]; }, m.field.value);
    fill();
  });
  run(Stage::ORDER, [&] { order_by_field(filled.surface, m, minima, maxima); });
  return m;
}

namespace internal {

// Contours of a filled surface as crossings of the surface alone. Where one runs through a fan it is pushed out over
// the vertices that it separates from the fan's middle: around each of them, across all edges inside the surface. Those
// that passed farther from such a vertex come to lie nearer to it.
//
// `arcs`: how many pieces end on the boundary; `loops`: how many do not.
inline std::vector<std::vector<Crossing>> project_from_filled(const Triangle_surface& root,
                                                              const Filled_surface& filled, const Ordered_surface& m,
                                                              const std::vector<const Contour*>& contours, int& arcs,
                                                              int& loops)
{
  arcs = loops = 0;
  const Triangle_surface& s = filled.surface;
  std::vector<std::vector<Crossing>> result;
  for (const auto& contour : project_crossings(s, m, contours))
  {
    std::vector<Crossing> curve;
    int passes = 0;
    for (const Crossing& c : contour)
    {
      const Index a = s.source(c.halfedge), b = s.target(c.halfedge);
      if (a < filled.vertices && b < filled.vertices)
      {
        // `edge()` is the same on both surfaces
        if (root.number_of_halfedges() > c.halfedge && root.opposite[c.halfedge] >= 0)
        {
          curve.push_back(c);
          continue;
        }
        ++passes; // over the boundary, out or in
        continue;
      }
      // Past vertex u of a fan, on the side that its middle is not on.
      const Index u = a < filled.vertices ? a : b;
      const bool middle_on_left = b >= filled.vertices; // of the way across, whose left is the target
      std::vector<Index> around; // halfedges of the surface that leave u, in the order of the pushed way
      for (Index h = root.outgoing[u]; h >= 0; h = root.turn_left(h)) { around.push_back(h); }
      // In the fan the way goes by u with the middle on one side; in the surface it goes the same way round u.
      if (!middle_on_left) { std::reverse(around.begin(), around.end()); }
      for (Index h : around)
      {
        if (root.opposite[h] < 0) { continue; } // the boundary itself
        // On an edge places are counted from the end with the lower index, and so they are on the spoke: from u.
        const Index e = root.edge(h);
        const bool is_lower = u < root.target(h), from_source = (root.source(e) == u) == is_lower;
        const double t = root.source(e) == u ? 0.02 : 0.98;
        curve.push_back({middle_on_left ? root.opposite[h] : h, e, is_lower ? -1 - c.piece : 2 + c.piece,
                         is_lower ? -c.place : c.place, t, from_source});
      }
    }
    cancel(root, curve);
    if (curve.size() < 3) { throw Internal_error("project_from_filled: a contour can be pulled to a point"); }
    if (passes == 0) { ++loops; }
    arcs += passes / 2;
    result.push_back(std::move(curve));
  }
  return result;
}

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_SURFACE_FILL_BOUNDARY_H
