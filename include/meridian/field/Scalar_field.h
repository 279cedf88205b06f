// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_SCALAR_FIELD_H
#define MERIDIAN_FIELD_SCALAR_FIELD_H

#include <meridian/base/vectors.h>

#include <string>
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
  /// a scale: `x` in it means `offset + scale * x` in that of its parent.
  struct Region
  {
    Index parent = -1; ///< the region around it; -1 of the whole surface
    double offset = 0; ///< added
    double scale = 1;  ///< multiplied with
  };

  std::vector<double> value;                            ///< of each node, in the scale of its region
  std::vector<Index> region;                            ///< of each node; empty while there is only one
  std::vector<Region> regions = std::vector<Region>(1); ///< parents before what they hold
  std::string solver; ///< how the whole was solved for, in a few words; empty if it was given

  /// \param nodes how many; the field is 0
  explicit Scalar_field(Index nodes = 0) : value(nodes, 0) {}

  /// \param a a node \returns its region
  Index region_of(Index a) const { return region.empty() ? 0 : region[a]; }

  /// \param x a value \param from, to regions
  /// \returns the value of region `from` in the scale of region `to`
  double convert(double x, Index from, Index to) const;
  /// \param r a region \param a a node \returns its value in the scale of the region
  double value_in(Index r, Index a) const { return convert(value[a], region_of(a), r); }
  /// \param a a node \returns its value as the caller prescribed it
  double operator()(Index a) const { return regions[0].offset + regions[0].scale * value_in(0, a); }
};

} // namespace meridian

#endif // MERIDIAN_FIELD_SCALAR_FIELD_H
