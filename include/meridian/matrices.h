// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MATRICES_H
#define MERIDIAN_MATRICES_H

/// \file
/// Surfaces from Eigen matrices, and cuts and texture coordinates as such, as libigl has them.

#include <meridian/mesh/matrices.h>

#endif // MERIDIAN_MATRICES_H
