// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut.h"

#include "end_run.h"
#include "files/map_file.h"
#include "files/write_mesh.h"
#include "memory.h"
#include "options.h"
#include "page/format_page.h"

#include <meridian/base/Progress_observer.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/base/Verification.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/names.h>
#include <meridian/base/run_both.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/cut/cut_to_disc.h>
#include <meridian/cut/join_generators.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/result/Assembled_result.h>
#include <meridian/result/assemble_result.h>
#include <meridian/result/name_curves.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/examine_surface.h>

#include <chrono>
#include <iostream>
#include <memory>
#include <sstream>
#include <type_traits>
#include <variant>

namespace meridian {
namespace program {

namespace {

double since(std::chrono::steady_clock::time_point begin)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// What a method makes use of.
struct Method_traits
{
  bool has_field = false, has_extrema = false, has_meridians = false, begins_at_vertex = false;
};

Method_traits traits_of(const Cut_method& method)
{
  return std::visit(
    [](const auto& m) -> Method_traits {
      using Method = std::decay_t<decltype(m)>;
      return {std::is_base_of_v<Field_options, Method>, std::is_base_of_v<Chosen_extrema, Method>,
              std::is_base_of_v<Meridian_options, Method>, internal::Has_source<Method>::value};
    },
    method);
}

// What is chosen whatever the mesh is.
Cut_options choices_of(const Cut_arguments& a)
{
  Cut_options o;
  o.method = a.method;
  o.tightening = a.tighten;
  o.on_edges = a.on_edges;
  o.refine_where_needed = a.refine_where_needed;
  o.link_domain = a.links;
  o.links.bifurcations = a.bifurcations;
  if (auto* generators = std::get_if<By_generators>(&o.method)) { generators->join = a.join; }
  if (auto* tree_cotree = std::get_if<By_tree_cotree>(&o.method)) { tree_cotree->bases = a.bases; }
  return o;
}

// The options for one component.
Cut_options options_for(const Cut_arguments& a, const Loaded_mesh& loaded, std::size_t place)
{
  const Surface_component& c = loaded.examination.components[place];
  Cut_options o = choices_of(a);
  const Field_options field = field_options(a, loaded, place);
  std::visit(
    [&](auto& method) {
      using Method = std::decay_t<decltype(method)>;
      if constexpr (std::is_base_of_v<Chosen_extrema, Method>) { static_cast<Chosen_extrema&>(method) = field; }
      if constexpr (std::is_base_of_v<Field_options, Method>) { method.field = field.field; }
      if constexpr (std::is_base_of_v<Meridian_options, Method>)
      {
        static_cast<Meridian_options&>(method) = meridian_options(a, loaded, place);
      }
      if constexpr (internal::Has_source<Method>::value) { method.source = a.has_from ? find_local(a.from, c) : -1; }
    },
    o.method);
  o.links.source = a.has_source ? find_local(a.source, c) : -1;
  return o;
}

std::string format_view(const std::string& title, const Examination& examination, const std::vector<Cut>& cuts,
                        const Assembled_result& assembled)
{
  std::vector<page::Part> parts;
  std::vector<page::Curve> curves;
  int genus = 0, loops = 0;
  double length = 0;
  for (std::size_t i = 0; i < cuts.size(); ++i)
  {
    parts.push_back({examination.components[i].surface, cuts[i].surface, cuts[i].field});
    for (const Named_curve& c : cuts[i].curves)
    {
      const bool goes_around =
        c.kind == Curve_kind::MERIDIAN || c.kind == Curve_kind::LONGITUDE || c.kind == Curve_kind::FLOW_LINE;
      curves.push_back({goes_around ? page::Curve::MERIDIAN : page::Curve::OTHER, i, c.vertices, c.is_closed, "", {}});
    }
    genus += cuts[i].genus;
    loops += cuts[i].boundary_loops;
    length += examination.components[i].unit * cuts[i].length;
  }
  std::ostringstream caption;
  caption << cuts.size() << (cuts.size() == 1 ? " component" : " components") << ", genus " << genus << ", " << loops
          << " boundary loops; cut length " << length;
  const bool has_paths =
    std::any_of(cuts.begin(), cuts.end(), [](const Cut& cut) { return !curves_of(cut, Curve_kind::PATH).empty(); });
  return page::format_page(title, caption.str(), has_paths ? "paths" : "links", parts, curves, assembled);
}

// Gives back the memory of what is in the result that was put together. The recount needs it.
void release_surfaces(std::vector<Cut>& cuts)
{
  for (Cut& cut : cuts)
  {
    cut.surface = Refined_surface();
    cut.opened = Opened_surface();
    cut.field = std::vector<double>();
  }
}

} // namespace

std::vector<Result_curve> name_curves(const std::vector<Cut>& cuts, const Assembled_result& assembled)
{
  std::vector<Result_curve> curves;
  const auto add = [&](const char* kind, int number, const std::vector<Index>& path, std::size_t component,
                       bool is_closed) {
    Result_curve c{kind + ("_" + std::to_string(number)), {}, {}};
    for (Index v : path) { c.points.push_back(assembled.place[component][v]); }
    if (is_closed) { c.points.push_back(c.points.front()); }
    curves.push_back(std::move(c));
  };
  for (const Curve_kind kind : all<Curve_kind>())
  {
    int number = 0;
    for (std::size_t i = 0; i < cuts.size(); ++i)
    {
      for (const Named_curve& c : curves_of(cuts[i], kind))
      {
        add(name_of(kind), number++, c.vertices, i, c.is_closed);
      }
    }
  }
  int number = 0;
  for (std::size_t i = 0; i < cuts.size(); ++i)
    for (const auto& loop : boundary_loops(cuts[i].surface))
    {
      std::vector<Index> path;
      for (Index h : loop) { path.push_back(cuts[i].surface.source(h)); }
      add("boundary", number++, path, i, true);
    }
  return curves;
}

void check_cut_arguments(const Cut_arguments& a)
{
  check_arguments(a);
  const auto forbid = [](bool is_wrong, const std::string& message) {
    if (is_wrong) { throw Usage_error(message); }
  };
  const Method_traits traits = traits_of(a.method);
  const std::string method = "method " + name_of(a.method);
  const bool is_distance = std::holds_alternative<Distance_field>(a.field);
  forbid(a.join != Generator_join::SURFACE && !std::holds_alternative<By_generators>(a.method),
         "a way to join pairs goes with method generators; " + method + " has no pairs");
  forbid(!traits.has_field && (!a.values.empty() || !std::holds_alternative<Harmonic_field>(a.field)),
         method + " has a field of its own or none; leave out the values");
  forbid(a.has_from && !is_distance && !traits.begins_at_vertex,
         "a vertex to begin at goes with method geodesic or tree-cotree, not with " + method);
  forbid(!traits.has_extrema
           && (!a.minima.empty() || !a.maxima.empty() || a.weights != Weights::POSITIVE || a.levels != Levels::SADDLE),
         "methods that cut edges have no field, no meridians and no links; " + method + " is one of them");
  Cut_options choices = choices_of(a);
  if (a.has_source) { choices.links.source = a.source; }
  try
  {
    check(choices);
  }
  catch (const Invalid_input_error& e)
  {
    throw Usage_error(e.what());
  }
  forbid(!(traits.has_meridians && !std::holds_alternative<By_generators>(a.method)) && a.links == Link_domain::PLANE,
         "--links plane goes with --method contours or geodesic");
  forbid(!traits.has_meridians && (a.prefer != Prefer::GAUSSIAN_CURVATURE || a.levels != Levels::SADDLE),
         "this --method has no meridians to choose; leave out --prefer and --levels");
  forbid(!traits.has_field && (a.weights != Weights::POSITIVE || a.has_extrema),
         "this --method has a field of its own or none; leave out --weights and --extrema");
  forbid(a.has_bases && (!std::holds_alternative<By_tree_cotree>(a.method) || a.has_from),
         "--bases goes with --method tree-cotree, and without --from");
}

std::vector<Cut_options> cut_options(const Cut_arguments& arguments, const Loaded_mesh& loaded, Terminal& terminal)
{
  if (arguments.has_source) { check_vertex("--source", arguments.source, loaded.examination); }
  std::vector<Cut_options> options;
  for (std::size_t i = 0; i < loaded.examination.components.size(); ++i)
  {
    options.push_back(options_for(arguments, loaded, i));
    options.back().observer = &terminal;
  }
  return options;
}

Cut_result conclude_cut(const Loaded_mesh& loaded, std::vector<Cut> cuts, const std::vector<Cut_options>& options,
                        Terminal& terminal)
{
  return conclude_cut(loaded, std::move(cuts), options, terminal,
                      [&](const Assembled_result& assembled) { return verify_cut(loaded.soup, assembled.mesh); });
}

Cut_result conclude_cut(const Loaded_mesh& loaded, std::vector<Cut> cuts, const std::vector<Cut_options>& options,
                        Terminal& terminal, const Recount& recount)
{
  Cut_result r = assemble_cut(loaded, std::move(cuts), options);
  verify(r, terminal, recount);
  return r;
}

Cut_result assemble_cut(const Loaded_mesh& loaded, std::vector<Cut> cuts, const std::vector<Cut_options>& options)
{
  Cut_result r;
  r.cuts = std::move(cuts);
  const auto begin = std::chrono::steady_clock::now();
  r.assembled = assemble_result(loaded.soup, loaded.examination, r.cuts);
  r.seconds_assembling = since(begin);
  for (std::size_t i = 0; i < r.cuts.size(); ++i)
  {
    const Surface_component& c = loaded.examination.components[i];
    r.components.push_back(report_cut(r.cuts[i], c, options[i]));
    r.length += c.unit * r.cuts[i].length;
    r.genus += r.cuts[i].genus;
    r.loops += r.cuts[i].boundary_loops;
  }
  return r;
}

void verify(Cut_result& r, Terminal& terminal, const Recount& recount)
{
  terminal.stage_started(Stage::VERIFY);
  const auto begin = std::chrono::steady_clock::now();
  r.verification = recount(r.assembled);
  r.seconds_verifying = since(begin);
  for (std::size_t i = 0; i < r.cuts.size(); ++i) { add_counts(r.components[i], r.verification.components[i]); }
}

Json report_seconds(const Loaded_mesh& loaded, const Cut_result& result)
{
  return {{"read", loaded.seconds_reading},
          {"examine", loaded.seconds_examining},
          {"assemble", result.seconds_assembling},
          {"verify", result.seconds_verifying}};
}

void add_cut(files::Output_files& out, const Cut_arguments& arguments, const Loaded_mesh& loaded,
             const Cut_result& result)
{
  const Result_mesh& mesh = result.assembled.mesh;
  give_back_memory(); // before texts as long as this
  std::string opened, map;
  internal::run_both([&] { map = files::format_map(mesh, files::Result_kind::CUT, arguments.map); },
                     [&] { opened = files::format_mesh(arguments.out, mesh); });
  out.add(arguments.out, opened);
  out.add(files::map_path(arguments.out, arguments.map), map);
  if (!arguments.curves.empty())
  {
    out.add(arguments.curves, files::format_curves(mesh.points, name_curves(result.cuts, result.assembled)));
  }
  if (!arguments.view.empty())
  {
    out.add(arguments.view, format_view(arguments.mesh, loaded.examination, result.cuts, result.assembled));
  }
}

int run_cut(const Cut_arguments& arguments)
{
  files::check_writable_format(arguments.out);
  check_cut_arguments(arguments);
  give_back_largest();
  Terminal terminal(arguments.quiet);
  const Loaded_mesh loaded = load_mesh(arguments);
  const Examination& examination = loaded.examination;
  const std::vector<Cut_options> options = cut_options(arguments, loaded, terminal);
  std::vector<Cut> found;
  for (std::size_t i = 0; i < examination.components.size(); ++i)
  {
    terminal.begin_component(i, examination.components.size());
    found.push_back(cut_to_disc(examination.components[i].surface, options[i]));
  }
  Cut_result result = assemble_cut(loaded, std::move(found), options);
  if (arguments.curves.empty() && arguments.view.empty()) { release_surfaces(result.cuts); }
  verify(result, terminal, [&](const Assembled_result& assembled) { return verify_cut(loaded.soup, assembled.mesh); });
  const Verification& verification = result.verification;
  const Json report{
    {"meridian", MERIDIAN_VERSION},      {"input", report_input(arguments.mesh, loaded.soup, examination)},
    {"components", result.components},   {"seconds", report_seconds(loaded, result)},
    {"failures", verification.failures}, {"verified", static_cast<bool>(verification)}};

  files::Output_files out;
  if (!arguments.report.empty()) { out.add(arguments.report, format_report(report)); }
  if (verification) { add_cut(out, arguments, loaded, result); }
  Last_words words{examination.repairs, {}, ""};
  for (std::size_t i = 0; i < result.cuts.size(); ++i)
    if (!result.cuts[i].link_note.empty())
    {
      words.notes.push_back("note: component " + std::to_string(i) + ": links run on the surface, because "
                            + result.cuts[i].link_note);
    }
  std::ostringstream summary;
  summary << result.cuts.size() << (result.cuts.size() == 1 ? " component" : " components") << " (genus "
          << result.genus << ", boundary loops " << result.loops << "), each "
          << (verification ? "now a disc" : "expected to be a disc") << "; cut length " << result.length;
  words.summary = summary.str();
  return end_run(arguments, verification, out, terminal, words);
}

Command add_cut(CLI::App& app)
{
  const auto a = std::make_shared<Cut_arguments>();
  CLI::App* command = app.add_subcommand("cut", "open a mesh into a disc, one for each component, along a cut graph");
  command->add_option("MESH", a->mesh, "the mesh file")->required();
  command
    ->add_option("-o,--output", a->out,
                 "the opened mesh: OFF, OBJ, PLY or VTP; its map back to MESH is written beside it")
    ->required()
    ->type_name("OUT");
  add_cut_options(*command, *a, Tightening::GRAPH,
                  "; curves, with --family or where another option says how curves run");
  command
    ->add_option("--family", a->family,
                 "find N different cuts: fields, preferences, levels and methods change. They are written to OUT with "
                 "a number before its ending")
    ->check(CLI::Range(1, 1000000000))
    ->type_name("N");
  return {command, [a, command] {
            note_cut_options(*command, *a);
            return a->family > 0 ? run_family(*a) : run_cut(*a);
          }};
}

} // namespace program
} // namespace meridian
