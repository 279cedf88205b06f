// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_BASE_RUN_BOTH_H
#define MERIDIAN_BASE_RUN_BOTH_H

#include <future>

namespace meridian {
namespace internal {

// Calls two functions side by side, or one after the other where there is no second thread to have. Returns when both
// have; what one of them throws is thrown here.
template <class First, class Second> void run_both(const First& first, const Second& second)
{
  auto other = std::async(first);
  second();
  other.get();
}

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_BASE_RUN_BOTH_H
