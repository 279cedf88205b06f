// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/solve_harmonic_field.h>

#include <meridian/field/Laplace_system.h>
#include <meridian/field/internal/flat_regions.h>

#include <algorithm>

namespace meridian {

Scalar_field solve_harmonic_field(const Triangle_surface& s, const Closed_model& g, const Closed_model& joined,
                                  const std::vector<double>& weights, const std::vector<Dirichlet_value>& prescribed,
                                  Make_solver make_solver)
{
  Scalar_field field(g.number_of_nodes);
  std::vector<char> is_prescribed(g.number_of_nodes, 0);
  double lowest = prescribed.front().value, highest = lowest;
  for (const auto& p : prescribed)
  {
    is_prescribed[p.node] = 1;
    lowest = std::min(lowest, p.value);
    highest = std::max(highest, p.value);
  }
  // The whole is solved between 0 and 1, like every flat region after it.
  Scalar_field::Region& whole = field.regions.front();
  whole.scale = highest > lowest ? highest - lowest : 1;
  whole.offset = lowest;
  for (const auto& p : prescribed) { field.value[p.node] = (p.value - whole.offset) / whole.scale; }

  std::vector<Index> unknown;
  for (Index a = 0; a < g.number_of_nodes; ++a)
  {
    if (!is_prescribed[a]) { unknown.push_back(a); }
  }
  internal::Laplace_system system(joined, weights, make_solver);
  system.solve(
    unknown, [&](Index a) { return field.value[a]; }, field.value);
  field.solver = system.description();
  if (highest > lowest) { internal::solve_flat_regions(s, g, system, unknown, field); }
  return field;
}

} // namespace meridian
