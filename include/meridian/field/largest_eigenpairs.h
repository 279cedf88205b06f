// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_LARGEST_EIGENPAIRS_H
#define MERIDIAN_FIELD_LARGEST_EIGENPAIRS_H

#include <meridian/base/vectors.h>

#include <functional>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianOrder
/// eigenvalues of a symmetric operation, the largest first, and their unit vectors.
struct Eigenpairs
{
  std::vector<double> values;               ///< the largest first
  std::vector<std::vector<double>> vectors; ///< of each value, of length 1
};

/*!
 * \ingroup PkgMeridianOrder
 *
 * finds eigenvalues of largest magnitude of a symmetric operation by the Lanczos method with implicit restarts, from a
 * fixed vector (Spectra; \cite calvetti1994). Where eigenvalues coincide some may be missed.
 *
 * \param n the dimension
 * \param operation writes the image of the vector of `n` values at `in` to `out`
 * \param count how many to find, less than `n`
 * \param subspace vectors that are kept, more than `count` and at most `n`
 * \param restarts the most of them
 * \param tolerance of an eigenvalue, relative
 * \returns nothing if the iteration did not converge
 * \throws Solver_error what the operation throws of it
 * \par Complexity
 * `subspace` operations at a start, less at each restart, and \f$ O(n \cdot \mathrm{subspace}^2) \f$ beside them
 */
Eigenpairs largest_eigenpairs(Index n, const std::function<void(const double* in, double* out)>& operation, Index count,
                              Index subspace, Index restarts, double tolerance);

} // namespace meridian

#endif // MERIDIAN_FIELD_LARGEST_EIGENPAIRS_H
