// SPDX-License-Identifier: GPL-3.0-or-later
// Included before all else in a copy of the project that has faults in it.
#ifndef MERIDIAN_TEST_PLANTED_H
#define MERIDIAN_TEST_PLANTED_H

#include <cstdlib>

// Whether the fault of this number is the one that is tried.
inline bool planted(int number)
{
  static const int chosen = std::getenv("MERIDIAN_FAULT") ? std::atoi(std::getenv("MERIDIAN_FAULT")) : 0;
  return chosen == number;
}

#endif // MERIDIAN_TEST_PLANTED_H
