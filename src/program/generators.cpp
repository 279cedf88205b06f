// SPDX-License-Identifier: GPL-3.0-or-later
#include "Terminal.h"
#include "field_arguments.h"
#include "files/Output_files.h"
#include "files/write_mesh.h"
#include "page/format_page.h"
#include "report.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Progress_observer.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/base/Verification.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/handles/Generators.h>
#include <meridian/handles/classify_generators.h>
#include <meridian/handles/find_generators.h>
#include <meridian/handles/find_shortest_basis.h>
#include <meridian/proof/verify_generators.h>
#include <meridian/result/assemble_result.h>
#include <meridian/result/name_curves.h>
#include <meridian/result/recount.h>
#include <meridian/surface/examine_surface.h>

#include <chrono>
#include <iostream>
#include <sstream>

namespace meridian {
namespace program {

namespace {

Generator_options options_for(const Generator_arguments& a, const Loaded_mesh& loaded, std::size_t place)
{
  Generator_options o;
  set_field_options(a, loaded, place, o, o.preference, o.levels);
  o.is_open = a.mode == "open";
  o.flow = a.longitudes == "flow";
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

} // namespace

int run_generators(const Generator_arguments& arguments)
{
  if (files::format_of(arguments.out) != "obj")
  {
    throw Usage_error(arguments.out + ": generators are written as OBJ, with a line element for each curve");
  }
  check_arguments(arguments);
  Terminal terminal(arguments.quiet);
  const Loaded_mesh loaded = load_mesh(arguments);
  const Polygon_soup& soup = loaded.soup;
  const Examination& examination = loaded.examination;
  Json components = Json::array();
  Outcome outcome;
  std::string summary, view;
  double length = 0;
  if (arguments.basis == "pairs")
  {
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
      all.push_back(find_generators(examination.components[i].surface, options[i]));
      classify_generators(examination.components[i].surface, all.back(), &terminal);
    }
    outcome = conclude(soup, examination, all, terminal);
    int handles = 0;
    double longitudes = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      components.push_back(
        report_generators(all[i], examination.components[i], outcome.verification.curves[i], options[i], handles));
      handles += all[i].genus;
      for (const Generator_pair& pair : all[i].pairs)
      {
        length += examination.components[i].unit * pair.meridian.length;
        longitudes += examination.components[i].unit * pair.longitude.length;
      }
    }
    std::ostringstream text;
    text << handles << (handles == 1 ? " handle" : " handles") << ", meridians " << length << ", longitudes "
         << longitudes;
    summary = text.str();
    if (!arguments.view.empty()) { view = format_view(arguments.mesh, examination, all, outcome.assembled); }
    for (std::size_t i = 0; i < all.size(); ++i)
      for (const auto& line : all[i].complex_lines)
      {
        outcome.lines.push_back(in_file(examination.components[i], line));
      }
  }
  else
  {
    std::vector<Homology_basis> all;
    for (std::size_t i = 0; i < examination.components.size(); ++i)
    {
      terminal.begin_component(i, examination.components.size());
      Basis_options options;
      options.tighten = !arguments.no_tighten;
      options.observer = &terminal;
      all.push_back(find_shortest_basis(examination.components[i].surface, options));
    }
    outcome = conclude(soup, examination, all, terminal);
    std::size_t loops = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      components.push_back(report_basis(all[i], examination.components[i], outcome.verification.curves[i]));
      loops += all[i].loops.size();
      for (const Generator_curve& loop : all[i].loops) { length += examination.components[i].unit * loop.length; }
    }
    std::ostringstream text;
    text << loops << " loops, length " << length;
    summary = text.str();
    if (!arguments.view.empty()) { view = format_view(arguments.mesh, examination, all, outcome.assembled); }
  }
  const Generator_verification& verification = outcome.verification;
  const Json report{
    {"meridian", MERIDIAN_VERSION},
    {"input", report_input(arguments.mesh, soup, examination)},
    {"components", components},
    {"seconds",
     {{"read", loaded.seconds_reading}, {"examine", loaded.seconds_examining}, {"verify", outcome.seconds_verifying}}},
    {"failures", verification.failures},
    {"verified", static_cast<bool>(verification)}};

  files::Output_files out;
  if (!arguments.report.empty()) { out.add(arguments.report, format_report(report)); }
  if (verification)
  {
    out.add(arguments.out, files::format_mesh_with_curves(outcome.assembled.mesh, outcome.curves));
    out.add(files::map_path(arguments.out),
            files::format_map(outcome.assembled.mesh, files::Result_kind::GENERATORS, outcome.curves));
    if (!arguments.curves.empty()) { out.add(arguments.curves, format_curves(outcome)); }
    if (!arguments.view.empty()) { out.add(arguments.view, view); }
  }
  if (is_interrupted()) { throw Cancelled("interrupted; nothing was written"); }
  out.commit();
  terminal.clear();

  for (const std::string& failure : verification.failures)
  {
    std::cerr << "meridian: not verified: " << failure << '\n';
  }
  if (!arguments.quiet)
  {
    for (const std::string& repair : examination.repairs) { std::cout << "note: " << repair << '\n'; }
    std::cout << (verification ? "verified: " : "NOT verified, nothing but the report was written: ")
              << examination.components.size()
              << (examination.components.size() == 1 ? " component: " : " components: ") << summary << '\n';
  }
  return verification ? VERIFIED : NOT_VERIFIED;
}

} // namespace program
} // namespace meridian
