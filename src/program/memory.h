// SPDX-License-Identifier: GPL-3.0-or-later
// What the program asks of the allocator, where that can be asked.
#ifndef MERIDIAN_MEMORY_H
#define MERIDIAN_MEMORY_H

namespace meridian {
namespace program {

// Arrays are taken again and again: memory that is given back to the system each time costs up to half of a run. So it
// is kept.
void keep_memory();

// Takes the memory in which OpenBLAS works, where that is the BLAS of this system, while there is some: it asks for it
// at its first call, again and again for ever if there is none. Throws std::bad_alloc.
void reserve_memory_of_blas();

// From here on the largest arrays go back by themselves: where each is taken once, the gaps that they leave would be
// the largest.
void give_back_largest();

// Gives back the gaps between arrays: where one part of a run is over, and the next needs arrays of other sizes.
void give_back_memory();

} // namespace program
} // namespace meridian

#endif // MERIDIAN_MEMORY_H
