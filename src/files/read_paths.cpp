// SPDX-License-Identifier: GPL-3.0-or-later
#include "read_paths.h"

#include "Scanner.h"

namespace meridian {
namespace files {

std::vector<std::vector<Index>> read_paths(const std::string& path, std::size_t vertices)
{
  const std::string bytes = read_bytes(path);
  Scanner in(bytes, path.c_str(), '#');
  std::vector<std::vector<Index>> paths;
  while (!in.at_end())
  {
    auto& vertices_of_path = paths.emplace_back();
    while (!in.at_line_end()) { vertices_of_path.push_back(vertex_in(in, vertices)); }
    if (vertices_of_path.size() < 2) { in.fail("a path of one vertex; a seam runs from a vertex to another at least"); }
  }
  if (paths.empty()) { throw File_error(path + ": there are no paths in it"); }
  return paths;
}

} // namespace files
} // namespace meridian
