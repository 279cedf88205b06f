// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/solve_field.h>

#include <meridian/base/vectors.h>
#include <meridian/field/eigenfunctions.h>
#include <meridian/field/geodesic_distance.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/measures.h>

#include <string>

namespace meridian {

namespace {

Given_field solve(const Triangle_surface&, const Harmonic_field&, const Solvers&)
{
  return {{}, Harmonic_field::names.name};
}

Given_field solve(const Triangle_surface& s, const Eigenfunction_field& field, const Solvers& solvers)
{
  const int number = field.number > 0 ? field.number : genus(s) + 1;
  return {eigenfunction_field(s, number, field.weights, solvers.symmetric),
          Eigenfunction_field::names.name + (' ' + std::to_string(number))};
}

Given_field solve(const Triangle_surface& s, const Distance_field& field, const Solvers& solvers)
{
  Index source = field.source;
  if (source < 0)
  {
    const Closed_model g = make_closed_model(s);
    source = g.representative[find_distant_nodes(s, g).first];
  }
  return {geodesic_distance(s, {source}, solvers.symmetric), Distance_field::names.name};
}

Given_field solve(const Triangle_surface&, const Given_field& field, const Solvers&) { return field; }

} // namespace

Given_field solve_field(const Triangle_surface& s, const Field& field, const Solvers& solvers)
{
  return std::visit([&](const auto& f) { return solve(s, f, solvers); }, field);
}

} // namespace meridian
