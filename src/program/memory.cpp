// SPDX-License-Identifier: GPL-3.0-or-later
#include "memory.h"

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

namespace meridian {
namespace program {

void keep_memory()
{
#ifdef M_ARENA_MAX
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_ARENA_MAX, 1); // what one thread gave back serves the other
#endif
}

void give_back_largest()
{
#ifdef M_ARENA_MAX
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_MMAP_MAX, 1 << 16);
#endif
}

void give_back_memory()
{
#ifdef M_ARENA_MAX
  malloc_trim(0);
#endif
}

} // namespace program
} // namespace meridian
