// SPDX-License-Identifier: GPL-3.0-or-later
#include "arguments.h"
#include "check_paths.h"
#include "cut.h"
#include "end_run.h"
#include "files/Mesh_format.h"
#include "files/read_pins.h"
#include "given_seams.h"
#include "kept_out.h"
#include "options.h"
#include "pins.h"
#include "unwrap_run.h"

#include <meridian/base/Result_mesh.h>
#include <meridian/base/Verification.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/map/pack_charts.h>
#include <meridian/map/planar_map.h>
#include <meridian/proof/Padding.h>
#include <meridian/proof/verify_packing.h>
#include <meridian/proof/verify_unwrapping.h>
#include <meridian/result/Assembled_result.h>
#include <meridian/surface/examine_surface.h>
#include <meridian/unwrap/Unwrapping.h>
#include <meridian/unwrap/pack_unwrappings.h>
#include <meridian/unwrap/unwrap_surface.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <sstream>

namespace meridian {
namespace program {

namespace {

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
  const auto has_blank = [](const std::string& path) { return path.find(' ', path.rfind('/') + 1) != path.npos; };
  forbid(
    !a.texture.empty() && (has_blank(a.out) || has_blank(a.texture)),
    "with --png, OUT and the material beside it name each other's files, and a blank ends such a name; leave it out");
  const auto format = files::format_of(a.distortion);
  forbid(!a.distortion.empty() && !(format && files::holds_face_values(*format)),
         "--distortion writes PLY or VTP, which can hold values of faces");
  const auto format_of_doubled = files::format_of(a.doubled);
  forbid(!a.doubled.empty() && !(format_of_doubled && files::holds_face_values(*format_of_doubled)),
         "--doubled writes PLY or VTP, which can hold texture coordinates of vertices");
  forbid(a.charts != 1 && a.geometry_image > 0, "--geometry-image is one chart; leave out --charts");
  forbid(a.charts != 1 && (a.family > 1 || a.stretch_weight > 0),
         "--family and --stretch-weight compare cuts into one chart; leave out --charts");
  check_padding(a.packing);
  forbid(a.packing.tiles > 1 && !(a.layout.empty() && a.view.empty()),
         "--svg and --view show one texture; leave out --tiles");
  forbid(a.packing.density > 0 && a.geometry_image > 0, "a geometry image fills its square; leave out --density");
  forbid(a.packing.resolution[0] != a.packing.resolution[1] && a.geometry_image > 0,
         "a geometry image is a square; so is its --resolution");
  const bool has_seams = has_given_seams(a), has_wishes = has_seams || !a.keep_out.empty();
  forbid(a.seams.compare(0, 6, "sharp:") == 0 && !is_kind_of_seam(a.seams),
         "--seams sharp:ANGLE takes an angle in degrees, more than 0 and less than 180");
  forbid(!a.pins.empty() && (a.packing.density > 0 || a.is_symmetric || a.geometry_image > 0),
         "pins say where charts are, and how large; leave out --density, --symmetry and --geometry-image");
  forbid(!a.pins.empty() && (a.family > 1 || a.stretch_weight > 0),
         "--family and --stretch-weight compare cuts; leave out --pin");
  forbid(a.is_symmetric && (has_wishes || a.geometry_image > 0 || a.family > 1 || a.stretch_weight > 0),
         "--symmetry has seams of its own; leave out --seams, --chart-per, --keep-out, --family, --stretch-weight and "
         "--geometry-image");
  forbid(has_wishes && a.geometry_image > 0,
         "--geometry-image has a cut of its own; leave out --seams, --chart-per and --keep-out");
  forbid(has_wishes && (a.family > 1 || a.stretch_weight > 0),
         "--family and --stretch-weight compare cuts; leave out --seams, --chart-per and --keep-out");
  if (a.geometry_image > 0)
  {
    forbid(a.on_edges, "--geometry-image divides edges at the corners of the square; leave out --on-edges");
    forbid((a.has_border && a.border != Map_border::SQUARE) || !takes_polygon(a.parameterization),
           "--geometry-image maps into a square with --parameterization symmetric-dirichlet, conformal, stretch or "
           "positive");
  }
}

// The arguments for each mesh, checked.
std::vector<Unwrap_arguments> arguments_of_each(const Unwrap_arguments& a)
{
  const std::size_t n = a.meshes.size();
  const auto forbid = [](bool is_wrong, const std::string& message) {
    if (is_wrong) { throw Usage_error(message); }
  };
  forbid(a.outs.size() != n, "as many names are needed behind -o as there are meshes: " + std::to_string(n));
  const bool has_seams_of_one = !a.seams.empty() && !is_kind_of_seam(a.seams);
  for (const std::string& path : {a.view, a.curves, a.layout, a.texture, a.distortion, a.doubled})
  {
    forbid(n > 1 && !path.empty(),
           "pictures, curves, pages and doubled vertices are of one mesh; leave them out for several");
  }
  forbid(n > 1 && (a.geometry_image > 0 || has_seams_of_one || names_file_of_kept_out(a) || !a.pins.empty()),
         "geometry images, and files for --seams, --keep-out and --pin, are of one mesh; leave them out for several");
  std::vector<Unwrap_arguments> each(n, a);
  std::vector<std::string> written{a.report}, read = a.meshes;
  read.push_back(has_seams_of_one ? a.seams : "");
  read.push_back(names_file_of_kept_out(a) ? a.keep_out : "");
  read.push_back(a.pins);
  for (std::size_t i = 0; i < n; ++i)
  {
    each[i].mesh = a.meshes[i];
    each[i].out = a.outs[i];
    check_unwrap_arguments(each[i]);
    const std::vector<std::string> own = written_for(each[i]);
    written.insert(written.end(), own.begin(), own.end());
  }
  for (const std::string& path : files_read_for(a)) { read.push_back(path); }
  check_paths(read, written);
  return each;
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
  o.is_symmetric = a.is_symmetric;
  return o;
}

// The options of each component.
std::vector<Unwrap_options> unwrap_options(const Unwrap_arguments& arguments, const Loaded_mesh& loaded,
                                           const std::vector<Cut_options>& cuts)
{
  std::vector<std::vector<Index>> seams = find_given_seams(arguments, loaded);
  std::vector<std::vector<Index>> keep_out = find_kept_out(arguments, loaded);
  std::vector<Unwrap_options> options;
  for (std::size_t i = 0; i < cuts.size(); ++i)
  {
    options.push_back(unwrap_options(arguments, cuts[i]));
    options.back().seams = std::move(seams[i]);
    options.back().keep_out = std::move(keep_out[i]);
    if (cuts.size() > 1) { options.back().filled = 0; } // they fill the square together
  }
  return options;
}

// Reads, cuts and maps.
Unwrap_run start_run(const Unwrap_arguments& arguments, Terminal& terminal)
{
  Unwrap_run run{arguments, load_mesh(arguments, true), {}, {}, {}, {}, {}, {}, {}, {}};
  if (!arguments.pins.empty()) { run.pins = files::read_pins(arguments.pins, run.loaded.soup.points.size()); }
  move_libraries(arguments, run.loaded.attributes.libraries);
  const auto& components = run.loaded.examination.components;
  if (arguments.geometry_image > 0 && components.size() > 1)
    throw Invalid_input_error("a geometry image holds one component; the mesh has "
                              + std::to_string(components.size()));
  const std::vector<Cut_options> cuts = cut_options(arguments, run.loaded, terminal);
  run.options = unwrap_options(arguments, run.loaded, cuts);
  keep_out_of_pins(run);
  std::vector<Cut> found;
  for (std::size_t i = 0; i < components.size(); ++i)
  {
    terminal.begin_component(i, components.size());
    run.unwrapped.push_back(unwrap_surface(components[i].surface, run.options[i]));
    found.push_back(std::move(run.unwrapped.back().cut));
  }
  run.result = assemble_cut(run.loaded, std::move(found), cuts);
  return run;
}

// Gives the vertices of a result their texture coordinates, and its faces their charts, if a component has several.
void place_texture(Unwrap_run& run)
{
  Assembled_result& assembled = run.result.assembled;
  run.texture.assign(assembled.mesh.points.size(), {0, 0});
  std::vector<std::int32_t> chart_of(assembled.mesh.points.size(), 0); // each vertex
  std::size_t charts = 0;
  for (std::size_t i = 0; i < run.unwrapped.size(); ++i)
  {
    const Unwrapping& u = run.unwrapped[i];
    const std::vector<Index>& place = assembled.place[i];
    for (std::size_t v = 0; v < u.map.at.size(); ++v) { run.texture[place[v]] = u.map.at[v]; }
    for (std::size_t f = 0; f < u.disc.triangles.size(); ++f)
    {
      const std::size_t chart = charts + (u.chart_of.empty() ? 0 : static_cast<std::size_t>(u.chart_of[f]));
      for (Index v : u.disc.triangles[f]) { chart_of[place[v]] = static_cast<std::int32_t>(chart); }
    }
    charts += u.charts;
  }
  if (charts == run.unwrapped.size()) { return; }
  for (const auto& face : assembled.mesh.faces) { assembled.mesh.chart_of.push_back(chart_of[face[0]]); }
}

// Packs the maps of all components of all meshes into one texture.
void pack(const Unwrap_arguments& arguments, std::vector<Unwrap_run>& runs)
{
  if (arguments.geometry_image == 0) // whose square stays as it is
  {
    std::vector<Unwrapping> all;
    std::vector<double> units;
    for (Unwrap_run& run : runs)
    {
      std::move(run.unwrapped.begin(), run.unwrapped.end(), std::back_inserter(all));
      for (const Surface_component& c : run.loaded.examination.components) { units.push_back(c.unit); }
    }
    const double by_itself = arguments.charts == 0 ? default_max_stretch_of_charts : default_max_stretch;
    pack_unwrappings(all, units, arguments.packing, arguments.max_stretch.value_or(by_itself), texture_pins(runs));
    auto next = all.begin();
    for (Unwrap_run& run : runs)
      for (Unwrapping& u : run.unwrapped) { u = std::move(*next++); }
  }
  for (Unwrap_run& run : runs) { place_texture(run); }
}

// Recounts a mesh, and reports it.
void conclude(Unwrap_run& run, Terminal& terminal)
{
  const Unwrap_arguments& arguments = run.arguments;
  verify(run.result, terminal, [&](const Assembled_result& assembled) {
    return verify_unwrapping(run.loaded.soup, assembled.mesh, run.texture, padding_of(arguments.packing),
                             arguments.packing.tiles);
  });
  report_run(run);
}

// Whether charts of different meshes are apart in the texture that they share.
Verification verify_atlas(const std::vector<Unwrap_run>& runs)
{
  constexpr double least_gap = 1e-12; // where none is asked for
  std::vector<std::array<Index, 3>> faces;
  std::vector<Plane_point> texture;
  for (const Unwrap_run& run : runs)
  {
    const auto first = static_cast<Index>(texture.size());
    for (const auto& f : run.result.assembled.mesh.faces)
    {
      faces.push_back({f[0] + first, f[1] + first, f[2] + first});
    }
    texture.insert(texture.end(), run.texture.begin(), run.texture.end());
  }
  const Pack_options& packing = runs.front().arguments.packing;
  Padding padding = padding_of(packing);
  padding.texels = std::max(padding.texels, least_gap);
  return verify_packing(faces, texture, padding, packing.tiles);
}

// The words of one mesh among several.
void append(Last_words& words, const std::string& mesh, const Last_words& of_mesh)
{
  const auto add = [&](std::vector<std::string>& all, const std::vector<std::string>& more) {
    for (const std::string& line : more) { all.push_back(mesh + ": " + line); }
  };
  add(words.repairs, of_mesh.repairs);
  add(words.notes, of_mesh.notes);
  add(words.missed, of_mesh.missed);
  words.notes.push_back(mesh + ": " + of_mesh.summary);
}

// Several meshes in one texture.
int conclude_atlas(const Unwrap_arguments& arguments, std::vector<Unwrap_run>& runs, Terminal& terminal)
{
  Verification all = verify_atlas(runs);
  for (Unwrap_run& run : runs)
  {
    conclude(run, terminal);
    for (const std::string& failure : run.result.verification.failures)
    {
      all.failures.push_back(run.arguments.mesh + ": " + failure);
    }
  }
  files::Output_files out;
  Last_words words;
  Json reports = Json::array();
  double filled = 0;
  for (Unwrap_run& run : runs)
  {
    if (!all) { run.result.verification.failures.emplace_back("a mesh of the same texture is not verified"); }
    if (run.result.verification) { add_files(out, run); }
    append(words, run.arguments.mesh, words_of(run));
    reports.push_back(run.report);
    filled += area_of(run.result.assembled.mesh.faces, run.texture);
  }
  const Json report{{"meridian", MERIDIAN_VERSION},
                    {"meshes", reports},
                    {"failures", all.failures},
                    {"verified", all && words.missed.empty()}};
  if (!arguments.report.empty()) { out.add(arguments.report, format_report(report)); }
  std::ostringstream summary;
  summary << runs.size() << " meshes in one texture, " << filled << " of it filled";
  words.summary = summary.str();
  return end_run(arguments, all, out, terminal, words);
}

int run_unwrap(const Unwrap_arguments& arguments)
{
  const std::vector<Unwrap_arguments> each = arguments_of_each(arguments);
  Terminal terminal(arguments.quiet);
  std::vector<Unwrap_run> runs;
  runs.reserve(each.size());
  for (const Unwrap_arguments& a : each) try
    {
      runs.push_back(start_run(a, terminal));
    }
    catch (const Invalid_input_error& e)
    {
      if (each.size() == 1) { throw; }
      throw Invalid_input_error(a.mesh + ": " + e.what());
    }
  pack(arguments, runs);
  if (runs.size() > 1) { return conclude_atlas(arguments, runs, terminal); }
  Unwrap_run& run = runs.front();
  conclude(run, terminal);
  files::Output_files out;
  if (run.result.verification) { add_files(out, run); }
  if (!arguments.report.empty()) { out.add(arguments.report, format_report(run.report)); }
  return end_run(arguments, run.result.verification, out, terminal, words_of(run));
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
    .add_option("--doubled", a.doubled,
                "write the mesh as PLY or VTP with a vertex for each of its texture coordinates, and its number in OUT")
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
  exclude_ways_to_cut(
    command, *command
                .add_option("--keep-out", a.keep_out,
                            "lead no seam over faces all of whose corners are marked, where that can be:"
                            "\n  red, painted in that colour"
                            "\n  FILE, a text file of numbers, one a vertex of MESH, more than 0 for those marked")
                ->type_name("red|FILE")
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
  exclude_ways_to_cut(command,
                      *command
                         .add_flag("--symmetry", a.is_symmetric,
                                   "make seams and charts mirror images of each other, if the mesh is its own, "
                                   "triangle by triangle; seams run along edges")
                         ->group("Charts"));
  exclude_ways_to_cut(
    command,
    *command
       .add_option("--pin", a.pins,
                   "put vertices where they shall be in the texture, and their charts with them; FILE is a text "
                   "file with a vertex of MESH (from 0) and two coordinates on each line")
       ->type_name("FILE")
       ->group("Charts"));
  add_pack_options(command, a.packing);
}

} // namespace

Command add_unwrap(CLI::App& app)
{
  const auto a = std::make_shared<Unwrap_arguments>();
  CLI::App* command = app.add_subcommand(
    "unwrap", "cut a mesh and give it texture coordinates: a chart for each component, without flipped faces");
  command->add_option("MESH", a->meshes, "the mesh file, or several that shall share a texture")->required();
  command
    ->add_option(
      "-o,--output", a->outs,
      "the mesh with texture coordinates, one for each MESH: OBJ; vertices are not doubled, seams are in the "
      "coordinates")
    ->required()
    ->type_name("OUT.obj...");
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
    ->check(number_from(0, 1, "a number from 0 to 1"))
    ->type_name("W")
    ->capture_default_str();
  command
    ->add_option("--max-stretch", a->max_stretch,
                 "extend the cut until the L2 stretch is at most S; otherwise until it is 1.1, where it can be")
    ->check(number_from(1, 1e300, "a number from 1 to 1e300"))
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
            a->has_padding = command->count("--padding") > 0;
            if (command->count("--shortest-seams") > 0) { a->max_stretch = 0; }
            if (command->count("--seams") > 0 && a->seams.empty()) { throw Usage_error("--seams names nothing"); }
            if (command->count("--pin") > 0 && a->pins.empty()) { throw Usage_error("--pin names nothing"); }
            if (command->count("--keep-out") > 0 && a->keep_out.empty())
            {
              throw Usage_error("--keep-out names nothing");
            }
            return run_unwrap(*a);
          }};
}

} // namespace program
} // namespace meridian
