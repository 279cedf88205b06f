// SPDX-License-Identifier: GPL-3.0-or-later
#include "read_values.h"

#include "Scanner.h"

#include <cmath>

namespace meridian {
namespace files {

std::vector<double> read_values(const std::string& path, std::size_t count)
{
  const std::string bytes = read_bytes(path);
  Scanner scanner(bytes, path.c_str(), '#');
  std::vector<double> values;
  while (!scanner.at_end())
  {
    values.push_back(scanner.real("a number"));
    if (!std::isfinite(values.back()))
    {
      scanner.fail("value " + std::to_string(values.size() - 1) + " is not finite");
    }
  }
  if (values.size() != count)
    throw File_error(path + ": it has " + std::to_string(values.size()) + " numbers, and the mesh has "
                     + std::to_string(count) + " vertices; it needs one a vertex");
  return values;
}

} // namespace files
} // namespace meridian
