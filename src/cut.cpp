// SPDX-License-Identifier: GPL-3.0-or-later
#include "Terminal.h"
#include "field_arguments.h"
#include "files/Output_files.h"
#include "files/write_mesh.h"
#include "instances.h"
#include "page/format_page.h"
#include "report.h"

#include <meridian/assemble_result.h>

#include <chrono>
#include <iostream>
#include <sstream>

namespace meridian {
namespace program {

namespace {

// The options for one component.
Cut_options options_for(const Cut_arguments& a, const Surface_component& c, std::size_t place)
{
  Cut_options o;
  set_field_options(a, c, place, o, o.preference);
  o.method = a.method == "generators" ? Cut_method::GENERATORS : a.method == "morse" ? Cut_method::MORSE : Cut_method::CONTOURS;
  o.join = a.join == "complex" ? Generator_join::COMPLEX : a.join == "saddles" ? Generator_join::SADDLES : Generator_join::SURFACE;
  o.link_domain = a.links == "plane" ? Link_domain::PLANE : Link_domain::SURFACE;
  o.links.bifurcations = a.bifurcations;
  const auto source = a.has_source ? find_local({a.source}, c) : std::vector<Index>();
  o.links.source = source.empty() ? -1 : source.front();
  return o;
}

std::vector<Result_curve> name_curves(const std::vector<Disc_cut>& cuts, const Assembled_result& assembled)
{
  std::vector<Result_curve> meridians, longitudes, lines, links, boundaries;
  const auto add = [&](std::vector<Result_curve>& curves, const char* kind, const std::vector<Index>& path, std::size_t component, bool closed) {
    Result_curve c{kind + ("_" + std::to_string(curves.size())), {}, {}};
    for (Index v : path) { c.points.push_back(assembled.place[component][v]); }
    if (closed) { c.points.push_back(c.points.front()); }
    curves.push_back(std::move(c));
  };
  for (std::size_t i = 0; i < cuts.size(); ++i)
  {
    for (const auto& m : cuts[i].meridians) { add(meridians, "meridian", m, i, true); }
    for (const auto& l : cuts[i].longitudes) { add(longitudes, "longitude", l, i, true); }
    for (const auto& l : cuts[i].flow_lines) { add(lines, "flow_line", l, i, false); }
    for (const auto& l : cuts[i].links) { add(links, "link", l, i, false); }
    for (const auto& loop : boundary_loops(cuts[i].surface))
    {
      std::vector<Index> path;
      for (Index h : loop) { path.push_back(cuts[i].surface.source(h)); }
      add(boundaries, "boundary", path, i, true);
    }
  }
  for (const auto* more : {&longitudes, &lines, &links, &boundaries}) { meridians.insert(meridians.end(), more->begin(), more->end()); }
  return meridians;
}

std::string format_view(const std::string& title, const Examination& examination, const std::vector<Disc_cut>& cuts, const Assembled_result& assembled)
{
  std::vector<page::Part> parts;
  std::vector<page::Curve> curves;
  int genus = 0, loops = 0;
  double length = 0;
  for (std::size_t i = 0; i < cuts.size(); ++i)
  {
    parts.push_back({examination.components[i].surface, cuts[i].surface, cuts[i].field});
    for (const auto& m : cuts[i].meridians) { curves.push_back({page::Curve::MERIDIAN, i, m, true, "", {}}); }
    for (const auto& l : cuts[i].longitudes) { curves.push_back({page::Curve::MERIDIAN, i, l, true, "", {}}); }
    for (const auto& l : cuts[i].flow_lines) { curves.push_back({page::Curve::MERIDIAN, i, l, false, "", {}}); }
    for (const auto& l : cuts[i].links) { curves.push_back({page::Curve::OTHER, i, l, false, "", {}}); }
    genus += cuts[i].genus;
    loops += cuts[i].boundary_loops;
    length += examination.components[i].unit * cuts[i].length;
  }
  std::ostringstream caption;
  caption << cuts.size() << (cuts.size() == 1 ? " component" : " components") << ", genus " << genus << ", " << loops << " boundary loops; cut length " << length;
  return page::format_page(title, caption.str(), "links", parts, curves, assembled);
}

} // namespace

int run_cut(const Cut_arguments& arguments)
{
  files::check_writable_format(arguments.out);
  check_arguments(arguments);
  if (arguments.method != "contours" && arguments.links == "plane") { throw Usage_error("--links plane goes with --method contours"); }
  if (arguments.method != "generators" && arguments.join != "surface") { throw Usage_error("--join goes with --method generators"); }
  if (arguments.links == "plane" && arguments.bifurcations) { throw Usage_error("--bifurcations is for links on the surface; leave out --links plane"); }
  Terminal terminal(arguments.quiet);
  const auto now = [] { return std::chrono::steady_clock::now(); };
  const auto since = [&](auto begin) { return std::chrono::duration<double>(now() - begin).count(); };
  const Loaded_mesh loaded = load_mesh(arguments);
  const Polygon_soup& soup = loaded.soup;
  const Examination& examination = loaded.examination;
  if (arguments.has_source) { check_vertex("--source", arguments.source, examination); }
  std::vector<Disc_cut> cuts;
  std::vector<Cut_options> options;
  for (std::size_t i = 0; i < examination.components.size(); ++i)
  {
    options.push_back(options_for(arguments, examination.components[i], i));
    options.back().observer = &terminal;
  }
  for (std::size_t i = 0; i < examination.components.size(); ++i)
  {
    terminal.begin_component(i, examination.components.size());
    cuts.push_back(cut_to_disc(examination.components[i].surface, options[i]));
  }
  auto begin = now();
  const Assembled_result assembled = assemble_result(soup, examination, cuts);
  const double seconds_assembling = since(begin);
  terminal.stage_started(Stage::VERIFY);
  begin = now();
  const Verification verification = verify_cut(soup, assembled.mesh);
  const double seconds_verifying = since(begin);

  Json components = Json::array();
  double length = 0;
  int genus = 0, loops = 0;
  for (std::size_t i = 0; i < cuts.size(); ++i)
  {
    components.push_back(report_cut(cuts[i], examination.components[i], verification.components[i], options[i]));
    length += examination.components[i].unit * cuts[i].length;
    genus += cuts[i].genus;
    loops += cuts[i].boundary_loops;
  }
  const Json report{{"meridian", MERIDIAN_VERSION}, {"input", report_input(arguments.mesh, soup, examination)}, {"components", components},
                    {"seconds", {{"read", loaded.seconds_reading}, {"examine", loaded.seconds_examining}, {"assemble", seconds_assembling}, {"verify", seconds_verifying}}},
                    {"failures", verification.failures}, {"verified", static_cast<bool>(verification)}};

  files::Output_files out;
  if (!arguments.report.empty()) { out.add(arguments.report, format_report(report)); }
  if (verification)
  {
    out.add(arguments.out, files::format_mesh(arguments.out, assembled.mesh));
    out.add(files::map_path(arguments.out), files::format_map(assembled.mesh, files::Result_kind::CUT));
    if (!arguments.curves.empty()) { out.add(arguments.curves, files::format_curves(assembled.mesh.points, name_curves(cuts, assembled))); }
    if (!arguments.view.empty()) { out.add(arguments.view, format_view(arguments.mesh, examination, cuts, assembled)); }
  }
  if (is_interrupted()) { throw Cancelled("interrupted; nothing was written"); }
  out.commit();
  terminal.clear();

  for (const std::string& failure : verification.failures) { std::cerr << "meridian: not verified: " << failure << '\n'; }
  if (!arguments.quiet)
  {
    for (const std::string& repair : examination.repairs) { std::cout << "note: " << repair << '\n'; }
    for (std::size_t i = 0; i < cuts.size(); ++i)
      if (!cuts[i].link_note.empty()) { std::cout << "note: component " << i << ": links run on the surface, because " << cuts[i].link_note << '\n'; }
    std::cout << (verification ? "verified: " : "NOT verified, nothing but the report was written: ") << cuts.size()
              << (cuts.size() == 1 ? " component" : " components") << " (genus " << genus << ", boundary loops " << loops << "), each "
              << (verification ? "now a disc" : "expected to be a disc") << "; cut length " << length << '\n';
  }
  return verification ? VERIFIED : NOT_VERIFIED;
}

} // namespace program
} // namespace meridian
