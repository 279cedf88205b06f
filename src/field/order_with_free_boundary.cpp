// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/order_with_free_boundary.h>

#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/field/Laplace_system.h>
#include <meridian/field/Scalar_field.h>
#include <meridian/field/edge_weights.h>
#include <meridian/field/order_surface.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/measures.h>

#include <algorithm>
#include <string>
#include <vector>

namespace meridian {

Ordered_surface order_with_free_boundary(const Filled_surface& filled, const Field_options& options,
                                         const Run_stage& run)
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
    internal::Laplace_system system(
      m.graph, weights, options.weights == Weights::MEAN_VALUE ? options.solvers.general : options.solvers.symmetric);
    system.solve(
      unknown, [&](Index a) { return m.field.value[a]; }, m.field.value);
    fill();
  });
  run(Stage::ORDER, [&] { order_by_field(filled.surface, m, minima, maxima); });
  return m;
}

} // namespace meridian
