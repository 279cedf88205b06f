// SPDX-License-Identifier: GPL-3.0-or-later
// The files that `unwrap` writes.
#include "files/map_file.h"
#include "files/png.h"
#include "files/write_layout.h"
#include "files/write_mesh.h"
#include "files/write_texture.h"
#include "page/format_unwrap_page.h"
#include "unwrap_run.h"

#include <meridian/base/Result_mesh.h>
#include <meridian/map/distortion.h>
#include <meridian/map/pack_charts.h>
#include <meridian/result/Assembled_result.h>
#include <meridian/result/name_curves.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/examine_surface.h>
#include <meridian/unwrap/geometry_image.h>
#include <meridian/unwrap/measure_round_trip.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <sstream>

namespace meridian {
namespace program {

namespace {

// The paths that go with OUT.
std::string beside(const Unwrap_arguments& a, const char* ending) { return files::stem_of(a.out) + ending; }

// The distortion of each face of a result, with numbers in place of infinity.
std::vector<Face_distortion> distortion_of_faces(const Assembled_result& assembled,
                                                 const std::vector<Plane_point>& texture,
                                                 const std::vector<Unwrapping>& unwrapped)
{
  const Result_mesh& mesh = assembled.mesh;
  std::vector<Point> points = mesh.points; // those of each component at its own scale
  std::vector<std::vector<std::array<Index, 3>>> triangles(unwrapped.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) { triangles[mesh.component_of[f]].push_back(mesh.faces[f]); }
  std::vector<std::vector<Face_distortion>> measured;
  for (std::size_t i = 0; i < unwrapped.size(); ++i)
  {
    const auto& local = unwrapped[i].disc.points;
    for (std::size_t v = 0; v < local.size(); ++v) { points[assembled.place[i][v]] = local[v]; }
    measured.push_back(measure_faces(points, triangles[i], texture));
  }
  std::vector<std::size_t> next(unwrapped.size(), 0);
  std::vector<Face_distortion> faces;
  for (Index component : mesh.component_of)
  {
    faces.push_back(measured[component][next[component]++]);
    for (double* value :
         {&faces.back().stretch_l2, &faces.back().stretch_linf, &faces.back().conformal, &faces.back().areal})
    {
      *value = std::min(*value, 1e300);
    }
  }
  return faces;
}

// A geometry image and the surface that it makes, and how near that is.
Json add_geometry_image(files::Output_files& out, const Unwrap_arguments& a, const Surface_component& component,
                        const Unwrapping& u)
{
  const Geometry_image image = sample_geometry(u.disc, u.map.at, u.border);
  const Remeshed remeshed = remesh_from_image(image, &u.border);
  const Round_trip trip = measure_round_trip(component.surface, remeshed.surface);
  std::vector<std::uint16_t> rows; // from the top
  for (int row = image.size; row-- > 0;)
  {
    rows.insert(rows.end(), image.samples.begin() + 3 * image.pixel(0, row),
                image.samples.begin() + 3 * image.pixel(0, row) + 3 * image.size);
  }
  out.add(beside(a, ".geometry.png"), files::format_png(image.size, image.size, 3, rows, 16));
  Result_mesh mesh;
  for (const Point& p : remeshed.surface.points) { mesh.points.push_back(component.unit * p); }
  mesh.faces = remeshed.surface.triangles;
  out.add(beside(a, ".remesh.obj"), files::format_mesh(beside(a, ".remesh.obj"), mesh));
  const int loops = static_cast<int>(boundary_loops(remeshed.surface).size());
  const int characteristic =
    remeshed.surface.number_of_vertices() - remeshed.surface.number_of_edges() + remeshed.surface.number_of_faces();
  const double unit = component.unit;
  return {{"size", image.size},
          {"low", {unit * image.low[0], unit * image.low[1], unit * image.low[2]}},
          {"step", unit * image.step},
          {"faces_left_out", remeshed.faces_left_out},
          {"genus", (2 - characteristic - loops) / 2},
          {"boundary_loops", loops},
          {"hausdorff", unit * trip.hausdorff},
          {"rms", unit * trip.rms},
          {"psnr", trip.psnr}};
}

// The mesh as it is on the surface, not taken apart.
Result_mesh closed_mesh(Result_mesh mesh)
{
  for (auto& face : mesh.faces)
  {
    for (Index& v : face) { v = mesh.copy_of[v] < 0 ? v : mesh.copy_of[v]; }
  }
  mesh.points.resize(std::find_if(mesh.copy_of.begin(), mesh.copy_of.end(), [](Index c) { return c >= 0; })
                     - mesh.copy_of.begin());
  return mesh;
}

// The mesh with the distortion of each face.
std::string format_distortion(const Unwrap_arguments& arguments, const Result_mesh& mesh,
                              const std::vector<Face_distortion>& faces)
{
  std::vector<files::Face_values> values{{"stretch_l2", {}}, {"stretch_linf", {}}, {"conformal", {}}, {"areal", {}}};
  for (const Face_distortion& f : faces)
  {
    const std::array<double, 4> all{f.stretch_l2, f.stretch_linf, f.conformal, f.areal};
    for (std::size_t k = 0; k < 4; ++k) { values[k].values.push_back(all[k]); }
  }
  return files::format_mesh(arguments.distortion, closed_mesh(mesh), values);
}

} // namespace

std::vector<std::string> written_for(const Unwrap_arguments& a)
{
  std::vector<std::string> written{
    a.out, files::map_path(a.out, a.map), a.view, a.curves, a.layout, a.texture, a.distortion, a.doubled};
  if (!a.texture.empty()) { written.push_back(beside(a, ".mtl")); }
  if (a.geometry_image > 0)
  {
    for (const char* ending : {".geometry.png", ".remesh.obj"}) { written.push_back(beside(a, ending)); }
  }
  return written;
}

void move_libraries(const Unwrap_arguments& arguments, std::vector<std::string>& libraries)
{
  namespace fs = std::filesystem;
  const auto folder_of = [](const std::string& path) { return fs::weakly_canonical(fs::absolute(path)).parent_path(); };
  const fs::path from = folder_of(arguments.mesh), to = folder_of(arguments.out);
  if (from == to) { return; }
  const auto move = [&](const std::string& name) { return (from / name).lexically_relative(to).generic_string(); };
  for (std::string& library : libraries)
  {
    if (fs::exists(from / library))
    {
      library = move(library);
      continue;
    }
    std::istringstream names(library); // of several
    std::string moved;
    for (std::string name; names >> name;) { moved += (moved.empty() ? "" : " ") + move(name); }
    library = moved;
  }
}

void add_files(files::Output_files& out, Unwrap_run& run)
{
  const Unwrap_arguments& arguments = run.arguments;
  const Cut_result& result = run.result;
  const std::vector<Plane_point>& texture = run.texture;
  if (arguments.geometry_image > 0)
  {
    run.report["geometry_image"] =
      add_geometry_image(out, arguments, run.loaded.examination.components.front(), run.unwrapped.front());
  }
  namespace fs = std::filesystem;
  const Result_mesh& mesh = result.assembled.mesh;
  const std::string material = arguments.texture.empty() ? "" : beside(arguments, ".mtl");
  out.add(arguments.out, files::format_unwrapped(run.loaded.soup, mesh, texture, run.loaded.attributes,
                                                 fs::path(material).filename().string()));
  out.add(files::map_path(arguments.out, arguments.map),
          files::format_map(mesh, files::Result_kind::UNWRAPPING, arguments.map));
  std::vector<Plane_point> shown; // where texels are squares
  for (const Plane_point& p : texture) { shown.push_back(in_proportion(p, arguments.packing.resolution)); }
  const auto faces = distortion_of_faces(result.assembled, shown, run.unwrapped);
  std::vector<double> stretch;
  for (const Face_distortion& f : faces) { stretch.push_back(std::min(f.stretch_l2, 1e30)); }
  if (!arguments.layout.empty()) { out.add(arguments.layout, files::format_layout(mesh, shown, stretch)); }
  if (!arguments.texture.empty())
  {
    constexpr int longer = 1024, square = 32;
    const Plane_point size = in_proportion({longer, longer}, arguments.packing.resolution);
    out.add(arguments.texture, files::format_checkerboard(std::max(static_cast<int>(std::lround(size[0])), 1),
                                                          std::max(static_cast<int>(std::lround(size[1])), 1), square));
    const fs::path folder = fs::weakly_canonical(fs::absolute(material)).parent_path(),
                   image = fs::weakly_canonical(fs::absolute(arguments.texture));
    out.add(material, files::format_material(image.lexically_relative(folder).generic_string()));
  }
  if (!arguments.distortion.empty()) { out.add(arguments.distortion, format_distortion(arguments, mesh, faces)); }
  if (!arguments.doubled.empty())
  {
    files::Vertex_texture doubled{texture, {}};
    for (std::size_t v = 0; v < texture.size(); ++v)
    {
      doubled.vertex.push_back(mesh.copy_of[v] < 0 ? static_cast<Index>(v) : mesh.copy_of[v]);
    }
    out.add(arguments.doubled, files::format_mesh(arguments.doubled, mesh, {}, doubled));
  }
  if (!arguments.curves.empty())
  {
    out.add(arguments.curves, files::format_curves(mesh.points, name_curves(result.cuts, result.assembled)));
  }
  if (!arguments.view.empty())
  {
    out.add(arguments.view, page::format_unwrap_page(arguments.mesh, caption_of(run), mesh, shown, stretch));
  }
}

} // namespace program
} // namespace meridian
