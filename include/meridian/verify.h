// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_VERIFY_H
#define MERIDIAN_VERIFY_H

/// \file
/// Recounts results from meshes or plain arrays alone.

#include <meridian/mesh/verify.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/proof/verify_generators.h>
#include <meridian/proof/verify_unwrapping.h>

#endif // MERIDIAN_VERIFY_H
