// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_TWO_POINT_FIELDS_H
#define MERIDIAN_FIELD_TWO_POINT_FIELDS_H

#include <meridian/base/vectors.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/surface/Triangle_surface.h>

#include <memory>

namespace meridian {

namespace internal {

// Harmonic fields with one minimum and one maximum on one surface, by back-substitution: with one node pinned and
// factored once, each is an affine function of the solution for a unit source at the one and a unit sink at the other.
class Two_point_fields
{
public:
  Two_point_fields(const Triangle_surface& root, Make_solver make_solver);
  Two_point_fields(Triangle_surface&& root, Make_solver make_solver) = delete;

  // False if the two are one node or the system cannot be solved.
  bool order(Index low, Index high, Ordered_surface& m);

private:
  Ordered_surface m_base;
  const Triangle_surface& m_root;
  std::unique_ptr<Sparse_solver> m_solver;
  bool m_is_factored = false;
};

} // namespace internal

} // namespace meridian

#endif // MERIDIAN_FIELD_TWO_POINT_FIELDS_H
