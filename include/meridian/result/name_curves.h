// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_RESULT_NAME_CURVES_H
#define MERIDIAN_RESULT_NAME_CURVES_H

#include <meridian/base/Result_mesh.h>
#include <meridian/handles/Generators.h>
#include <meridian/handles/find_shortest_basis.h>
#include <meridian/result/internal/assemble_parts.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianResults
/// \returns the curves of all components as they are written: the pairs, numbered through, then all boundary loops
/// \param all the generators of each component
/// \param assembled their mesh
std::vector<Result_curve> name_curves(const std::vector<Generators>& all, const Assembled_result& assembled);

/// \ingroup PkgMeridianResults
/// \returns the loops of all components, numbered through, then all boundary loops
/// \param all the basis of each component
/// \param assembled their mesh
std::vector<Result_curve> name_curves(const std::vector<Homology_basis>& all, const Assembled_result& assembled);

} // namespace meridian

#endif // MERIDIAN_RESULT_NAME_CURVES_H
