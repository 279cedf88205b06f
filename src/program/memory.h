// SPDX-License-Identifier: GPL-3.0-or-later
// What the program asks of the allocator, where that can be asked.
#ifndef MERIDIAN_MEMORY_H
#define MERIDIAN_MEMORY_H

#include <cstdint>

namespace meridian {
namespace program {

// What is said when there is none left.
extern const char* const not_enough_memory;

// Arrays are taken again and again: memory that is given back to the system each time costs up to half of a run. So it
// is kept.
void keep_memory();

// Lets the run take so many bytes and no more, where the system can limit them: std::bad_alloc is thrown, then.
void limit_memory(std::uint64_t bytes);

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
