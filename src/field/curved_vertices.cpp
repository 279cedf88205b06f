// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/curved_vertices.h>

#include <meridian/base/exceptions.h>
#include <meridian/surface/measures.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace meridian {

std::pair<Index, Index> find_curved_extrema(const Triangle_surface& s, const Closed_model& g, const Eigenfunctions& e)
{
  std::vector<char> is_minimum(g.number_of_nodes, 0), is_maximum(g.number_of_nodes, 0);
  for (std::size_t k = 1; k < e.functions.size(); ++k)
  {
    const auto& x = e.functions[k];
    for (Index a = 0; a < g.number_of_nodes; ++a)
    {
      bool low = true, high = true;
      for (Index i = g.begin[a]; i < g.begin[a + 1]; ++i)
      {
        const Index b = g.neighbor[i];
        if (b != a) { (std::make_pair(x[b], b) < std::make_pair(x[a], a) ? low : high) = false; }
      }
      if (low) { is_minimum[a] = 1; }
      if (high) { is_maximum[a] = 1; }
    }
  }
  const auto most_curved = [&](const std::vector<char>& is_candidate, Index other) {
    Index best = -1;
    double highest = -1;
    for (Index a = 0; a < g.number_of_nodes; ++a)
    {
      if (!is_candidate[a] || a == other) { continue; }
      const double bend = g.is_loop(a) ? 0 : std::abs(curvature(s, g.representative[a]).gaussian);
      if (!(bend > highest)) { continue; }
      highest = bend;
      best = a;
    }
    return best;
  };
  const Index low = most_curved(is_minimum, -1), high = most_curved(is_maximum, low);
  if (low < 0 || high < 0) { throw Internal_error("find_curved_extrema: the functions have no two extrema"); }
  return {low, high};
}

std::pair<Index, Index> find_curved_vertices(const Triangle_surface& s, int functions, Weights weights,
                                             Make_solver make_solver)
{
  const Closed_model g = make_closed_model(s);
  const auto e = internal::eigenfunctions_of(s, g, weights,
                                             std::min(functions, static_cast<int>(g.number_of_nodes) - 1), make_solver);
  const auto [a, b] = find_curved_extrema(s, g, e);
  return {g.representative[a], g.representative[b]};
}

} // namespace meridian
