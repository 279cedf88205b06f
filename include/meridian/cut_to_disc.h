// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_TO_DISC_H
#define MERIDIAN_CUT_TO_DISC_H

/// \file
/// Cuts a triangle mesh, any model of `FaceGraph`, into a disc; `build_refined_mesh()` gives the mesh with the cut.

#include <meridian/mesh/build_refined_mesh.h>
#include <meridian/mesh/cut_to_disc.h>

#endif // MERIDIAN_CUT_TO_DISC_H
