// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_GENERATORS_H
#define MERIDIAN_GENERATORS_H

/// \file
/// Finds meridians and longitudes, or short bases of homology, of a triangle mesh; tightens and classifies loops.

#include <meridian/mesh/generators.h>

#endif // MERIDIAN_GENERATORS_H
