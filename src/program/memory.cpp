// SPDX-License-Identifier: GPL-3.0-or-later
#include "memory.h"

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif
#include <sys/mman.h>
#include <sys/resource.h>

#include <algorithm>
#include <new>
#include <vector>

extern "C" void openblas_set_num_threads(int) __attribute__((weak));
extern "C" void dgemm_(const char*, const char*, const int*, const int*, const int*, const double*, const double*,
                       const int*, const double*, const int*, const double*, double*, const int*) __attribute__((weak));

namespace meridian {
namespace program {

const char* const not_enough_memory =
  "there is not enough memory for this mesh, or --max-memory allows less than it takes";

void keep_memory()
{
#ifdef M_ARENA_MAX
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_ARENA_MAX, 1); // what one thread gave back serves the other
#endif
}

void limit_memory(std::uint64_t bytes)
{
  rlimit limit{};
  if (getrlimit(RLIMIT_DATA, &limit) != 0) { return; }
  limit.rlim_cur = std::min<rlim_t>(bytes, limit.rlim_max);
  setrlimit(RLIMIT_DATA, &limit);
}

void reserve_memory_of_blas()
{
  if (!openblas_set_num_threads || !dgemm_) { return; }
  constexpr std::size_t size = 160 << 20; // more than it asks for
  void* const trial = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (trial == MAP_FAILED) { throw std::bad_alloc(); }
  munmap(trial, size);
  constexpr int n = 128; // not so few that it does without
  constexpr double one = 1, zero = 0;
  const std::vector<double> a(n * n, 0);
  std::vector<double> product(n * n, 0);
  dgemm_("N", "N", &n, &n, &n, &one, a.data(), &n, a.data(), &n, &zero, product.data(), &n);
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
