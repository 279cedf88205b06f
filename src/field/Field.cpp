// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/Field.h>

#include <meridian/base/exceptions.h>
#include <meridian/surface/check_surface.h>

namespace meridian {

Weights weights_of(const Field& field)
{
  if (const auto* harmonic = std::get_if<Harmonic_field>(&field)) { return harmonic->weights; }
  if (const auto* eigenfunction = std::get_if<Eigenfunction_field>(&field)) { return eigenfunction->weights; }
  return Harmonic_field().weights;
}

void check(const Field_options& options)
{
  const auto* harmonic = std::get_if<Harmonic_field>(&options.field);
  const auto* eigenfunction = std::get_if<Eigenfunction_field>(&options.field);
  const bool is_curved = harmonic && harmonic->extrema == Extrema::CURVED;
  if (is_curved && (!options.minima.empty() || !options.maxima.empty()))
  {
    throw Invalid_input_error("extrema of high curvature are sought only where no minima and maxima are given");
  }
  if ((is_curved || eigenfunction) && weights_of(options.field) == Weights::MEAN_VALUE)
  {
    throw Invalid_input_error("eigenfunctions need symmetric weights; mean-value weights are not");
  }
  if (eigenfunction && eigenfunction->number < 0)
  {
    throw Invalid_input_error("there is no eigenfunction " + std::to_string(eigenfunction->number)
                              + "; they are counted from 1");
  }
}

void check(const Triangle_surface& s, const Field_options& options)
{
  check(options);
  check_vertices(s, options.minima, "the minima of a field");
  check_vertices(s, options.maxima, "the maxima of a field");
  if (options.minima.empty() != options.maxima.empty())
  {
    throw Invalid_input_error("minima and maxima of a field go together; give both or neither");
  }
  if (const auto* given = std::get_if<Given_field>(&options.field)) { check_values(s, given->values, "the field"); }
  const auto* distance = std::get_if<Distance_field>(&options.field);
  if (distance && distance->source != -1) { check_vertices(s, {distance->source}, "the vertex to begin at"); }
}

} // namespace meridian
