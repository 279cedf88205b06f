// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_GENERATORS_H
#define MERIDIAN_GENERATORS_H

/// \file
/// Finds meridians and longitudes, or short bases of homology, of a triangle mesh; tightens and classifies loops.

#include <meridian/mesh/generators.h>
#include <meridian/mesh/handle_or_tunnel.h>
#include <meridian/mesh/shortest_basis.h>
#include <meridian/mesh/tighten.h>

#endif // MERIDIAN_GENERATORS_H
