// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "files/Output_files.h"
#include "files/write_mesh.h"
#include "page/format_page.h"
#include "report.h"

#include <meridian/assemble_result.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <set>

namespace meridian {
namespace program {

namespace {

// Shows the stage on a terminal, and ends the run when a signal came.
class Terminal : public Progress_observer
{
public:
  explicit Terminal(bool quiet) : m_is_shown(!quiet && isatty(STDERR_FILENO)) {}
  ~Terminal() override { clear(); }
  void begin_component(std::size_t i, std::size_t n) { m_place = n > 1 ? "component " + std::to_string(i + 1) + " of " + std::to_string(n) + ", " : ""; }
  void stage_progressed(Stage stage, double done) override
  {
    if (m_is_shown) { std::cerr << "\r\033[K" << m_place << name_of(stage) << ' ' << static_cast<int>(100 * done) << " %" << std::flush; }
  }
  void stage_started(Stage stage) override
  {
    if (m_is_shown) { std::cerr << "\r\033[K" << m_place << name_of(stage) << " ..." << std::flush; }
  }
  bool go_further() override { return !is_interrupted(); }
  void clear() { if (m_is_shown) { std::cerr << "\r\033[K" << std::flush; } }

private:
  bool m_is_shown;
  std::string m_place;
};

// No two outputs go to one file, and none to the input.
void check_paths(const Cut_arguments& a)
{
  const auto place = [](const std::string& path) { return std::filesystem::weakly_canonical(std::filesystem::absolute(path)).string(); };
  std::set<std::string> places{place(a.mesh)};
  for (const std::string& path : {a.out, files::map_path(a.out), a.report, a.view, a.curves})
    if (!path.empty() && !places.insert(place(path)).second)
      throw Usage_error(path + " would be written twice, or over the mesh that is read; give every file a name of its own");
}

void check_vertices(const Cut_arguments& a, const Examination& examination)
{
  const auto check = [&](const char* option, Index v) {
    for (const Surface_component& c : examination.components)
      if (std::binary_search(c.vertex_of.begin(), c.vertex_of.end(), v)) { return; }
    throw Usage_error(std::string(option) + ": no face of the mesh has a vertex " + std::to_string(v) + "; vertices are counted from 0");
  };
  for (Index v : a.minima) { check("--minimum", v); }
  for (Index v : a.maxima) { check("--maximum", v); }
  if (a.has_source) { check("--source", a.source); }
}

// The options for one component: vertices of the file that it does not have are left to the others.
Cut_options options_for(const Cut_arguments& a, const Surface_component& c, std::size_t place)
{
  const auto local = [&](const std::vector<Index>& vertices) {
    std::vector<Index> found;
    for (Index v : vertices)
    {
      const auto at = std::lower_bound(c.vertex_of.begin(), c.vertex_of.end(), v);
      if (at != c.vertex_of.end() && *at == v) { found.push_back(static_cast<Index>(at - c.vertex_of.begin())); }
    }
    return found;
  };
  Cut_options o;
  o.weights = a.weights == "cotangent" ? Weights::COTANGENT : a.weights == "mean-value" ? Weights::MEAN_VALUE : Weights::POSITIVE;
  o.minima = local(a.minima);
  o.maxima = local(a.maxima);
  if (c.genus() > 0 && o.minima.empty() != o.maxima.empty())
    throw Usage_error("--minimum and --maximum go together: component " + std::to_string(place) + " has one of them and needs the other");
  if (c.genus() > 0 && !o.minima.empty())
  {
    const Node_graph g = make_node_graph(c.surface);
    for (Index v : o.minima)
      for (Index w : o.maxima)
        if (g.node[v] == g.node[w])
          throw Usage_error("--minimum " + std::to_string(c.vertex_of[v]) + " and --maximum " + std::to_string(c.vertex_of[w])
                            + (v == w ? " are one vertex" : " lie on one boundary loop, which is one place of the field") + "; choose them apart");
  }
  if (a.prefer == "mean-curvature") { o.preference = preference::mean_curvature; }
  if (a.prefer == "length") { o.preference = preference::short_length; }
  if (a.prefer == "position") { o.preference = preference::position({a.direction[0], a.direction[1], a.direction[2]}); }
  o.link_domain = a.links == "plane" ? Link_domain::PLANE : Link_domain::SURFACE;
  o.links.bifurcations = a.bifurcations;
  const auto source = a.has_source ? local({a.source}) : std::vector<Index>();
  o.links.source = source.empty() ? -1 : source.front();
  return o;
}

std::vector<files::Named_curve> name_curves(const std::vector<Disc_cut>& cuts, const Assembled_result& assembled)
{
  std::vector<files::Named_curve> meridians, links, boundaries;
  const auto add = [&](std::vector<files::Named_curve>& curves, const char* kind, const std::vector<Index>& path, std::size_t component, bool closed) {
    files::Named_curve c{kind + ("_" + std::to_string(curves.size())), {}};
    for (Index v : path) { c.points.push_back(assembled.place[component][v]); }
    if (closed) { c.points.push_back(c.points.front()); }
    curves.push_back(std::move(c));
  };
  for (std::size_t i = 0; i < cuts.size(); ++i)
  {
    for (const auto& m : cuts[i].meridians) { add(meridians, "meridian", m, i, true); }
    for (const auto& l : cuts[i].links) { add(links, "link", l, i, false); }
    for (const auto& loop : boundary_loops(cuts[i].surface))
    {
      std::vector<Index> path;
      for (Index h : loop) { path.push_back(cuts[i].surface.source(h)); }
      add(boundaries, "boundary", path, i, true);
    }
  }
  meridians.insert(meridians.end(), links.begin(), links.end());
  meridians.insert(meridians.end(), boundaries.begin(), boundaries.end());
  return meridians;
}

} // namespace

int run_cut(const Cut_arguments& arguments)
{
  files::check_writable_format(arguments.out);
  check_paths(arguments);
  if (arguments.links == "plane" && arguments.bifurcations) { throw Usage_error("--bifurcations is for links on the surface; leave out --links plane"); }
  if (arguments.has_direction && arguments.prefer != "position") { throw Usage_error("--direction goes with --prefer position"); }
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
    cuts.push_back(cut_to_disc(examination.components[i].surface, options.back()));
  }
  begin = now();
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
                    {"seconds", {{"read", seconds_reading}, {"examine", seconds_examining}, {"assemble", seconds_assembling}, {"verify", seconds_verifying}}},
                    {"failures", verification.failures}, {"verified", static_cast<bool>(verification)}};

  files::Output_files out;
  if (!arguments.report.empty()) { out.add(arguments.report, format_report(report)); }
  if (verification)
  {
    out.add(arguments.out, files::format_mesh(arguments.out, assembled.mesh));
    out.add(files::map_path(arguments.out), files::format_map(assembled.mesh));
    if (!arguments.curves.empty()) { out.add(arguments.curves, files::format_curves(assembled.mesh.points, name_curves(cuts, assembled))); }
    if (!arguments.view.empty()) { out.add(arguments.view, page::format_page(arguments.mesh, examination, cuts, assembled)); }
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
