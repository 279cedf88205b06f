// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_INTERNAL_FLAT_REGIONS_H
#define MERIDIAN_FIELD_INTERNAL_FLAT_REGIONS_H

#include <meridian/base/vectors.h>
#include <meridian/field/Laplace_system.h>
#include <meridian/field/Scalar_field.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {
namespace internal {

// Euler's characteristic of the faces around a set of nodes, in the closed model.
Index characteristic_around(const Triangle_surface& s, const Closed_model& g, const std::vector<Index>& nodes);

// Solves again, in a scale of its own, wherever the field is flat to rounding and the flat region is not a disc.
// Values of a region lie in [-1, 1]; a node is flat if no neighbour differs by more than `flat`. Neighbours are those
// of the system, which may join the nodes by other edges than the surface does.
void solve_flat_regions(const Triangle_surface& s, const Closed_model& g, Laplace_system& system,
                        std::vector<Index> nodes, Scalar_field& field);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_FIELD_INTERNAL_FLAT_REGIONS_H
