// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_SCALAR_FIELD_H
#define MERIDIAN_FIELD_SCALAR_FIELD_H

#include <meridian/base/vectors.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianOrder
/// a function on the nodes of a closed model that keeps its digits where it is nearly constant.
///
/// A value stands in the scale of the region of its node. Region 0 is the whole surface; a flat region lies in its
/// parent, and a value `x` in it means `offset + scale * x` there. So differences far below the rounding of the whole
/// field are still told apart.
struct Scalar_field
{
  struct Region
  {
    Index parent = -1;
    double offset = 0, scale = 1;
  };

  std::vector<double> value;
  std::vector<Index> region; ///< of each node; empty while there is only one
  std::vector<Region> regions = std::vector<Region>(1);

  explicit Scalar_field(Index nodes = 0) : value(nodes, 0) {}

  Index region_of(Index a) const { return region.empty() ? 0 : region[a]; }

  /// \returns a value of region `from` in the scale of region `to`
  double convert(double x, Index from, Index to) const;
  /// \returns the value at node `a` in the scale of region `r`
  double value_in(Index r, Index a) const { return convert(value[a], region_of(a), r); }
  /// \returns the value at node `a` as the caller prescribed it
  double operator()(Index a) const { return regions[0].offset + regions[0].scale * value_in(0, a); }
};

} // namespace meridian

#endif // MERIDIAN_FIELD_SCALAR_FIELD_H
