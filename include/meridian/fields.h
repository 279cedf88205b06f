// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELDS_H
#define MERIDIAN_FIELDS_H

/// \file
/// Solves for fields on a triangle mesh, and finds their critical points and flow lines.

#include <meridian/mesh/critical_points.h>
#include <meridian/mesh/eigenfunctions.h>
#include <meridian/mesh/geodesic_distance.h>
#include <meridian/mesh/harmonic_field.h>
#include <meridian/mesh/morse_complex.h>

#endif // MERIDIAN_FIELDS_H
