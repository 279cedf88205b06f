// What the benchmarks of speed have in common.
#ifndef MERIDIAN_BENCHMARK_SUPPORT_H
#define MERIDIAN_BENCHMARK_SUPPORT_H

#include "support/sample_surfaces.h"

#include <meridian/surface/Triangle_surface.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

extern "C" void openblas_set_num_threads(int) __attribute__((weak));
extern "C" void omp_set_max_active_levels(int) __attribute__((weak));

// The yardstick with one thread, and memory kept as the program keeps it.
inline void set_up()
{
#ifdef M_ARENA_MAX
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_ARENA_MAX, 1);
#endif
  if (openblas_set_num_threads) { openblas_set_num_threads(1); }
  if (omp_set_max_active_levels) { omp_set_max_active_levels(0); }
}

// A plate with n x n holes, each unit side divided so that it has about the given number of faces.
inline meridian::Triangle_surface plate(int faces, int n)
{
  const int side = 2 * n + 1;
  const double units = 2. * (side * side - n * n) + 4. * n * n + 4. * side;
  const int k = std::max(1, static_cast<int>(std::ceil(std::sqrt(faces / units / 2))));
  auto s = sample::skin(
    {side, side, 1}, [](int i, int j, int) { return i % 2 == 0 || j % 2 == 0; }, k);
  return sample::noisy(std::move(s), 0.2 / k, 1);
}

inline double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

#endif // MERIDIAN_BENCHMARK_SUPPORT_H
