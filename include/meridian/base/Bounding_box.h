// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_BASE_BOUNDING_BOX_H
#define MERIDIAN_BASE_BOUNDING_BOX_H

#include <meridian/base/vectors.h>

#include <algorithm>
#include <cstddef>

namespace meridian {

/// \ingroup PkgMeridianSurface
/// the smallest box with sides along the axes that holds some points.
template <class Vector> struct Bounding_box
{
  Vector low;  ///< the least coordinates
  Vector high; ///< the greatest coordinates

  /// \param p the first point
  explicit Bounding_box(const Vector& p) : low(p), high(p) {}

  /// \param p a point that the box grows to hold
  void add(const Vector& p)
  {
    for (std::size_t k = 0; k < low.size(); ++k)
    {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
};

} // namespace meridian

#endif // MERIDIAN_BASE_BOUNDING_BOX_H
