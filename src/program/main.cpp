// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "files/read_mesh.h"

#include <meridian/base/exceptions.h>

#include <CLI/CLI.hpp>

#include <csignal>
#include <iostream>
#include <new>

// OpenBLAS, where it is the BLAS of this system, must not split sums between threads: equal bytes out for equal bytes
// in. CHOLMOD's own threads only wait for each other on the small blocks of a surface mesh.
extern "C" void openblas_set_num_threads(int) __attribute__((weak));
extern "C" void omp_set_max_active_levels(int) __attribute__((weak));

namespace {

volatile std::sig_atomic_t interrupted = 0;

extern "C" void interrupt(int) { interrupted = 1; }

void add_common(CLI::App& command, meridian::program::Common_arguments& arguments)
{
  command.add_option("--report", arguments.report, "write everything that was counted and measured as JSON")
    ->type_name("FILE");
  command.add_flag("--quiet", arguments.quiet, "print nothing but errors");
}

// Which options were given whose default cannot tell.
void note_options(const CLI::App& command, meridian::program::Field_arguments& a)
{
  a.has_direction = command.count("--direction") > 0;
  a.has_from = command.count("--from") > 0;
  a.has_extrema = command.count("--extrema") > 0;
}

const char* const repair_help = "split edges with three or more faces instead of refusing the mesh";

} // namespace

namespace meridian {
namespace program {

void heed_interrupts()
{
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
}

bool is_interrupted() { return interrupted != 0; }

} // namespace program
} // namespace meridian

int main(int argc, char** argv)
{
  using namespace meridian::program;
  if (openblas_set_num_threads) { openblas_set_num_threads(1); }
  // CHOLMOD asks for four threads, whatever their number is set to
  if (omp_set_max_active_levels) { omp_set_max_active_levels(0); }

  CLI::App app{"Cuts any triangle mesh into a disc along smooth curves, and proves with integers that it did.\n"
               "Meshes are OFF, OBJ, STL, PLY or VTP files, or gzip of these."};
  app.name("meridian");
  app.set_version_flag("--version", "meridian " MERIDIAN_VERSION);
  app.require_subcommand(1);
  app.footer("Exit status: 0 verified, 1 unusable input, 2 computed but not verified, 3 numerical failure, 64 wrong "
             "usage, 130 interrupted.\n"
             "Example: meridian cut elephant.off -o disc.obj --view disc.html");

  Info_arguments info;
  CLI::App* info_command =
    app.add_subcommand("info", "count what meshes are: components, boundary loops, genus, defects");
  info_command->add_option("MESH", info.meshes, "mesh files")->required();
  info_command->add_flag("--repair", info.repair, repair_help);
  add_common(*info_command, info);

  const std::string field = "The field", meridians = "The meridians", links = "The links";
  const auto add_field = [&](CLI::App& command, Field_arguments& a) {
    command
      .add_option("--field", a.field,
                  "the field whose contours are cut: harmonic, an eigenfunction of the Laplacian, or the geodesic "
                  "distance from a vertex")
      ->check(CLI::IsMember({"harmonic", "eigenfunction", "distance"}))
      ->capture_default_str()
      ->group(field);
    command.add_option("--values", a.values, "a field from a text file of numbers, one a vertex of MESH")
      ->type_name("FILE")
      ->group(field);
    command.add_option("--eigenfunction", a.eigenfunction, "which one, from 1; otherwise the genus + 1")
      ->check(CLI::Range(1, 1000000000))
      ->group(field);
    command.add_option("--weights", a.weights, "discretization of the Laplacian")
      ->check(CLI::IsMember({"positive", "mean-value", "cotangent", "intrinsic-delaunay"}))
      ->capture_default_str()
      ->group(field);
    command
      .add_option("--extrema", a.extrema,
                  "where a harmonic field is lowest and highest: at two vertices far apart, or at the extrema of "
                  "eigenfunctions with the highest curvature")
      ->check(CLI::IsMember({"distant", "curved"}))
      ->capture_default_str()
      ->group(field);
    command.add_option("--minimum", a.minima, "vertices of MESH (from 0) where the field is lowest, instead")
      ->type_name("V...")
      ->group(field);
    command.add_option("--maximum", a.maxima, "vertices of MESH where the field is highest")
      ->type_name("V...")
      ->group(field);
    command
      .add_option("--from", a.from, "a vertex of MESH (from 0): where distances begin, or the loops of tree-cotree")
      ->type_name("V")
      ->group(field);
    command
      .add_option("--prefer", a.prefer,
                  "which loops are cut first: with high gaussian-curvature or mean-curvature at the saddle, of short "
                  "length, in a position far out, hidden from an eye, or through low weights")
      ->check(CLI::IsMember({"gaussian-curvature", "mean-curvature", "length", "position", "hidden", "weights"}))
      ->capture_default_str()
      ->group(meridians);
    command
      .add_option("--vertex-weights", a.vertex_weights,
                  "with --prefer weights: a text file of numbers, one a vertex of MESH, high where loops shall not be")
      ->type_name("FILE")
      ->group(meridians);
    command
      .add_option("--levels", a.levels,
                  "take loops near their saddle, or where they are tightest between two critical levels")
      ->check(CLI::IsMember({"saddle", "tight"}))
      ->capture_default_str()
      ->group(meridians);
    command
      .add_option("--direction", a.direction,
                  "with --prefer position: loops far out in this direction first; with hidden: towards the eye")
      ->expected(3)
      ->type_name("X Y Z")
      ->group(meridians);
  };

  // What the commands share that cut.
  const auto add_cut = [&](CLI::App& command, Cut_arguments& a) {
    command.add_option("--view", a.view, "write a page that shows the result in a browser")->type_name("FILE");
    command.add_option("--curves", a.curves, "write the curves of the cut as OBJ lines")->type_name("FILE");
    add_common(command, a);
    command.add_flag("--repair", a.repair, repair_help);
    add_field(command, a);
    command
      .add_option("--method", a.method,
                  "what cuts the handles: a contour each, a meridian and a longitude each, the descending flow lines "
                  "of all saddles, contours of the geodesic distance, shortest loops of edges at a base point, or the "
                  "edges left when faces are removed")
      ->check(CLI::IsMember({"contours", "generators", "morse", "geodesic", "tree-cotree", "geometry-image"}))
      ->capture_default_str();
    command
      .add_option("--bases", a.bases,
                  "with --method tree-cotree: how many base points are tried, unless --from names one")
      ->check(CLI::Range(1, 1000000000))
      ->capture_default_str();
    command
      .add_option("--tighten", a.tighten,
                  "shorten nothing, the curves within their classes, or the whole graph, whose vertices then move and "
                  "whose paths may change places")
      ->check(CLI::IsMember({"no", "curves", "graph"}))
      ->capture_default_str();
    command.add_flag("--on-edges", a.on_edges, "cut existing edges only, so that there are no new vertices");
    command.add_flag("--refine-where-needed", a.refine_where_needed,
                     "with --on-edges: divide the triangles where the mesh is too coarse for disjoint loops of edges");
    command
      .add_option("--join", a.join,
                  "with --method generators: join the pairs by shortest paths on the surface, along the quasi "
                  "Morse-Smale complex, or along its paths between the meridians' saddles")
      ->check(CLI::IsMember({"surface", "complex", "saddles"}))
      ->capture_default_str()
      ->group(links);
    command
      .add_option("--links", a.links,
                  "join the boundaries by shortest paths on the surface, or through a plane embedding")
      ->check(CLI::IsMember({"surface", "plane"}))
      ->capture_default_str()
      ->group(links);
    command.add_flag("--bifurcations", a.bifurcations, "let links end on other links, which makes the cut shorter")
      ->group(links);
    command.add_option("--source", a.source, "a vertex of MESH that the links shall pass through")
      ->type_name("V")
      ->group(links);
  };

  Cut_arguments cut;
  CLI::App* cut_command =
    app.add_subcommand("cut", "open a mesh into a disc, one for each component, along a cut graph");
  cut_command->add_option("MESH", cut.mesh, "the mesh file")->required();
  cut_command
    ->add_option("-o,--output", cut.out,
                 "the opened mesh: OFF, OBJ, PLY or VTP; its map back to MESH is written beside it")
    ->required()
    ->type_name("OUT");
  add_cut(*cut_command, cut);
  cut_command
    ->add_option("--family", cut.family,
                 "find N different cuts: fields, preferences, levels and methods change. They are written to OUT with "
                 "a number before its ending")
    ->check(CLI::Range(1, 1000000000))
    ->type_name("N");

  Unwrap_arguments unwrap;
  CLI::App* unwrap_command = app.add_subcommand(
    "unwrap", "cut a mesh and give it texture coordinates: a chart for each component, without flipped faces");
  unwrap_command->add_option("MESH", unwrap.mesh, "the mesh file")->required();
  unwrap_command
    ->add_option("-o,--output", unwrap.out,
                 "the mesh with texture coordinates: OBJ; vertices are not doubled, seams are in the coordinates")
    ->required()
    ->type_name("OUT.obj");
  const std::string plane = "The map", pictures = "Pictures";
  unwrap_command
    ->add_option("--parameterization", unwrap.parameterization,
                 "low distortion, one-to-one; averages with positive weights, the same with low stretch, "
                 "mean value coordinates, uniform averages, discrete conformal, discrete authalic; least squares "
                 "conformal or as rigid as possible, both with a free border")
    ->check(CLI::IsMember(
      {"symmetric-dirichlet", "positive", "stretch", "mean-value", "tutte", "conformal", "authalic", "lscm", "arap"}))
    ->capture_default_str()
    ->group(plane);
  unwrap_command
    ->add_option("--border", unwrap.border,
                 "where the border goes: where the method likes; those that need a border take a circle")
    ->check(CLI::IsMember({"free", "circle", "square"}))
    ->capture_default_str()
    ->group(plane);
  unwrap_command->add_option("--family", unwrap.family, "try N different cuts, and take the best")
    ->check(CLI::Range(1, 1000000000))
    ->type_name("N");
  unwrap_command
    ->add_option("--stretch-weight", unwrap.stretch_weight,
                 "what is best: the least (1 - W) length + W stretch; with W > 0 links are varied too")
    ->check(CLI::Range(0., 1.))
    ->type_name("W")
    ->capture_default_str();
  unwrap_command
    ->add_option("--max-stretch", unwrap.max_stretch,
                 "extend the cut to regions of high stretch until the L2 stretch is at most S")
    ->check(CLI::Range(1., 1e300))
    ->type_name("S");
  unwrap_command
    ->add_option("--svg", unwrap.layout,
                 "draw the layout: distortion as colour, the two sides of each seam numbered alike")
    ->type_name("FILE")
    ->group(pictures);
  unwrap_command->add_option("--png", unwrap.texture, "write a checkerboard, and beside OUT the material that shows it")
    ->type_name("FILE")
    ->group(pictures);
  unwrap_command
    ->add_option("--distortion", unwrap.distortion, "write the mesh as PLY or VTP with the distortion of each face")
    ->type_name("FILE")
    ->group(pictures);
  add_cut(*unwrap_command, unwrap);

  unwrap_command
    ->add_option("--geometry-image", unwrap.geometry_image,
                 "map into a square, and write N x N points of the surface as a 16-bit PNG and as the surface "
                 "remeshed, beside OUT")
    ->check(CLI::Range(5, 16384))
    ->type_name("N")
    ->group(pictures);

  Compare_arguments compare;
  CLI::App* compare_command = app.add_subcommand(
    "compare", "compare the maps into the plane that two cuts of a mesh lead to, and bound their variation from below");
  compare_command->add_option("MESH", compare.mesh, "the mesh file")->required();
  compare_command
    ->add_option("--cut", compare.cuts,
                 "a result of `cut` or `unwrap`, or the number of a member of the family (0 to 999); given twice")
    ->required()
    ->expected(2)
    ->type_name("CUT");
  compare_command->add_option("--weights", compare.weights, "of the linear map into a circle")
    ->check(CLI::IsMember({"uniform", "positive", "cotangent"}))
    ->capture_default_str();
  compare_command->add_flag("--repair", compare.repair, repair_help);
  add_common(*compare_command, compare);

  Generator_arguments generators;
  CLI::App* generators_command =
    app.add_subcommand("generators", "find a meridian and a longitude around every handle");
  generators_command->add_option("MESH", generators.mesh, "the mesh file")->required();
  generators_command
    ->add_option("-o,--output", generators.out,
                 "the refined mesh, with the curves as line elements; its map back to MESH is written beside it")
    ->required()
    ->type_name("OUT.obj");
  generators_command->add_option("--view", generators.view, "write a page that shows the curves in a browser")
    ->type_name("FILE");
  generators_command->add_option("--curves", generators.curves, "write the curves alone as OBJ lines")
    ->type_name("FILE");
  add_common(*generators_command, generators);
  generators_command->add_flag("--repair", generators.repair, repair_help);
  add_field(*generators_command, generators);
  generators_command
    ->add_option(
      "--basis", generators.basis,
      "a meridian and a longitude for every handle, or short loops that are a basis of homology and may cross")
    ->check(CLI::IsMember({"pairs", "shortest"}))
    ->capture_default_str();
  generators_command
    ->add_option("--longitudes", generators.longitudes, "look for flow lines first, or take shortest arcs at once")
    ->check(CLI::IsMember({"flow", "arc"}))
    ->capture_default_str();
  generators_command
    ->add_option(
      "--mode", generators.mode,
      "boundary loops take one value of the field each, or the boundary is free and level lines may end there")
    ->check(CLI::IsMember({"closed", "open"}))
    ->capture_default_str()
    ->group(field);
  generators_command->add_flag("--complex", generators.complex,
                               "show the flow lines of the field in --view and write them to --curves");
  generators_command->add_flag("--no-tighten", generators.no_tighten, "leave the curves as they were found");

  Verify_arguments verify;
  CLI::App* verify_command =
    app.add_subcommand("verify", "recount a result of `cut`, `unwrap` or `generators` from its files alone");
  verify_command->add_option("MESH", verify.mesh, "the mesh that the result was made from")->required();
  verify_command->add_option("RESULT", verify.result, "the result; its .map.json is expected beside it")->required();
  add_common(*verify_command, verify);

  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& e)
  {
    const int status = app.exit(e);
    return status == 0 ? 0 : WRONG_USAGE;
  }

  const auto complain = [](const char* text, int status) {
    std::cerr << "meridian: " << text << '\n';
    return status;
  };
  try
  {
    if (*info_command) { return run_info(info); }
    const auto note_cut = [](const CLI::App& command, Cut_arguments& a) {
      note_options(command, a);
      a.has_source = command.count("--source") > 0;
      a.has_bases = command.count("--bases") > 0;
    };
    if (*unwrap_command)
    {
      note_cut(*unwrap_command, unwrap);
      unwrap.has_border = unwrap_command->count("--border") > 0;
      return run_unwrap(unwrap);
    }
    if (*cut_command)
    {
      note_cut(*cut_command, cut);
      return cut.family > 0 ? run_family(cut) : run_cut(cut);
    }
    if (*compare_command) { return run_compare(compare); }
    if (*generators_command)
    {
      note_options(*generators_command, generators);
      return run_generators(generators);
    }
    return run_verify(verify);
  }
  catch (const Usage_error& e)
  {
    return complain(e.what(), WRONG_USAGE);
  }
  catch (const meridian::Invalid_input_error& e)
  {
    return complain(e.what(), UNUSABLE_INPUT);
  }
  catch (const meridian::files::File_error& e)
  {
    return complain(e.what(), UNUSABLE_INPUT);
  }
  catch (const meridian::Solver_error& e)
  {
    return complain(e.what(), NUMERICAL_FAILURE);
  }
  catch (const meridian::Cancelled& e)
  {
    return complain(e.what(), INTERRUPTED);
  }
  catch (const std::bad_alloc&)
  {
    return complain("there is not enough memory for this mesh", UNUSABLE_INPUT);
  }
  catch (const std::exception& e)
  {
    std::cerr << "meridian: internal error: " << e.what()
              << "; nothing was written. Please report this with the mesh\n";
    return NOT_VERIFIED;
  }
}
