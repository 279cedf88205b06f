// SPDX-License-Identifier: GPL-3.0-or-later
#include "arguments.h"
#include "cut.h"
#include "end_run.h"
#include "files/Mesh_format.h"
#include "files/map_file.h"
#include "files/png.h"
#include "files/write_layout.h"
#include "files/write_mesh.h"
#include "files/write_texture.h"
#include "given_seams.h"
#include "options.h"
#include "page/format_unwrap_page.h"

#include <meridian/base/Result_mesh.h>
#include <meridian/base/Verification.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/map/Parameterization.h>
#include <meridian/map/distortion.h>
#include <meridian/map/planar_map.h>
#include <meridian/proof/verify_unwrapping.h>
#include <meridian/result/Assembled_result.h>
#include <meridian/result/name_curves.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/examine_surface.h>
#include <meridian/surface/measures.h>
#include <meridian/unwrap/Unwrapping.h>
#include <meridian/unwrap/geometry_image.h>
#include <meridian/unwrap/measure_round_trip.h>
#include <meridian/unwrap/pack_unwrappings.h>
#include <meridian/unwrap/unwrap_surface.h>

#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>

namespace meridian {
namespace program {

namespace {

// The paths that go with OUT.
std::string beside(const Unwrap_arguments& a, const char* ending) { return files::stem_of(a.out) + ending; }

void check_unwrap_arguments(const Unwrap_arguments& a)
{
  if (files::format_of(a.out) != files::Mesh_format::OBJ)
  {
    throw files::File_error(a.out
                            + ": texture coordinates are written to OBJ files; end the name with .obj or .obj.gz");
  }
  check_cut_arguments(a);
  const auto forbid = [](bool is_wrong, const char* message) {
    if (is_wrong) { throw Usage_error(message); }
  };
  forbid(a.has_border && a.border == Map_border::FREE && !improves_maps(a.parameterization),
         "this --parameterization needs a border; --border circle or square");
  forbid(!a.texture.empty() && files::ending_of(a.texture) != "png", "--png writes a PNG file; end its name with .png");
  const auto format = files::format_of(a.distortion);
  forbid(!a.distortion.empty() && !(format && files::holds_face_values(*format)),
         "--distortion writes PLY or VTP, which can hold values of faces");
  forbid(a.charts != 1 && a.geometry_image > 0, "--geometry-image is one chart; leave out --charts");
  forbid(a.charts != 1 && (a.family > 1 || a.stretch_weight > 0),
         "--family and --stretch-weight compare cuts into one chart; leave out --charts");
  check_padding(a.packing);
  forbid(a.packing.tiles > 1 && !(a.layout.empty() && a.view.empty()),
         "--svg and --view show one texture; leave out --tiles");
  forbid(a.packing.density > 0 && a.geometry_image > 0, "a geometry image fills its square; leave out --density");
  const bool has_seams = has_given_seams(a);
  forbid(a.seams.compare(0, 6, "sharp:") == 0 && !is_kind_of_seam(a.seams),
         "--seams sharp:ANGLE takes an angle in degrees, more than 0 and less than 180");
  forbid(has_seams && a.geometry_image > 0, "--geometry-image has a cut of its own; leave out --seams and --chart-per");
  forbid(has_seams && (a.family > 1 || a.stretch_weight > 0),
         "--family and --stretch-weight compare cuts; leave out --seams and --chart-per");
  std::vector<std::string> written{
    a.out, files::map_path(a.out, a.map), a.report, a.view, a.curves, a.layout, a.texture, a.distortion};
  if (!a.texture.empty()) { written.push_back(beside(a, ".mtl")); }
  if (a.geometry_image > 0)
  {
    forbid(a.on_edges, "--geometry-image divides edges at the corners of the square; leave out --on-edges");
    forbid((a.has_border && a.border != Map_border::SQUARE) || !takes_polygon(a.parameterization),
           "--geometry-image maps into a square with --parameterization symmetric-dirichlet, conformal, stretch or "
           "positive");
    for (const char* ending : {".geometry.png", ".remesh.obj"}) { written.push_back(beside(a, ending)); }
  }
  check_paths(a, written, {is_kind_of_seam(a.seams) ? "" : a.seams});
}

Unwrap_options unwrap_options(const Unwrap_arguments& a, const Cut_options& cut)
{
  Unwrap_options o;
  o.cut = cut;
  o.map.method = a.parameterization;
  o.map.border = a.border;
  o.family = std::max(a.family, 1);
  o.stretch_weight = a.stretch_weight;
  o.max_stretch = a.max_stretch;
  o.image_size = a.geometry_image;
  o.charts = a.charts;
  return o;
}

// Packs the maps of all components. Returns texture coordinates for the vertices of a result, and gives its faces their
// charts, if a component has several.
std::vector<Plane_point> pack(const Unwrap_arguments& arguments, const Loaded_mesh& loaded,
                              std::vector<Unwrapping>& unwrapped, Assembled_result& assembled)
{
  const bool is_image = unwrapped.front().border.size > 0; // whose square stays as it is
  std::vector<double> units;
  for (const Surface_component& c : loaded.examination.components) { units.push_back(c.unit); }
  if (!is_image) { pack_unwrappings(unwrapped, units, arguments.packing); }
  std::vector<Plane_point> texture(assembled.mesh.points.size(), {0, 0});
  std::vector<std::int32_t> chart_of(assembled.mesh.points.size(), 0); // each vertex
  std::size_t charts = 0;
  for (std::size_t i = 0; i < unwrapped.size(); ++i)
  {
    const Unwrapping& u = unwrapped[i];
    const std::vector<Index>& place = assembled.place[i];
    for (std::size_t v = 0; v < u.map.at.size(); ++v) { texture[place[v]] = u.map.at[v]; }
    for (std::size_t f = 0; f < u.disc.triangles.size(); ++f)
    {
      const std::size_t chart = charts + (u.chart_of.empty() ? 0 : static_cast<std::size_t>(u.chart_of[f]));
      for (Index v : u.disc.triangles[f]) { chart_of[place[v]] = static_cast<std::int32_t>(chart); }
    }
    charts += u.charts;
  }
  if (charts > unwrapped.size())
  {
    for (const auto& face : assembled.mesh.faces) { assembled.mesh.chart_of.push_back(chart_of[face[0]]); }
  }
  return texture;
}

// Faces without area, or turned over, for those who read coordinates in single precision.
std::size_t count_flipped_in_single_precision(const Result_mesh& mesh, std::vector<Plane_point> texture)
{
  for (Plane_point& p : texture)
  {
    for (double& x : p) { x = static_cast<float>(x); }
  }
  return find_flipped_faces(mesh.faces, texture).size();
}

// Texels along a unit of length of the mesh, in the mean.
double density_of(const Unwrap_arguments& a, const Loaded_mesh& loaded, const Result_mesh& mesh,
                  const std::vector<Plane_point>& texture)
{
  double on_surface = 0;
  for (const Surface_component& c : loaded.examination.components) { on_surface += c.unit * c.unit * area(c.surface); }
  return on_surface > 0 ? a.packing.resolution * std::sqrt(area_of(mesh.faces, texture) / on_surface) : 0;
}

Json report_steps(const std::vector<Unwrap_step>& steps, double unit)
{
  Json list = Json::array();
  for (const Unwrap_step& s : steps)
  {
    list.push_back({{"name", s.name}, {"length", unit * s.length}, {"taken", s.is_taken}});
    if (s.flipped < 0) { list.back()["reason"] = s.reason; }
    else { list.back().update({{"stretch_l2", s.stretch_l2}, {"method", name_of(s.method)}, {"flipped", s.flipped}}); }
  }
  return list;
}

Json report_map(const Unwrapping& u, const Unwrap_options& options, double unit)
{
  const Distortion& d = u.map.distortion;
  Json attempts = Json::array();
  for (const Map_attempt& a : u.map.attempts)
  {
    attempts.push_back({{"method", name_of(a.method)},
                        {"border", name_of(a.border)},
                        {"flipped", a.flipped < 0 ? Json() : Json(a.flipped)}});
    if (!a.reason.empty()) { attempts.back()["reason"] = a.reason; }
  }
  return {{"method", name_of(u.map.method)},
          {"border", name_of(u.map.border)},
          {"asked", name_of(options.map.method)},
          {"attempts", attempts},
          {"flipped", u.map.flipped.size()},
          {"one_to_one", u.map.is_one_to_one},
          {"stretch_l2", d.stretch_l2},
          {"stretch_linf", d.stretch_linf},
          {"angle", d.angle * 180 / std::acos(-1.)},
          {"area", d.area},
          {"conformal", d.conformal},
          {"areal", d.areal},
          {"family", report_steps(u.members, unit)},
          {"links", report_steps(u.variations, unit)},
          {"extensions", report_steps(u.extensions, unit)},
          {"extended_to", u.extended},
          {"charts", u.charts}};
}

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

std::string count_of(std::size_t count, const char* one, const char* more)
{
  return std::to_string(count) + " " + (count == 1 ? one : more);
}

// What a person should know of the maps and the geometry image.
std::vector<std::string> notes_of(const std::vector<Unwrapping>& unwrapped, const std::vector<std::string>& warnings,
                                  const Json& report)
{
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < unwrapped.size(); ++i)
  {
    const Unwrapping& u = unwrapped[i];
    const Map_attempt& asked = u.map.attempts.front();
    const std::string component = "note: component " + std::to_string(i) + ": ";
    if (u.map.attempts.size() > 1)
    {
      notes.push_back(component + "mapped by " + name_of(u.map.method) + " (border " + name_of(u.map.border)
                      + "), because " + name_of(asked.method) + " (border " + name_of(asked.border) + ") "
                      + (asked.flipped < 0       ? "gave no map: " + asked.reason
                         : !asked.reason.empty() ? "left a map that is not one-to-one: " + asked.reason
                                                 : "left " + std::to_string(asked.flipped) + " flipped faces"));
    }
    if (u.extended > 0)
    {
      notes.push_back(component + "the cut was extended to " + count_of(u.extended, "vertex", "vertices")
                      + " for a lower stretch");
    }
  }
  for (const std::string& warning : warnings) { notes.push_back("warning: " + warning); }
  const std::size_t flipped = report["texture"]["flipped_in_single_precision"];
  if (flipped > 0)
  {
    notes.push_back("note: read in single precision, the coordinates leave " + count_of(flipped, "face", "faces")
                    + " without area, or turned over");
  }
  if (report.contains("geometry_image"))
  {
    const Json& image = report["geometry_image"];
    std::ostringstream note;
    note << "geometry image: the surface made of it has genus " << image["genus"] << " and " << image["boundary_loops"]
         << " boundary loops; Hausdorff distance " << image["hausdorff"].get<double>() << ", PSNR "
         << image["psnr"].get<double>() << " dB";
    notes.push_back(note.str());
  }
  return notes;
}

// Where a stretch is so high that few would want the map.
std::vector<std::string> warnings_of(const std::vector<Unwrapping>& unwrapped)
{
  constexpr double high = 2;
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < unwrapped.size(); ++i)
  {
    const double stretch = unwrapped[i].map.distortion.stretch_l2;
    if (stretch <= high) { continue; }
    std::ostringstream warning;
    warning << "component " << i << ": the L2 stretch is " << stretch << ", more than " << high
            << ": texture is smeared there";
    warnings.push_back(warning.str());
  }
  return warnings;
}

// Where a stretch or a number of charts that was asked for was not reached, and why.
std::vector<std::string> missed_of(const Unwrap_arguments& arguments, const std::vector<Unwrapping>& unwrapped,
                                   const std::vector<Unwrap_options>& options)
{
  const double wanted = arguments.max_stretch.value_or(arguments.charts == 0 ? default_max_stretch_of_charts : 0);
  std::vector<std::string> all;
  for (std::size_t i = 0; i < unwrapped.size(); ++i)
  {
    const Unwrapping& u = unwrapped[i];
    std::ostringstream missed;
    missed << "component " << i << ": ";
    if (arguments.charts > 1 && u.charts < static_cast<std::size_t>(arguments.charts))
    {
      missed << count_of(u.charts, "chart", "charts") << ", fewer than the " << arguments.charts
             << " asked for; no arc divides any further";
      all.push_back(missed.str());
    }
    else if (wanted > 0 && u.map.distortion.stretch_l2 > wanted)
    {
      missed << "the L2 stretch is " << u.map.distortion.stretch_l2 << ", more than the " << wanted
             << " asked for; its cut was extended to " << count_of(u.extended, "vertex", "vertices")
             << (u.extended >= static_cast<std::size_t>(options[i].extensions)
                   ? ", and no more are tried"
                   : ", and more of them gained too little");
      if (arguments.charts == 0) { missed << "; it is divided into " << count_of(u.charts, "chart", "charts"); }
      else { missed << "; --charts auto divides it"; }
      all.push_back(missed.str());
    }
  }
  return all;
}

// The files of a verified unwrapping, its report and its geometry image apart.
void add_unwrapping(files::Output_files& out, const Unwrap_arguments& arguments, const Loaded_mesh& loaded,
                    const Cut_result& result, const std::vector<Unwrapping>& unwrapped,
                    const std::vector<Plane_point>& texture, const std::string& caption)
{
  namespace fs = std::filesystem;
  const Result_mesh& mesh = result.assembled.mesh;
  const std::string material = arguments.texture.empty() ? "" : beside(arguments, ".mtl");
  out.add(arguments.out, files::format_unwrapped(loaded.soup, mesh, texture, loaded.attributes,
                                                 fs::path(material).filename().string()));
  out.add(files::map_path(arguments.out, arguments.map),
          files::format_map(mesh, files::Result_kind::UNWRAPPING, arguments.map));
  const auto faces = distortion_of_faces(result.assembled, texture, unwrapped);
  std::vector<double> stretch;
  for (const Face_distortion& f : faces) { stretch.push_back(std::min(f.stretch_l2, 1e30)); }
  if (!arguments.layout.empty()) { out.add(arguments.layout, files::format_layout(mesh, texture, stretch)); }
  if (!arguments.texture.empty())
  {
    out.add(arguments.texture, files::format_checkerboard(1024, 32));
    const fs::path folder = fs::weakly_canonical(fs::absolute(material)).parent_path(),
                   image = fs::weakly_canonical(fs::absolute(arguments.texture));
    out.add(material, files::format_material(image.lexically_relative(folder).generic_string()));
  }
  if (!arguments.distortion.empty()) { out.add(arguments.distortion, format_distortion(arguments, mesh, faces)); }
  if (!arguments.curves.empty())
  {
    out.add(arguments.curves, files::format_curves(mesh.points, name_curves(result.cuts, result.assembled)));
  }
  if (!arguments.view.empty())
  {
    out.add(arguments.view, page::format_unwrap_page(arguments.mesh, caption, mesh, texture, stretch));
  }
}

// What was unwrapped, in one line.
std::string caption_of(const Cut_result& result, const std::vector<Unwrapping>& unwrapped)
{
  std::size_t charts = 0;
  double worst = 0;
  for (const Unwrapping& u : unwrapped)
  {
    charts += u.charts;
    worst = std::max(worst, u.map.distortion.stretch_l2);
  }
  std::ostringstream caption;
  caption << count_of(unwrapped.size(), "component", "components") << ", genus " << result.genus << ", " << result.loops
          << " boundary loops; ";
  if (charts > unwrapped.size()) { caption << charts << " charts, "; }
  caption << "cut length " << result.length << ", L2 stretch " << worst;
  return caption.str();
}

// The options of each component.
std::vector<Unwrap_options> unwrap_options(const Unwrap_arguments& arguments, const Loaded_mesh& loaded,
                                           const std::vector<Cut_options>& cuts)
{
  std::vector<std::vector<Index>> seams = find_given_seams(arguments, loaded);
  std::vector<Unwrap_options> options;
  for (std::size_t i = 0; i < cuts.size(); ++i)
  {
    options.push_back(unwrap_options(arguments, cuts[i]));
    options.back().seams = std::move(seams[i]);
    if (cuts.size() > 1) { options.back().filled = 0; } // they fill the square together
  }
  return options;
}

// Names material libraries from where the result is, which may be another folder than that of the mesh.
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

int run_unwrap(const Unwrap_arguments& arguments)
{
  check_unwrap_arguments(arguments);
  Terminal terminal(arguments.quiet);
  Loaded_mesh loaded = load_mesh(arguments, true);
  move_libraries(arguments, loaded.attributes.libraries);
  const auto& components = loaded.examination.components;
  if (arguments.geometry_image > 0 && components.size() > 1)
    throw Invalid_input_error("a geometry image holds one component; the mesh has "
                              + std::to_string(components.size()));
  const std::vector<Cut_options> cuts = cut_options(arguments, loaded, terminal);
  const std::vector<Unwrap_options> options = unwrap_options(arguments, loaded, cuts);
  std::vector<Unwrapping> unwrapped;
  std::vector<Cut> found;
  for (std::size_t i = 0; i < components.size(); ++i)
  {
    terminal.begin_component(i, components.size());
    unwrapped.push_back(unwrap_surface(components[i].surface, options[i]));
    found.push_back(std::move(unwrapped.back().cut));
  }
  Cut_result result = assemble_cut(loaded, std::move(found), cuts);
  const std::vector<Plane_point> texture = pack(arguments, loaded, unwrapped, result.assembled);
  const double gap = arguments.packing.padding / arguments.packing.resolution;
  verify(result, terminal, [&](const Assembled_result& assembled) {
    return verify_unwrapping(loaded.soup, assembled.mesh, texture, gap, arguments.packing.tiles);
  });
  const Result_mesh& mesh = result.assembled.mesh;
  const Verification& verification = result.verification;
  for (std::size_t i = 0; i < unwrapped.size(); ++i)
  {
    result.components[i]["parameterization"] = report_map(unwrapped[i], options[i], components[i].unit);
  }
  const std::vector<std::string> warnings = warnings_of(unwrapped), missed = missed_of(arguments, unwrapped, options);
  Json report{{"meridian", MERIDIAN_VERSION},
              {"input", report_input(arguments.mesh, loaded.soup, loaded.examination)},
              {"components", result.components},
              {"texture",
               {{"coordinates", texture.size()},
                {"coverage", area_of(mesh.faces, texture) / count_tiles(texture)},
                {"tiles", count_tiles(texture)},
                {"density", density_of(arguments, loaded, mesh, texture)},
                {"flipped_in_single_precision", count_flipped_in_single_precision(mesh, texture)}}},
              {"seconds", report_seconds(loaded, result)},
              {"failures", verification.failures},
              {"missed", missed},
              {"warnings", warnings},
              {"verified", verification && missed.empty()}};

  files::Output_files out;
  if (verification && arguments.geometry_image > 0)
  {
    report["geometry_image"] = add_geometry_image(out, arguments, components.front(), unwrapped.front());
  }
  if (!arguments.report.empty()) { out.add(arguments.report, format_report(report)); }
  const std::string caption = caption_of(result, unwrapped);
  std::vector<std::string> notes = notes_of(unwrapped, warnings, report);
  if (has_given_seams(arguments)) { notes.push_back(describe_completion(options, result.cuts)); }
  if (verification) { add_unwrapping(out, arguments, loaded, result, unwrapped, texture, caption); }
  return end_run(arguments, verification, out, terminal,
                 {loaded.examination.repairs, notes,
                  caption + (verification ? "; no face is turned over" : "")
                    + (warnings.empty() ? "" : "; WARNING: stretched to more than 2"),
                  missed});
}

void add_picture_options(CLI::App& command, Unwrap_arguments& a)
{
  command
    .add_option("--svg", a.layout, "draw the layout: distortion as colour, the two sides of each seam numbered alike")
    ->type_name("FILE")
    ->group("Pictures");
  command.add_option("--png", a.texture, "write a checkerboard, and beside OUT the material that shows it")
    ->type_name("FILE")
    ->group("Pictures");
  command.add_option("--distortion", a.distortion, "write the mesh as PLY or VTP with the distortion of each face")
    ->type_name("FILE")
    ->group("Pictures");
  command
    .add_option("--geometry-image", a.geometry_image,
                "map into a square, and write N x N points of the surface as a 16-bit PNG and as the surface "
                "remeshed, beside OUT")
    ->check(CLI::Range(5, 16384))
    ->type_name("N")
    ->group("Pictures");
}

// What says how a cut is found, and so does not go with seams that are given.
void exclude_ways_to_cut(CLI::App& command, CLI::Option& option)
{
  for (const char* other : {"--method", "--bases", "--tighten", "--refine-where-needed", "--join", "--links",
                            "--source", "--field", "--values", "--eigenfunction", "--weights", "--extrema", "--minimum",
                            "--maximum", "--from", "--prefer", "--vertex-weights", "--levels", "--direction"})
  {
    option.excludes(command.get_option(other));
  }
}

void add_seam_options(CLI::App& command, Unwrap_arguments& a)
{
  exclude_ways_to_cut(
    command, *command
                .add_option("--seams", a.seams,
                            "cut along seams that are given, and no more than makes discs of what is between them:"
                            "\n  uv, where the texture coordinates of MESH differ"
                            "\n  sharp:ANGLE, edges of more than so many degrees"
                            "\n  FILE, a text file with a path on each line, vertices of MESH (from 0)")
                ->type_name("uv|sharp:ANGLE|FILE")
                ->group("Charts"));
  exclude_ways_to_cut(command, *add_choice<Chart_per>(
                                  command, "--chart-per", [&a](Chart_per per) { a.chart_per = per; }, "",
                                  "cut between parts of MESH, likewise")
                                  ->group("Charts"));
}

void add_chart_options(CLI::App& command, Unwrap_arguments& a)
{
  command
    .add_option_function<std::string>(
      "--charts", [&a](const std::string& n) { a.charts = n == "auto" ? 0 : std::stoi(n); },
      "divide each component into N charts, or as few as bring the L2 stretch to S, by itself 1.02")
    ->check(CLI::Range(1, 1000000) | CLI::IsMember({"auto"}))
    ->type_name("N|auto")
    ->group("Charts");
  add_pack_options(command, a.packing);
}

} // namespace

Command add_unwrap(CLI::App& app)
{
  const auto a = std::make_shared<Unwrap_arguments>();
  CLI::App* command = app.add_subcommand(
    "unwrap", "cut a mesh and give it texture coordinates: a chart for each component, without flipped faces");
  command->add_option("MESH", a->mesh, "the mesh file")->required();
  command
    ->add_option("-o,--output", a->out,
                 "the mesh with texture coordinates: OBJ; vertices are not doubled, seams are in the coordinates")
    ->required()
    ->type_name("OUT.obj");
  add_choice(*command, "--parameterization", a->parameterization, "how discs are mapped into the plane")
    ->group("The map");
  add_choice(*command, "--border", a->border,
             "where the border of a disc goes; methods that need one take a circle for free")
    ->group("The map");
  command->add_option("--family", a->family, "try N different cuts, and take the best")
    ->check(CLI::Range(1, 1000000000))
    ->type_name("N");
  command
    ->add_option("--stretch-weight", a->stretch_weight,
                 "what is best: the least (1 - W) length + W stretch; with W > 0 links are varied too")
    ->check(CLI::Range(0., 1.))
    ->type_name("W")
    ->capture_default_str();
  command
    ->add_option("--max-stretch", a->max_stretch,
                 "extend the cut until the L2 stretch is at most S; otherwise until it is 1.1, where that gains enough")
    ->check(CLI::Range(1., 1e300))
    ->type_name("S");
  command->add_flag("--shortest-seams", "extend the cut only where the L2 stretch is more than 2")
    ->excludes("--max-stretch");
  add_cut_options(*command, *a, Tightening::CURVES);
  add_chart_options(*command, *a);
  add_seam_options(*command, *a);
  add_picture_options(*command, *a);
  return {command, [a, command] {
            note_cut_options(*command, *a);
            a->has_border = command->count("--border") > 0;
            if (command->count("--shortest-seams") > 0) { a->max_stretch = 0; }
            return run_unwrap(*a);
          }};
}

} // namespace program
} // namespace meridian
