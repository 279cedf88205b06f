// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "files/Output_files.h"
#include "files/write_mesh.h"
#include "files/write_texture.h"
#include "report.h"

#include <meridian/verify_unwrapping.h>

#include <iostream>

namespace meridian {
namespace program {

namespace {

// The triangles of a result whose file holds vertices and faces alone.
void read_triangles(const std::string& path, Result_mesh& result)
{
  const Polygon_soup opened = files::read_mesh(path);
  result.points = opened.points;
  for (std::size_t i = 0; i < opened.number_of_polygons(); ++i)
  {
    if (opened.size(i) != 3) { throw files::File_error(path + ": face " + std::to_string(i) + " has " + std::to_string(opened.size(i)) + " corners; results have triangles only"); }
    result.faces.push_back({opened.corner(i, 0), opened.corner(i, 1), opened.corner(i, 2)});
  }
}

Verification verify_texture(const std::string& path, const Polygon_soup& input, Result_mesh& result)
{
  std::vector<std::array<double, 2>> texture;
  std::vector<std::int32_t> vertex_of;
  std::int32_t vertices = 0;
  files::read_unwrapped(path, result, texture, vertex_of, vertices);
  Verification v = verify_unwrapping(input, result, texture);
  // Texture coordinates stand in the order of the vertices, those of copies after them.
  std::vector<std::int32_t> misplaced;
  for (std::size_t i = 0; i < vertex_of.size(); ++i)
  {
    const std::int32_t copied = i < result.copy_of.size() ? result.copy_of[i] : -1, expected = copied < 0 ? static_cast<std::int32_t>(i) : copied;
    if (vertex_of[i] != expected) { misplaced.push_back(static_cast<std::int32_t>(i)); }
  }
  if (!misplaced.empty()) { v.failures.push_back(internal::list_elements("texture coordinates belong to the wrong vertex", misplaced)); }
  return v;
}

} // namespace

int run_verify(const Verify_arguments& arguments)
{
  const Polygon_soup input = files::read_mesh(arguments.mesh);
  Result_mesh result;
  std::vector<Result_curve> fields;
  const files::Result_kind kind = files::read_map(files::map_path(arguments.result), result, fields);
  Generator_verification v;
  if (kind == files::Result_kind::UNWRAPPING) { static_cast<Verification&>(v) = verify_texture(arguments.result, input, result); }
  else { read_triangles(arguments.result, result); }
  if (kind == files::Result_kind::GENERATORS)
  {
    std::vector<Result_curve> curves = files::read_curves(arguments.result);
    for (Result_curve& c : curves)
      for (const Result_curve& f : fields) { if (f.name == c.name) { c.field = f.field; } }
    v = verify_generators(input, result, curves);
  }
  if (kind == files::Result_kind::CUT) { static_cast<Verification&>(v) = verify_cut(input, result); }

  Json components = Json::array();
  std::int64_t genus = 0, loops = 0, discs = 0;
  for (std::size_t i = 0; i < v.components.size(); ++i)
  {
    const Component_count& c = v.components[i];
    Json r = report_counts(c);
    if (kind != files::Result_kind::GENERATORS)
      r["cut"] = {{"connected", c.discs == 1}, {"euler_characteristic", c.disc_euler_characteristic}, {"boundary_loops", c.disc_boundary_loops}};
    else if (i < v.curves.size())
    {
      r["intersection_matrix"] = report_intersections(v.curves[i]);
      r["is_basis"] = v.curves[i].is_basis;
    }
    components.push_back(r);
    genus += c.genus;
    loops += c.boundary_loops;
    discs += c.discs;
  }
  if (!arguments.report.empty())
  {
    files::Output_files out;
    out.add(arguments.report, format_report({{"meridian", MERIDIAN_VERSION}, {"input", {{"file", arguments.mesh}, {"vertices", input.points.size()}}},
                                             {"components", components}, {"failures", v.failures}, {"verified", static_cast<bool>(v)}}));
    out.commit();
  }
  for (const std::string& failure : v.failures) { std::cerr << "meridian: " << failure << '\n'; }
  if (!arguments.quiet)
  {
    std::cout << (v ? "verified: " : "NOT verified: ") << v.components.size() << (v.components.size() == 1 ? " component" : " components") << " (genus "
              << genus << ", boundary loops " << loops << ")";
    if (kind != files::Result_kind::GENERATORS)
    {
      std::cout << " became " << discs << (discs == 1 ? " piece" : " pieces");
      if (v) { std::cout << ", each a disc; glued along " << result.seams.size() << " seam edges they are the input again"; }
      if (v && kind == files::Result_kind::UNWRAPPING) { std::cout << "; no face is turned over in the plane"; }
    }
    else if (v) { std::cout << ", with a basis of first homology on each"; }
    std::cout << '\n';
  }
  return v ? VERIFIED : NOT_VERIFIED;
}

} // namespace program
} // namespace meridian
