// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIND_GENERATORS_H
#define MERIDIAN_FIND_GENERATORS_H

/// \file
/// Finds a meridian and a longitude around each handle of a triangle mesh.

#include <meridian/mesh/find_generators.h>

#endif // MERIDIAN_FIND_GENERATORS_H
