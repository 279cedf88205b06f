// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_FIELD_H
#define MERIDIAN_FIELD_FIELD_H

#include <meridian/base/choices.h>
#include <meridian/base/names.h>
#include <meridian/base/vectors.h>
#include <meridian/field/critical_points.h>
#include <meridian/field/edge_weights.h>
#include <meridian/surface/Triangle_surface.h>

#include <array>
#include <string>
#include <variant>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianOrder
/// where a harmonic field is lowest and highest, if no vertices are named.
enum class Extrema
{
  DISTANT, ///< at two vertices far apart
  CURVED   ///< at extrema of eigenfunctions, where the surface is strongly curved (\cite patane2007, section 2.1)
};

/// the names of `Extrema`.
template <> struct Names<Extrema>
{
  static constexpr std::array<Named_value<Extrema>, 2> table{{
    {Extrema::DISTANT, "distant", "two vertices far apart"},
    {Extrema::CURVED, "curved", "extrema of eigenfunctions with the highest curvature"},
  }};
};

/// \ingroup PkgMeridianOrder
/// the field that is harmonic between minima and maxima, where it is 0 and 1.
struct Harmonic_field
{
  /// its name in reports and options
  static constexpr Choice_name names{"harmonic", "between two extrema"};
  Weights weights = Weights::POSITIVE; ///< how the Laplacian is discretized
  Extrema extrema = Extrema::DISTANT;  ///< where it is 0 and 1, if no minima and maxima are chosen
};

/// \ingroup PkgMeridianOrder
/// an eigenfunction of the Laplacian.
struct Eigenfunction_field
{
  /// its name in reports and options
  static constexpr Choice_name names{"eigenfunction", "of the Laplacian"};
  int number = 0;                      ///< which one, from 1; 0: the genus + 1, as the paper takes
  Weights weights = Weights::POSITIVE; ///< how the Laplacian is discretized
};

/// \ingroup PkgMeridianOrder
/// the geodesic distance from a vertex.
struct Distance_field
{
  /// its name in reports and options
  static constexpr Choice_name names{"distance", "the geodesic distance from a vertex"};
  Index source = -1; ///< -1: a vertex far out
};

/// \ingroup PkgMeridianOrder
/// a field that is given, one value a vertex. A boundary loop takes the mean of its vertices.
struct Given_field
{
  std::vector<double> values; ///< one a vertex, finite
  std::string name = "given"; ///< for reports
};

/// \ingroup PkgMeridianOrder
/// a field, with what one may choose about it.
using Field = std::variant<Harmonic_field, Eigenfunction_field, Distance_field, Given_field>;

/// \ingroup PkgMeridianOrder
/// vertices of the surface that are the field's minima and maxima: where a harmonic field is 0 and 1, and which of its
/// own extrema another field keeps. Both empty: those of the field.
struct Chosen_extrema
{
  std::vector<Index> minima = {}; ///< the minima
  std::vector<Index> maxima = {}; ///< the maxima
};

/// \ingroup PkgMeridianOrder
/// what one may choose about a field. Vertices are those of the surface.
struct Field_options : Chosen_extrema
{
  Field field; ///< which field
};

/// \ingroup PkgMeridianOrder
/// \param field a field
/// \returns the weights that it is solved for with; those of `Harmonic_field` where it is solved for without
Weights weights_of(const Field& field);

/// \ingroup PkgMeridianOrder
/// checks what was chosen about a field, whatever the surface is.
/// \param options the choices
/// \throws Invalid_input_error if one choice would be ignored because of another, or weights do not suit the field
void check(const Field_options& options);

/// \ingroup PkgMeridianOrder
/// checks what was chosen about a field of a surface.
/// \param s the surface
/// \param options the choices
/// \throws Invalid_input_error if choices do not go together, if there is no such vertex, if minima or maxima alone are
///   given, or if values are not one finite number a vertex
void check(const Triangle_surface& s, const Field_options& options);

/// \ingroup PkgMeridianOrder
/// what a field was, for whoever made something of it.
struct Field_summary
{
  std::string field_kind = "none";      ///< what it is called
  std::string solver;                   ///< how it was solved for, in a few words; empty if it was given
  std::vector<double> field;            ///< at the vertices of the surface; empty where no field was needed
  std::vector<Critical_point> critical; ///< of the closed model, as vertices of the surface or -1
  Critical_counts counts;               ///< of these
  int order_rounds = 0;                 ///< sweeps that simplified the order
  int flat_regions = 0;        ///< regions with values of their own, where those of the field are all but equal
  bool order_numbered = false; ///< whether an st-numbering replaced it, since sweeps did not end
};

} // namespace meridian

#endif // MERIDIAN_FIELD_FIELD_H
