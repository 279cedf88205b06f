// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_TO_DISC_H
#define MERIDIAN_CUT_TO_DISC_H

/// \file
/// Cuts a triangle mesh, any model of `FaceGraph`, into a disc.

#include <meridian/mesh/cut_to_disc.h>
#include <meridian/mesh/open_along.h>

#endif // MERIDIAN_CUT_TO_DISC_H
