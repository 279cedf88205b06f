// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh_format.h"

#include "read_mesh.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace meridian {
namespace files {

std::string ending_of(const std::string& path)
{
  std::string name = path.substr(path.find_last_of("/\\") + 1);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (is_packed(name)) { name.resize(name.size() - 3); }
  const std::size_t dot = name.find_last_of('.');
  return dot == std::string::npos ? "" : name.substr(dot + 1);
}

std::optional<Mesh_format> format_of(const std::string& path) { return from_name<Mesh_format>(ending_of(path)); }

std::string list_formats(bool (*is_meant)(Mesh_format))
{
  std::vector<std::string> names;
  for (const Mesh_format f : all<Mesh_format>())
  {
    if (!is_meant(f)) { continue; }
    names.emplace_back(name_of(f));
    std::transform(names.back().begin(), names.back().end(), names.back().begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  }
  std::string list = names.front();
  for (std::size_t i = 1; i < names.size(); ++i) { list += (i + 1 < names.size() ? ", " : " or ") + names[i]; }
  return list;
}

} // namespace files
} // namespace meridian
