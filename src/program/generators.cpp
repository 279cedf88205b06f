// SPDX-License-Identifier: GPL-3.0-or-later
#include "Terminal.h"
#include "arguments.h"
#include "end_run.h"
#include "field_arguments.h"
#include "files/Mesh_format.h"
#include "files/Output_files.h"
#include "files/map_file.h"
#include "files/write_mesh.h"
#include "options.h"
#include "page/format_page.h"
#include "report.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Progress_observer.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/base/Verification.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/run_both.h>
#include <meridian/base/vectors.h>
#include <meridian/handles/Generators.h>
#include <meridian/handles/classify_generators.h>
#include <meridian/handles/find_generators.h>
#include <meridian/handles/find_shortest_basis.h>
#include <meridian/proof/verify_generators.h>
#include <meridian/result/Assembled_result.h>
#include <meridian/result/assemble_result.h>
#include <meridian/result/name_curves.h>
#include <meridian/result/recount.h>
#include <meridian/surface/examine_surface.h>

#include <chrono>
#include <future>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <utility>

namespace meridian {
namespace program {

namespace {

Generator_options options_for(const Generator_arguments& a, const Loaded_mesh& loaded, std::size_t place)
{
  Generator_options o;
  static_cast<Field_options&>(o) = field_options(a, loaded, place);
  static_cast<Meridian_options&>(o) = meridian_options(a, loaded, place);
  o.is_open = a.mode == Boundary_mode::OPEN;
  o.flow = a.longitudes == Longitudes::FLOW;
  o.tighten = !a.no_tighten;
  o.keep_complex = a.complex;
  return o;
}

std::vector<Point> in_file(const Surface_component& component, std::vector<Point> line)
{
  for (Point& p : line) { p = component.unit * p; }
  return line;
}

// What a run writes, whichever curves were asked for.
struct Outcome
{
  Assembled_result assembled;
  std::vector<Result_curve> curves;
  std::vector<std::vector<Point>> lines; // of the complex
  Generator_verification verification;
  double seconds_verifying = 0;
  Json components = Json::array();
  std::string summary, view;
};

template <class Curves>
Outcome conclude(const Polygon_soup& soup, const Examination& examination, const std::vector<Curves>& all,
                 Terminal& terminal)
{
  Outcome o;
  o.assembled = assemble_refined(soup, examination, all);
  o.curves = name_curves(all, o.assembled);
  terminal.stage_started(Stage::VERIFY);
  const auto begin = std::chrono::steady_clock::now();
  o.verification = verify_generators(soup, o.assembled.mesh, o.curves);
  o.seconds_verifying = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  o.verification.curves.resize(all.size());
  return o;
}

// The curves, and the lines of the complex after them.
std::string format_curves(const Outcome& o)
{
  auto points = o.assembled.mesh.points;
  auto curves = o.curves;
  for (std::size_t i = 0; i < o.lines.size(); ++i)
  {
    curves.push_back({"flow_line_" + std::to_string(i), {}, {}});
    for (const Point& p : o.lines[i])
    {
      curves.back().points.push_back(static_cast<std::int32_t>(points.size()));
      points.push_back(p);
    }
  }
  return files::format_curves(points, curves);
}

std::string caption(std::size_t components, int curves, const char* what)
{
  std::ostringstream text;
  text << components << (components == 1 ? " component, " : " components, ") << curves << ' ' << what
       << (curves == 1 ? "" : "s");
  return text.str();
}

std::string format_view(const std::string& title, const Examination& examination, const std::vector<Generators>& all,
                        const Assembled_result& assembled)
{
  std::vector<page::Part> parts;
  std::vector<page::Curve> curves;
  int handle = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    parts.push_back({examination.components[i].surface, all[i].surface, all[i].field});
    for (const Generator_pair& pair : all[i].pairs)
    {
      const std::string number = std::to_string(handle++);
      curves.push_back({page::Curve::MERIDIAN, i, pair.meridian.vertices, true, number, {}});
      curves.push_back({page::Curve::OTHER, i, pair.longitude.vertices, true, number, {}});
    }
    for (const auto& line : all[i].complex_lines)
    {
      curves.push_back({page::Curve::FLOW, i, {}, false, "", in_file(examination.components[i], line)});
    }
  }
  return page::format_page(title, caption(all.size(), handle, "handle"), "longitudes", parts, curves, assembled);
}

std::string format_view(const std::string& title, const Examination& examination,
                        const std::vector<Homology_basis>& all, const Assembled_result& assembled)
{
  static const std::vector<double> no_field;
  std::vector<page::Part> parts;
  std::vector<page::Curve> curves;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    parts.push_back({examination.components[i].surface, all[i].surface, no_field});
    for (const Generator_curve& loop : all[i].loops)
    {
      curves.push_back({page::Curve::OTHER, i, loop.vertices, true, std::to_string(curves.size()), {}});
    }
  }
  return page::format_page(title, caption(all.size(), static_cast<int>(curves.size()), "loop"), "loops", parts, curves,
                           assembled);
}

// Begins to search for self-intersections, where classes are told.
std::future<bool> begin_self_intersections(const Surface_component& c)
{
  if (c.genus() == 0 || c.boundary_loops > 0) { return {}; }
  return std::async(std::launch::async, [&c] { return does_self_intersect(c.surface); });
}

// Finds pairs on every component.
Outcome find_pairs(const Generator_arguments& arguments, const Loaded_mesh& loaded, Terminal& terminal)
{
  const Examination& examination = loaded.examination;
  std::vector<Generator_options> options;
  for (std::size_t i = 0; i < examination.components.size(); ++i)
  {
    options.push_back(options_for(arguments, loaded, i));
    options.back().observer = &terminal;
  }
  std::vector<Generators> all;
  for (std::size_t i = 0; i < examination.components.size(); ++i)
  {
    terminal.begin_component(i, examination.components.size());
    const Surface_component& component = examination.components[i];
    std::future<bool> meets_itself = begin_self_intersections(component); // beside what follows
    all.push_back(find_generators(component.surface, options[i]));
    classify_generators(component.surface, all.back(), std::move(meets_itself), &terminal);
  }
  Outcome outcome = conclude(loaded.soup, examination, all, terminal);
  int handles = 0;
  double meridians = 0, longitudes = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    outcome.components.push_back(
      report_generators(all[i], examination.components[i], outcome.verification.curves[i], options[i], handles));
    handles += all[i].genus;
    for (const Generator_pair& pair : all[i].pairs)
    {
      meridians += examination.components[i].unit * pair.meridian.length;
      longitudes += examination.components[i].unit * pair.longitude.length;
    }
    for (const auto& line : all[i].complex_lines) { outcome.lines.push_back(in_file(examination.components[i], line)); }
  }
  std::ostringstream text;
  text << handles << (handles == 1 ? " handle" : " handles") << ", meridians " << meridians << ", longitudes "
       << longitudes;
  outcome.summary = text.str();
  if (!arguments.view.empty()) { outcome.view = format_view(arguments.mesh, examination, all, outcome.assembled); }
  return outcome;
}

// Finds short loops on every component.
Outcome find_loops(const Generator_arguments& arguments, const Loaded_mesh& loaded, Terminal& terminal)
{
  const Examination& examination = loaded.examination;
  std::vector<Homology_basis> all;
  for (std::size_t i = 0; i < examination.components.size(); ++i)
  {
    terminal.begin_component(i, examination.components.size());
    Basis_options options;
    options.tighten = !arguments.no_tighten;
    options.observer = &terminal;
    all.push_back(find_shortest_basis(examination.components[i].surface, options));
  }
  Outcome outcome = conclude(loaded.soup, examination, all, terminal);
  std::size_t loops = 0;
  double length = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    outcome.components.push_back(report_basis(all[i], examination.components[i], outcome.verification.curves[i]));
    loops += all[i].loops.size();
    for (const Generator_curve& loop : all[i].loops) { length += examination.components[i].unit * loop.length; }
  }
  std::ostringstream text;
  text << loops << " loops, length " << length;
  outcome.summary = text.str();
  if (!arguments.view.empty()) { outcome.view = format_view(arguments.mesh, examination, all, outcome.assembled); }
  return outcome;
}

int run_generators(const Generator_arguments& arguments)
{
  if (files::format_of(arguments.out) != files::Mesh_format::OBJ)
  {
    throw Usage_error(arguments.out + ": generators are written as OBJ, with a line element for each curve");
  }
  check_arguments(arguments);
  Terminal terminal(arguments.quiet);
  const Loaded_mesh loaded = load_mesh(arguments);
  const Examination& examination = loaded.examination;
  const Outcome outcome =
    arguments.basis == Basis::PAIRS ? find_pairs(arguments, loaded, terminal) : find_loops(arguments, loaded, terminal);
  const Generator_verification& verification = outcome.verification;
  const Json report{
    {"meridian", MERIDIAN_VERSION},
    {"input", report_input(arguments.mesh, loaded.soup, examination)},
    {"components", outcome.components},
    {"seconds",
     {{"read", loaded.seconds_reading}, {"examine", loaded.seconds_examining}, {"verify", outcome.seconds_verifying}}},
    {"failures", verification.failures},
    {"verified", static_cast<bool>(verification)}};

  files::Output_files out;
  if (!arguments.report.empty()) { out.add(arguments.report, format_report(report)); }
  if (verification)
  {
    const Result_mesh& mesh = outcome.assembled.mesh;
    std::string refined, map;
    internal::run_both(
      [&] { map = files::format_map(mesh, files::Result_kind::GENERATORS, arguments.map, outcome.curves); },
      [&] { refined = files::format_mesh_with_curves(mesh, outcome.curves); });
    out.add(arguments.out, refined);
    out.add(files::map_path(arguments.out, arguments.map), map);
    if (!arguments.curves.empty()) { out.add(arguments.curves, format_curves(outcome)); }
    if (!arguments.view.empty()) { out.add(arguments.view, outcome.view); }
  }
  const std::string number = std::to_string(examination.components.size());
  return end_run(
    arguments, verification, out, terminal,
    {examination.repairs, {}, number + (number == "1" ? " component: " : " components: ") + outcome.summary});
}

} // namespace

Command add_generators(CLI::App& app)
{
  const auto a = std::make_shared<Generator_arguments>();
  CLI::App* command = app.add_subcommand("generators", "find a meridian and a longitude around every handle");
  command->add_option("MESH", a->mesh, "the mesh file")->required();
  command
    ->add_option("-o,--output", a->out,
                 "the refined mesh, with the curves as line elements; its map back to MESH is written beside it")
    ->required()
    ->type_name("OUT.obj");
  command->add_option("--view", a->view, "write a page that shows the curves in a browser")->type_name("FILE");
  command->add_option("--curves", a->curves, "write the curves alone as OBJ lines")->type_name("FILE");
  add_choice(*command, "--map", a->map, "how the map back to MESH is written");
  add_common_options(*command, *a);
  command->add_flag("--repair", a->repair, repair_help);
  add_field_options(*command, *a);
  add_choice(*command, "--basis", a->basis, "what the curves are");
  add_choice(*command, "--longitudes", a->longitudes, "how longitudes are looked for");
  add_choice(*command, "--mode", a->mode, "what the field does at the boundary")->group("The field");
  command->add_flag("--complex", a->complex, "show the flow lines of the field in --view and write them to --curves");
  command->add_flag("--no-tighten", a->no_tighten, "leave the curves as they were found");
  return {command, [a, command] {
            note_field_options(*command, *a);
            return run_generators(*a);
          }};
}

} // namespace program
} // namespace meridian
