// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_BASE_LIST_ELEMENTS_H
#define MERIDIAN_BASE_LIST_ELEMENTS_H

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace meridian {
namespace internal {

inline std::string to_text(std::int32_t i) { return std::to_string(i); }
inline std::string to_text(const std::pair<std::int32_t, std::int32_t>& edge)
{
  return std::to_string(edge.first) + "-" + std::to_string(edge.second);
}

// "7 edges with ... (first: 3-4, 3-9, ...)"
template <class Element> std::string list_elements(const char* what, const std::vector<Element>& elements)
{
  std::string text = std::to_string(elements.size()) + " " + what + " (first: ";
  const std::size_t shown = std::min<std::size_t>(elements.size(), 5);
  for (std::size_t i = 0; i < shown; ++i) { text += (i ? ", " : "") + to_text(elements[i]); }
  return text + (shown < elements.size() ? ", ...)" : ")");
}

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_BASE_LIST_ELEMENTS_H
