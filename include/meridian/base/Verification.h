// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_BASE_VERIFICATION_H
#define MERIDIAN_BASE_VERIFICATION_H

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianVerification
/// what was counted on one component of the input and of the result.
struct Component_count
{
  int vertices = 0;                   ///< of the input
  int edges = 0;                      ///< of the input, polygons divided into triangles
  int faces = 0;                      ///< of the input, polygons divided into triangles
  int euler_characteristic = 0;       ///< of the input
  int boundary_loops = 0;             ///< of the input
  int genus = 0;                      ///< of the input, its boundary loops filled
  int discs = 0;                      ///< components of the result that it became
  int disc_euler_characteristic = 0;  ///< of those together
  int disc_boundary_loops = 0;        ///< of those together
  int glued_euler_characteristic = 0; ///< after the seams are glued
  int glued_boundary_loops = 0;       ///< after the seams are glued
};

/// \ingroup PkgMeridianVerification
/// what was found; a failed check is a result, not an error.
struct Verification
{
  std::vector<Component_count> components; ///< one a component of the input
  std::vector<std::string> failures;       ///< each names a defect, counts it and gives the first elements
  /// \returns whether no check failed
  explicit operator bool() const { return failures.empty(); }
};

/// \ingroup PkgMeridianVerification
/// what was counted about curves on one component.
struct Curve_count
{
  int pairs = 0;          ///< of a meridian and a longitude
  int boundary_loops = 0; ///< of the component
  /// the intersection matrix of the curves in the order meridian, longitude, meridian, ...: its entries that are not
  /// zero
  std::map<std::pair<int, int>, int> intersections;
  bool is_symplectic = false; ///< whether it is the standard symplectic matrix
  /// whether the curves, with all boundary loops but one, are a basis of the first homology over the integers
  bool is_basis = false;
};

/// \ingroup PkgMeridianVerification
/// what was found about generators.
struct Generator_verification : Verification
{
  std::vector<Curve_count> curves; /**< one a component */
};

} // namespace meridian

#endif // MERIDIAN_BASE_VERIFICATION_H
