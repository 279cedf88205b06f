// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_paths.h"
#include "commands.h"
#include "files/Output_files.h"
#include "files/read_result.h"
#include "options.h"
#include "report_proof.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Verification.h>
#include <meridian/base/list_elements.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/proof/verify_generators.h>
#include <meridian/proof/verify_unwrapping.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

namespace meridian {
namespace program {

namespace {

Verification verify_texture(const Polygon_soup& input, const files::Result_files& result)
{
  constexpr int most_tiles = 100; // that have a number
  Verification v = verify_unwrapping(input, result.mesh, result.texture, 0, most_tiles);
  // Texture coordinates stand in the order of the vertices, those of copies after them.
  std::vector<std::int32_t> misplaced;
  for (std::size_t i = 0; i < result.vertex_of.size() && i < result.mesh.copy_of.size(); ++i)
  {
    const std::int32_t copied = result.mesh.copy_of[i];
    if (result.vertex_of[i] != (copied < 0 ? static_cast<std::int32_t>(i) : copied))
    {
      misplaced.push_back(static_cast<std::int32_t>(i));
    }
  }
  const auto expected = std::count_if(result.mesh.copy_of.begin(), result.mesh.copy_of.end(),
                                      [](std::int32_t copied) { return copied < 0; });
  if (result.vertices != expected)
    v.failures.push_back("the file has " + std::to_string(result.vertices) + " vertices, but the map has "
                         + std::to_string(expected) + " that are no copies");
  if (!misplaced.empty())
  {
    v.failures.push_back(internal::list_elements("texture coordinates belong to the wrong vertex", misplaced));
  }
  return v;
}

// The tiles of the texture up to the last that has a coordinate.
int number_of_tiles(const std::vector<Plane_point>& texture)
{
  constexpr int columns = 10;
  int last = 0;
  for (const Plane_point& p : texture)
  {
    const int column = std::max(static_cast<int>(std::ceil(p[0])), 1) - 1,
              row = std::max(static_cast<int>(std::ceil(p[1])), 1) - 1;
    last = std::max(last, columns * row + column);
  }
  return last + 1;
}

void print_summary(const Verification& v, const files::Result_files& result)
{
  std::int64_t genus = 0, loops = 0, discs = 0;
  for (const Component_count& c : v.components)
  {
    genus += c.genus;
    loops += c.boundary_loops;
    discs += c.discs;
  }
  std::cout << (v ? "verified: " : "NOT verified: ") << v.components.size()
            << (v.components.size() == 1 ? " component" : " components") << " (genus " << genus << ", boundary loops "
            << loops << ")";
  if (result.kind != files::Result_kind::GENERATORS)
  {
    std::cout << " became " << discs << (discs == 1 ? " piece" : " pieces");
    if (v)
    {
      std::cout << ", each a disc; glued along " << result.mesh.seams.size() << " seam edges they are the input again";
    }
    if (v && result.kind == files::Result_kind::UNWRAPPING)
    {
      std::cout << "; no face is turned over in the plane";
      const int tiles = number_of_tiles(result.texture);
      if (tiles > 1) { std::cout << ", which is " << tiles << " tiles"; }
    }
  }
  else if (v) { std::cout << ", with a basis of first homology on each"; }
  std::cout << '\n';
}

int run_verify(const Verify_arguments& arguments)
{
  std::vector<std::string> read = files_of_result(arguments.result);
  read.push_back(arguments.mesh);
  check_paths(read, {arguments.report});
  const Polygon_soup input = files::read_mesh(arguments.mesh);
  const files::Result_files result = files::read_result(arguments.result);
  const files::Result_kind kind = result.kind;
  Generator_verification v;
  switch (kind)
  {
  case files::Result_kind::CUT: static_cast<Verification&>(v) = verify_cut(input, result.mesh); break;
  case files::Result_kind::GENERATORS: v = verify_generators(input, result.mesh, result.curves); break;
  case files::Result_kind::UNWRAPPING: static_cast<Verification&>(v) = verify_texture(input, result); break;
  }

  Json components = Json::array();
  for (std::size_t i = 0; i < v.components.size(); ++i)
  {
    const Component_count& c = v.components[i];
    Json r = report_counts(c);
    if (kind != files::Result_kind::GENERATORS)
      r["cut"] = {{"connected", c.discs == 1},
                  {"euler_characteristic", c.disc_euler_characteristic},
                  {"boundary_loops", c.disc_boundary_loops}};
    else if (i < v.curves.size())
    {
      r["intersection_matrix"] = report_intersections(v.curves[i]);
      r["is_basis"] = v.curves[i].is_basis;
    }
    components.push_back(r);
  }
  if (!arguments.report.empty())
  {
    files::Output_files out;
    out.add(arguments.report, format_report({{"meridian", MERIDIAN_VERSION},
                                             {"input", {{"file", arguments.mesh}, {"vertices", input.points.size()}}},
                                             {"components", components},
                                             {"failures", v.failures},
                                             {"verified", static_cast<bool>(v)}}));
    commit(out);
  }
  for (const std::string& failure : v.failures) { std::cerr << "meridian: " << failure << '\n'; }
  if (!arguments.quiet) { print_summary(v, result); }
  return v ? VERIFIED : NOT_VERIFIED;
}

} // namespace

Command add_verify(CLI::App& app)
{
  const auto a = std::make_shared<Verify_arguments>();
  CLI::App* command =
    app.add_subcommand("verify", "recount a result of `cut`, `unwrap` or `generators` from its files alone");
  command->add_option("MESH", a->mesh, "the mesh that the result was made from")->required();
  command->add_option("RESULT", a->result, "the result; its .map.json is expected beside it")->required();
  add_common_options(*command, *a);
  return {command, [a] { return run_verify(*a); }};
}

} // namespace program
} // namespace meridian
