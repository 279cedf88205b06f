// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices that have their place in the texture.
#ifndef MERIDIAN_PROGRAM_PINS_H
#define MERIDIAN_PROGRAM_PINS_H

#include "unwrap_run.h"

#include <meridian/unwrap/pack_unwrappings.h>

#include <string>
#include <vector>

namespace meridian {
namespace program {

// Keeps seams out of the faces around pinned vertices.
void keep_out_of_pins(Unwrap_run& run);

// The pins of all meshes, where components are numbered through; those of vertices on seams are left out.
std::vector<Texture_pin> texture_pins(const std::vector<Unwrap_run>& runs);

// Pins that are not where they should be, a line for each kind.
std::vector<std::string> missed_pins(const Unwrap_run& run);

} // namespace program
} // namespace meridian

#endif // MERIDIAN_PROGRAM_PINS_H
