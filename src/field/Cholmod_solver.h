// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_CHOLMOD_SOLVER_H
#define MERIDIAN_FIELD_CHOLMOD_SOLVER_H

#include <meridian/field/Sparse_solver.h>

#include <memory>

namespace meridian {
namespace internal {

// CHOLMOD's supernodal Cholesky factorization with approximate minimum degree ordering. Where unknowns come in pairs
// with the same neighbours, as two coordinates of a point do, the pairs are ordered: a graph of half the nodes.
std::unique_ptr<Sparse_solver> make_cholmod_solver();

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_FIELD_CHOLMOD_SOLVER_H
