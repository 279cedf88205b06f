// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_H
#define MERIDIAN_UNWRAP_H

/// \file
/// Gives a triangle mesh texture coordinates without flipped faces, or maps a disc into the plane.

#include <meridian/mesh/parameterize.h>
#include <meridian/mesh/unwrap.h>

#endif // MERIDIAN_UNWRAP_H
