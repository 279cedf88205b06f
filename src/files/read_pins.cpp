// SPDX-License-Identifier: GPL-3.0-or-later
#include "read_pins.h"

#include "Scanner.h"

#include <set>

namespace meridian {
namespace files {

std::vector<Pin> read_pins(const std::string& path, std::size_t vertices)
{
  const std::string bytes = read_bytes(path);
  Scanner in(bytes, path.c_str(), '#');
  std::vector<Pin> pins;
  std::set<Index> known;
  while (!in.at_end())
  {
    Pin& pin = pins.emplace_back(Pin{vertex_in(in, vertices), {0, 0}});
    for (double& x : pin.at)
    {
      if (in.at_line_end()) { in.fail("a pin is a vertex and two coordinates"); }
      x = in.real("a coordinate");
      if (!(x >= 0 && x <= 1)) { in.fail("coordinates of pins are from 0 to 1"); }
    }
    if (!in.at_line_end()) { in.fail("a pin is a vertex and two coordinates, and there is more"); }
    if (!known.insert(pin.vertex).second) { in.fail("vertex " + std::to_string(pin.vertex) + " is pinned twice"); }
  }
  if (pins.empty()) { throw File_error(path + ": there are no pins in it"); }
  return pins;
}

} // namespace files
} // namespace meridian
