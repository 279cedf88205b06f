// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/eigenfunctions.h>

#include "shifted_laplacian.h"
#include <meridian/base/exceptions.h>
#include <meridian/field/intrinsic_delaunay.h>
#include <meridian/field/largest_eigenpairs.h>
#include <meridian/surface/measures.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

namespace {

using Eigenpair = std::pair<double, Eigen::VectorXd>;

bool has_lower_value(const Eigenpair& a, const Eigenpair& b) { return a.first < b.first; }

// Appends the `count` highest eigenpairs on the complement of what was found, and excludes them. Returns whether the
// iteration converged.
bool append_eigenpairs(Shifted_laplacian& laplacian, Index n, Index count, std::vector<Eigenpair>& found)
{
  Index subspace = std::min(n, std::max<Index>(2 * count + 10, 24));
  for (int attempt = 0; attempt < 3; ++attempt, subspace = std::min(n, 2 * subspace))
  {
    const Eigenpairs pairs = largest_eigenpairs(
      n, [&](const double* in, double* out) { laplacian.perform_op(in, out); }, count, subspace, 200, 1e-10);
    if (pairs.values.empty()) { continue; }
    for (Index i = 0; i < count; ++i)
    {
      const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(pairs.vectors[i].data(), n);
      found.emplace_back(1 / pairs.values[i] - Shifted_laplacian::shift, x);
      laplacian.exclude(x);
    }
    return true;
  }
  return false;
}

// The `k` lowest eigenpairs, ascending. Where eigenvalues coincide the iteration might miss some: it starts again until
// nothing lower is left.
std::vector<Eigenpair> find_lowest(Shifted_laplacian& laplacian, Index n, int k)
{
  std::vector<Eigenpair> found;
  const auto search = [&](Index count) {
    if (!append_eigenpairs(laplacian, n, count, found))
      throw Solver_error("the iteration for " + std::to_string(k)
                         + " eigenfunctions did not converge; fewer functions or positive weights would help");
  };
  search(k);
  while (static_cast<Index>(found.size()) + 1 < n)
  {
    const double highest = std::max_element(found.begin(), found.end(), has_lower_value)->first;
    search(1);
    if (!(found.back().first < highest - 1e-7 * (highest + Shifted_laplacian::shift))) { break; } // nothing was missed
    std::stable_sort(found.begin(), found.end(), has_lower_value);
    found.pop_back();
  }
  std::stable_sort(found.begin(), found.end(), has_lower_value);
  found.resize(k);
  return found;
}

// Takes out of `x` what lies along the unit function `y`.
void remove_along(const std::vector<double>& mass, const std::vector<double>& y, std::vector<double>& x)
{
  double along = 0;
  for (std::size_t i = 0; i < x.size(); ++i) { along += mass[i] * x[i] * y[i]; }
  for (std::size_t i = 0; i < x.size(); ++i) { x[i] -= along * y[i]; }
}

// Brings a function to unit length, the first of its largest entries positive.
void scale_to_unit(const std::vector<double>& mass, std::vector<double>& x)
{
  double square = 0, largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) { square += mass[i] * x[i] * x[i]; }
  for (double& y : x) { y /= std::sqrt(square); }
  for (double y : x) { largest = std::max(largest, std::abs(y)); }
  const auto first = std::find_if(x.begin(), x.end(), [&](double y) { return std::abs(y) >= (1 - 1e-6) * largest; });
  if (first == x.end()) { throw Solver_error("an eigenfunction is not finite; positive weights are the safest"); }
  if (*first < 0)
  {
    for (double& y : x) { y = -y; }
  }
}

// Rayleigh's quotient of a unit function, which keeps the digits of small eigenvalues.
double energy_of(const Closed_model& g, const std::vector<double>& weights, const std::vector<double>& x)
{
  double energy = 0;
  for (Index a = 0; a < g.number_of_nodes; ++a)
    for (Index i = g.begin[a]; i < g.begin[a + 1]; ++i)
    {
      const double step = x[a] - x[g.neighbor[i]];
      energy += weights[g.halfedge[i]] * step * step / 2;
    }
  return std::max(energy, 0.);
}

} // namespace

} // namespace internal

Eigenfunctions find_eigenfunctions(const Closed_model& g, const std::vector<double>& weights,
                                   const std::vector<double>& mass, int k, Make_solver make_solver)
{
  const Index n = g.number_of_nodes;
  if (k < 1 || k >= n)
    throw Invalid_input_error("a closed model of " + std::to_string(n) + " nodes has no " + std::to_string(k)
                              + " eigenfunctions beside the constant one; ask for 1 to " + std::to_string(n - 1));
  internal::Shifted_laplacian laplacian(g, weights, mass, make_solver);
  const std::vector<internal::Eigenpair> found = internal::find_lowest(laplacian, n, k);

  Eigenfunctions e;
  e.values.push_back(0);
  e.functions.emplace_back(n, 1 / std::sqrt(laplacian.total_mass()));
  std::vector<std::pair<double, std::vector<double>>> pairs;
  for (const auto& [value, vector] : found)
  {
    std::vector<double> x = laplacian.function_of(vector);
    for (int pass = 0; pass < 2; ++pass) // once more against rounding
    {
      internal::remove_along(mass, e.functions.front(), x);
      for (const auto& p : pairs) { internal::remove_along(mass, p.second, x); }
      internal::scale_to_unit(mass, x);
    }
    const double energy = internal::energy_of(g, weights, x);
    pairs.emplace_back(energy, std::move(x));
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [value, x] : pairs)
  {
    e.values.push_back(value);
    e.functions.push_back(std::move(x));
  }
  return e;
}

std::vector<double> scaled_eigenfunction(const Eigenfunctions& e, int i)
{
  std::vector<double> f = e.functions[i];
  for (double& x : f) { x *= std::sqrt(e.values[i]); }
  return f;
}

namespace internal {

Eigenfunctions eigenfunctions_of(const Triangle_surface& s, const Closed_model& g, Weights weights, int k,
                                 Make_solver make_solver)
{
  if (weights == Weights::MEAN_VALUE)
    throw Invalid_input_error("eigenfunctions need symmetric weights; mean-value weights are not: take positive, "
                              "cotangent or intrinsic Delaunay weights");
  const std::vector<double> mass = node_areas(s, g);
  if (weights != Weights::INTRINSIC_DELAUNAY)
  {
    return find_eigenfunctions(g, edge_weights(s, weights), mass, k, make_solver);
  }
  const Weighted_graph joined = make_intrinsic_delaunay_graph(s);
  return find_eigenfunctions(joined.graph, joined.weights, mass, k, make_solver);
}

} // namespace internal

Eigenfunctions eigenfunctions_at_vertices(const Triangle_surface& s, int k, Weights weights, Make_solver make_solver)
{
  const Closed_model g = make_closed_model(s);
  Eigenfunctions found = internal::eigenfunctions_of(s, g, weights, k, make_solver);
  found.values.erase(found.values.begin());
  found.functions.erase(found.functions.begin());
  for (std::vector<double>& function : found.functions)
  {
    std::vector<double> at_vertices;
    for (Index a : g.node) { at_vertices.push_back(function[a]); }
    function = std::move(at_vertices);
  }
  return found;
}

std::vector<double> eigenfunction_field(const Triangle_surface& s, int i, Weights weights, Make_solver make_solver)
{
  const Closed_model g = make_closed_model(s);
  if (i < 1 || i >= g.number_of_nodes)
    throw Invalid_input_error("there is no eigenfunction " + std::to_string(i) + " of a surface of "
                              + std::to_string(g.number_of_nodes) + " nodes; count from 1");
  const auto values = scaled_eigenfunction(internal::eigenfunctions_of(s, g, weights, i, make_solver), i);
  std::vector<double> field;
  for (Index a : g.node) { field.push_back(values[a]); }
  return field;
}

} // namespace meridian
