// SPDX-License-Identifier: GPL-3.0-or-later
#include "read_result.h"

#include "read_mesh.h"
#include "write_mesh.h"
#include "write_texture.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Result_mesh.h>

namespace meridian {
namespace files {

Result_files read_result(const std::string& path)
{
  Result_files result;
  std::vector<Result_curve> fields;
  result.kind = read_map(find_map(path), result.mesh, fields);
  if (result.kind == Result_kind::UNWRAPPING)
  {
    read_unwrapped(path, result.mesh, result.texture, result.vertex_of, result.vertices);
    return result;
  }
  const Polygon_soup opened = read_mesh(path);
  result.mesh.points = opened.points;
  for (std::size_t i = 0; i < opened.number_of_polygons(); ++i)
  {
    if (opened.size(i) != 3)
      throw File_error(path + ": face " + std::to_string(i) + " has " + std::to_string(opened.size(i))
                       + " corners; results have triangles only");
    result.mesh.faces.push_back({opened.corner(i, 0), opened.corner(i, 1), opened.corner(i, 2)});
  }
  if (result.kind == Result_kind::GENERATORS)
  {
    result.curves = read_curves(path);
    for (Result_curve& c : result.curves)
      for (const Result_curve& f : fields)
      {
        if (f.name == c.name) { c.field = f.field; }
      }
  }
  return result;
}

} // namespace files
} // namespace meridian
