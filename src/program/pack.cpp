// SPDX-License-Identifier: GPL-3.0-or-later
#include "arguments.h"
#include "check_paths.h"
#include "end_run.h"
#include "files/Mesh_format.h"
#include "files/Texture_text.h"
#include "options.h"

#include <meridian/base/Union_find.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/map/pack_charts.h>
#include <meridian/proof/Padding.h>
#include <meridian/proof/verify_packing.h>

#include <array>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace meridian {
namespace program {

namespace {

struct Pack_arguments : Common_arguments
{
  std::vector<std::string> meshes, out;
  std::array<int, 2> from{1, 1}; // the texels of the texture that there was
  Pack_options packing;
  bool keep_scale = false;
};

using Triangles = std::vector<std::array<Index, 3>>;

// The charts of a mesh: faces that share texture vertices.
struct Mesh_charts
{
  std::vector<Triangles> triangles;         // of each chart, in vertices of its own
  std::vector<std::vector<Index>> vertices; // of each chart, as the file counts texture vertices
  std::vector<double> area;                 // of each chart, on the mesh
};

double area_in_space(const files::Texture_text& text, std::size_t f)
{
  const auto& t = text.triangles()[f];
  const auto& p = text.points();
  return norm(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]])) / 2;
}

Mesh_charts charts_of(const files::Texture_text& text)
{
  const auto& all = text.texture_triangles();
  const std::size_t n = text.texture().size();
  Union_find joined(static_cast<Index>(n));
  for (const auto& t : all)
  {
    joined.unite(t[0], t[1]);
    joined.unite(t[0], t[2]);
  }
  Mesh_charts charts;
  std::vector<Index> chart_of(n, -1), own(n, -1); // of each set by its number, and of each vertex in its chart
  for (std::size_t f = 0; f < all.size(); ++f)
  {
    Index& chart = chart_of[joined.find(all[f][0])];
    if (chart < 0)
    {
      chart = static_cast<Index>(charts.triangles.size());
      charts.triangles.emplace_back();
      charts.vertices.emplace_back();
      charts.area.push_back(0);
    }
    auto& triangle = charts.triangles[chart].emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Index v = all[f][k];
      if (own[v] < 0)
      {
        own[v] = static_cast<Index>(charts.vertices[chart].size());
        charts.vertices[chart].push_back(v);
      }
      triangle[k] = own[v];
    }
    charts.area[chart] += area_in_space(text, f);
  }
  return charts;
}

void check(const Pack_arguments& a)
{
  if (a.out.size() != a.meshes.size())
  {
    throw Usage_error("as many names are needed behind -o as there are meshes: " + std::to_string(a.meshes.size()));
  }
  if (a.keep_scale && a.packing.density > 0)
  {
    throw Usage_error("--density is that of the mesh; leave out --keep-scale");
  }
  check_padding(a.packing);
  for (const auto* paths : {&a.meshes, &a.out})
    for (const std::string& path : *paths)
    {
      if (files::format_of(path) != files::Mesh_format::OBJ)
      {
        throw files::File_error(path + ": texture coordinates are packed in OBJ files");
      }
    }
  std::vector<std::string> written = a.out;
  written.push_back(a.report);
  check_paths(a.meshes, written);
}

// All meshes in one texture.
struct Packed
{
  std::vector<std::vector<Plane_point>> texture; // of each mesh
  std::size_t charts = 0;
  double filled = 0, density = 0;
};

Packed pack(const Pack_arguments& a, const std::vector<files::Texture_text>& texts)
{
  Packed packed;
  std::vector<Mesh_charts> of_mesh;
  std::vector<Chart> charts;
  for (const files::Texture_text& text : texts)
  {
    of_mesh.push_back(charts_of(text));
    packed.texture.push_back(text.texture());
  }
  for (std::size_t i = 0; i < texts.size(); ++i)
    for (std::size_t k = 0; k < of_mesh[i].triangles.size(); ++k)
    {
      Chart& chart = charts.emplace_back(Chart{&of_mesh[i].triangles[k], {}, of_mesh[i].area[k]});
      for (Index v : of_mesh[i].vertices[k]) { chart.at.push_back(in_proportion(texts[i].texture()[v], a.from)); }
      if (a.keep_scale) { chart.area = covered_area(chart); }
    }
  packed.charts = charts.size();
  Pack_options options = a.packing;
  options.may_enlarge = !a.keep_scale;
  packed.filled = pack_charts(charts, options);
  for (const Chart& c : charts)
    for (const Plane_point& p : c.at)
    {
      if (!std::isfinite(p[0] + p[1])) { throw Invalid_input_error("coordinates are too large to be packed"); }
    }
  auto chart = charts.begin();
  double area = 0, image = 0; // of charts that have both
  for (std::size_t i = 0; i < texts.size(); ++i)
    for (const auto& vertices : of_mesh[i].vertices)
    {
      for (std::size_t v = 0; v < vertices.size(); ++v) { packed.texture[i][vertices[v]] = chart->at[v]; }
      const double covered = covered_area(*chart);
      if (covered > 0 && chart->area > 0)
      {
        area += chart->area;
        image += covered;
      }
      ++chart;
    }
  if (area > 0 && !a.keep_scale) { packed.density = std::sqrt(texels_of(a.packing) * image / area); }
  return packed;
}

// Recounts the texts that shall be written.
Verification recount(const Pack_arguments& a, const std::vector<files::Texture_text>& read,
                     const std::vector<std::string>& written)
{
  Triangles faces;
  std::vector<Plane_point> texture, before;
  for (std::size_t i = 0; i < written.size(); ++i)
  {
    const files::Texture_text text(a.out[i], written[i]);
    const auto first = static_cast<Index>(texture.size());
    for (const auto& t : text.texture_triangles()) { faces.push_back({t[0] + first, t[1] + first, t[2] + first}); }
    texture.insert(texture.end(), text.texture().begin(), text.texture().end());
    before.insert(before.end(), read[i].texture().begin(), read[i].texture().end());
  }
  return verify_packing(faces, texture, padding_of(a.packing), a.packing.tiles, before);
}

int run_pack(const Pack_arguments& a)
{
  check(a);
  Terminal terminal(a.quiet);
  std::vector<files::Texture_text> texts;
  std::vector<std::string> notes, written;
  for (const std::string& mesh : a.meshes)
  {
    texts.emplace_back(mesh, files::read_bytes(mesh));
    const std::size_t without = texts.back().faces_without();
    if (without > 0)
    {
      notes.push_back("note: " + mesh + ": " + std::to_string(without)
                      + " faces have no texture coordinates, and stay without");
    }
  }
  const Packed packed = pack(a, texts);
  for (std::size_t i = 0; i < texts.size(); ++i) { written.push_back(texts[i].format(packed.texture[i])); }
  const Verification verification = recount(a, texts, written);
  if (packed.filled > 1)
  {
    notes.emplace_back("note: faces of a chart overlap: together they cover more than there is");
  }
  files::Output_files out;
  Json report{{"meridian", MERIDIAN_VERSION},      {"meshes", a.meshes},
              {"charts", packed.charts},           {"coverage", packed.filled},
              {"failures", verification.failures}, {"verified", static_cast<bool>(verification)}};
  if (packed.density > 0) { report["density"] = packed.density; }
  if (!a.report.empty()) { out.add(a.report, format_report(report)); }
  for (std::size_t i = 0; i < written.size() && verification; ++i) { out.add(a.out[i], written[i]); }
  std::ostringstream summary;
  summary << a.meshes.size() << (a.meshes.size() == 1 ? " mesh, " : " meshes, ") << packed.charts
          << (packed.charts == 1 ? " chart" : " charts") << "; " << packed.filled << " of the texture filled";
  if (packed.density > 0) { summary << ", " << packed.density << " texels along a unit of length"; }
  return end_run(a, verification, out, terminal, {{}, notes, summary.str()});
}

} // namespace

Command add_pack(CLI::App& app)
{
  const auto a = std::make_shared<Pack_arguments>();
  CLI::App* command = app.add_subcommand(
    "pack", "pack the charts of meshes that have texture coordinates into one texture; nothing else changes");
  command->add_option("MESH", a->meshes, "OBJ files with texture coordinates")->required();
  command->add_option("-o,--output", a->out, "the same files with other texture coordinates, one for each MESH")
    ->required()
    ->type_name("OUT.obj...");
  command->add_flag("--keep-scale", a->keep_scale,
                    "keep the sizes that charts have beside each other; otherwise all get one density of texels");
  add_resolution(*command, "--from", a->from,
                 "texels of the texture that the coordinates are of, to the right and upwards, if it is no square");
  add_common_options(*command, *a);
  add_pack_options(*command, a->packing);
  return {command, [a] { return run_pack(*a); }};
}

} // namespace program
} // namespace meridian
