// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_RESULT_ASSEMBLED_RESULT_H
#define MERIDIAN_RESULT_ASSEMBLED_RESULT_H

#include <meridian/base/Result_mesh.h>
#include <meridian/base/vectors.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianResults
/// a result, and where the vertices of each component stand in it.
struct Assembled_result
{
  Result_mesh mesh; ///< of all components
  /// for each component, of each vertex of its refined surface, and then of each copy
  std::vector<std::vector<Index>> place;
};

} // namespace meridian

#endif // MERIDIAN_RESULT_ASSEMBLED_RESULT_H
