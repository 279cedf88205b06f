// SPDX-License-Identifier: GPL-3.0-or-later
#include "Terminal.h"
#include "field_arguments.h"
#include "files/Output_files.h"
#include "files/write_mesh.h"
#include "page/format_page.h"
#include "report.h"

#include <meridian/assemble_result.h>
#include <meridian/classify_generators.h>

#include <chrono>
#include <iostream>
#include <sstream>

namespace meridian {
namespace program {

namespace {

Generator_options options_for(const Generator_arguments& a, const Surface_component& c, std::size_t place)
{
  Generator_options o;
  set_field_options(a, c, place, o, o.preference);
  o.tighten = !a.no_tighten;
  return o;
}

std::string format_view(const std::string& title, const Examination& examination, const std::vector<Generators>& all, const Assembled_result& assembled)
{
  std::vector<page::Part> parts;
  std::vector<page::Curve> curves;
  int handle = 0, loops = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    parts.push_back({examination.components[i].surface, all[i].surface, all[i].field});
    for (const Generator_pair& pair : all[i].pairs)
    {
      const std::string number = std::to_string(handle++);
      curves.push_back({page::Curve::MERIDIAN, i, pair.meridian.vertices, true, number});
      curves.push_back({page::Curve::OTHER, i, pair.longitude.vertices, true, number});
    }
    loops += all[i].boundary_loops;
  }
  std::ostringstream caption;
  caption << all.size() << (all.size() == 1 ? " component" : " components") << ", " << handle << (handle == 1 ? " handle" : " handles")
          << ", " << loops << " boundary loops";
  return page::format_page(title, caption.str(), "longitudes", parts, curves, assembled);
}

} // namespace

int run_generators(const Generator_arguments& arguments)
{
  if (files::format_of(arguments.out) != "obj") { throw Usage_error(arguments.out + ": generators are written as OBJ, with a line element for each curve"); }
  check_arguments(arguments);
  Terminal terminal(arguments.quiet);
  const auto now = [] { return std::chrono::steady_clock::now(); };
  const auto since = [&](auto begin) { return std::chrono::duration<double>(now() - begin).count(); };
  auto begin = now();
  const Polygon_soup soup = files::read_mesh(arguments.mesh);
  const double seconds_reading = since(begin);
  heed_interrupts();

  begin = now();
  const Examination examination = examine_surface(soup, arguments.repair);
  const double seconds_examining = since(begin);
  check_vertices(arguments, examination);
  std::vector<Generator_options> options;
  for (std::size_t i = 0; i < examination.components.size(); ++i)
  {
    options.push_back(options_for(arguments, examination.components[i], i));
    options.back().observer = &terminal;
  }
  std::vector<Generators> all;
  for (std::size_t i = 0; i < examination.components.size(); ++i)
  {
    terminal.begin_component(i, examination.components.size());
    all.push_back(find_generators(examination.components[i].surface, options[i]));
    classify_generators(examination.components[i].surface, all.back(), &terminal);
  }
  begin = now();
  const Assembled_result assembled = assemble_result(soup, examination, all);
  const std::vector<Result_curve> curves = name_curves(all, assembled);
  const double seconds_assembling = since(begin);
  terminal.stage_started(Stage::VERIFY);
  begin = now();
  const Generator_verification verification = verify_generators(soup, assembled.mesh, curves);
  const double seconds_verifying = since(begin);

  Json components = Json::array();
  int genus = 0, loops = 0;
  double meridians = 0, longitudes = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const Curve_count count = i < verification.curves.size() ? verification.curves[i] : Curve_count{};
    components.push_back(report_generators(all[i], examination.components[i], count, options[i], genus));
    for (const Generator_pair& pair : all[i].pairs)
    {
      meridians += examination.components[i].unit * pair.meridian.length;
      longitudes += examination.components[i].unit * pair.longitude.length;
    }
    genus += all[i].genus;
    loops += all[i].boundary_loops;
  }
  const Json report{{"meridian", MERIDIAN_VERSION}, {"input", report_input(arguments.mesh, soup, examination)}, {"components", components},
                    {"seconds", {{"read", seconds_reading}, {"examine", seconds_examining}, {"assemble", seconds_assembling}, {"verify", seconds_verifying}}},
                    {"failures", verification.failures}, {"verified", static_cast<bool>(verification)}};

  files::Output_files out;
  if (!arguments.report.empty()) { out.add(arguments.report, format_report(report)); }
  if (verification)
  {
    out.add(arguments.out, files::format_mesh_with_curves(assembled.mesh, curves));
    out.add(files::map_path(arguments.out), files::format_map(assembled.mesh, files::Result_kind::GENERATORS));
    if (!arguments.curves.empty()) { out.add(arguments.curves, files::format_curves(assembled.mesh.points, curves)); }
    if (!arguments.view.empty()) { out.add(arguments.view, format_view(arguments.mesh, examination, all, assembled)); }
  }
  if (is_interrupted()) { throw Cancelled("interrupted; nothing was written"); }
  out.commit();
  terminal.clear();

  for (const std::string& failure : verification.failures) { std::cerr << "meridian: not verified: " << failure << '\n'; }
  if (!arguments.quiet)
  {
    for (const std::string& repair : examination.repairs) { std::cout << "note: " << repair << '\n'; }
    std::cout << (verification ? "verified: " : "NOT verified, nothing but the report was written: ") << genus << (genus == 1 ? " handle" : " handles") << " on "
              << all.size() << (all.size() == 1 ? " component" : " components") << " (boundary loops " << loops << "); meridians " << meridians
              << ", longitudes " << longitudes << '\n';
  }
  return verification ? VERIFIED : NOT_VERIFIED;
}

} // namespace program
} // namespace meridian
