// SPDX-License-Identifier: GPL-3.0-or-later
// What `unwrap` reports, and says in words.
#include "given_seams.h"
#include "kept_out.h"
#include "options.h"
#include "pins.h"
#include "unwrap_run.h"

#include <meridian/base/Result_mesh.h>
#include <meridian/map/Parameterization.h>
#include <meridian/map/distortion.h>
#include <meridian/map/pack_charts.h>
#include <meridian/map/planar_map.h>
#include <meridian/proof/Padding.h>
#include <meridian/proof/verify_packing.h>
#include <meridian/surface/examine_surface.h>
#include <meridian/surface/measures.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace meridian {
namespace program {

namespace {

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
  return on_surface > 0 ? std::sqrt(texels_of(a.packing) * area_of(mesh.faces, texture) / on_surface) : 0;
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
          {"symmetric", u.is_symmetric},
          {"charts", u.charts}};
}

std::string count_of(std::size_t count, const char* one, const char* more)
{
  return std::to_string(count) + " " + (count == 1 ? one : more);
}

// What a person should know of the maps and the geometry image.
std::vector<std::string> notes_of(const Unwrap_arguments& arguments, const std::vector<Unwrapping>& unwrapped,
                                  const std::vector<std::string>& warnings, const Json& report)
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
    if (!u.map.flipped.empty())
    {
      notes.push_back(component + count_of(u.map.flipped.size(), "face is", "faces are")
                      + " lost, as in a mesh whose edges differ by more than double precision can tell apart; collapse"
                        " the shortest of them, or try --charts N");
    }
  }
  for (const std::string& warning : warnings) { notes.push_back("warning: " + warning); }
  const std::size_t flipped = report["texture"]["flipped_in_single_precision"];
  if (flipped > 0)
  {
    notes.push_back("note: read in single precision, the coordinates leave " + count_of(flipped, "face", "faces")
                    + " without area, or turned over");
  }
  constexpr double little = 0.3;
  const double filled = report["texture"]["coverage"];
  if (arguments.charts == 1 && arguments.meshes.size() == 1 && !(arguments.packing.density > 0)
      && arguments.pins.empty() && arguments.geometry_image == 0 && filled < little)
  {
    std::ostringstream note;
    note << "note: " << filled
         << " of the texture is filled, since charts are long or branched; --charts auto divides them";
    notes.push_back(note.str());
  }
  const std::size_t near = report["texture"]["near_themselves"];
  if (near > 0)
  {
    notes.push_back("note: " + count_of(near, "face is", "faces are")
                    + " nearer than the padding to another side of a slit of its chart");
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
    if (arguments.is_symmetric && !u.is_symmetric)
    {
      all.push_back("component " + std::to_string(i)
                    + ": its charts are no mirror images: no plane is found in which it is its own mirror image, "
                      "triangle by triangle and with edges along it, or maps that are made alike would overlap");
    }
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

} // namespace

void report_run(Unwrap_run& run)
{
  const Unwrap_arguments& arguments = run.arguments;
  const std::vector<Plane_point>& texture = run.texture;
  Cut_result& result = run.result;
  const auto& components = run.loaded.examination.components;
  for (std::size_t i = 0; i < run.unwrapped.size(); ++i)
  {
    result.components[i]["parameterization"] = report_map(run.unwrapped[i], run.options[i], components[i].unit);
  }
  run.warnings = warnings_of(run.unwrapped);
  run.missed = missed_of(arguments, run.unwrapped, run.options);
  for (const std::string& line : missed_pins(run)) { run.missed.push_back(line); }
  const auto near = find_near_themselves(result.assembled.mesh.faces, texture, padding_of(arguments.packing));
  if (!near.empty() && arguments.has_padding)
  {
    run.missed.push_back(count_of(near.size(), "face is", "faces are") + " nearer than the padding to another side of "
                         + "a slit of its chart; --charts auto has fewer slits");
  }
  const std::vector<std::string> missed = missed_kept_out(run.options, result.cuts, components);
  run.missed.insert(run.missed.end(), missed.begin(), missed.end());
  const Result_mesh& mesh = result.assembled.mesh;
  run.report = {{"meridian", MERIDIAN_VERSION},
                {"input", report_input(arguments.mesh, run.loaded.soup, run.loaded.examination)},
                {"components", result.components},
                {"texture",
                 {{"coordinates", texture.size()},
                  {"coverage", area_of(mesh.faces, texture) / count_tiles(texture)},
                  {"tiles", count_tiles(texture)},
                  {"resolution", arguments.packing.resolution},
                  {"density", density_of(arguments, run.loaded, mesh, texture)},
                  {"near_themselves", near.size()},
                  {"flipped_in_single_precision", count_flipped_in_single_precision(mesh, texture)}}},
                {"seconds", report_seconds(run.loaded, result)},
                {"failures", result.verification.failures},
                {"missed", run.missed},
                {"warnings", run.warnings},
                {"verified", result.verification && run.missed.empty()}};
}

std::string caption_of(const Unwrap_run& run)
{
  const std::vector<Unwrapping>& unwrapped = run.unwrapped;
  std::size_t charts = 0;
  double worst = 0;
  for (const Unwrapping& u : unwrapped)
  {
    charts += u.charts;
    worst = std::max(worst, u.map.distortion.stretch_l2);
  }
  std::ostringstream caption;
  caption << count_of(unwrapped.size(), "component", "components") << ", genus " << run.result.genus << ", "
          << run.result.loops << " boundary loops; ";
  if (charts > unwrapped.size()) { caption << charts << " charts, "; }
  caption << "cut length " << run.result.length << ", L2 stretch " << worst;
  return caption.str();
}

Last_words words_of(const Unwrap_run& run)
{
  std::vector<std::string> notes = notes_of(run.arguments, run.unwrapped, run.warnings, run.report);
  if (has_given_seams(run.arguments)) { notes.push_back(describe_completion(run.options, run.result.cuts)); }
  return {run.loaded.examination.repairs, notes,
          caption_of(run) + (run.result.verification ? "; no face is turned over" : "")
            + (run.warnings.empty() ? "" : "; WARNING: stretched to more than 2"),
          run.missed};
}

} // namespace program
} // namespace meridian
