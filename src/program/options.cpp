// SPDX-License-Identifier: GPL-3.0-or-later
#include "options.h"
#include "arguments.h"
#include "memory.h"

#include <meridian/map/pack_charts.h>
#include <meridian/proof/Padding.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

namespace meridian {
namespace program {

const char* const repair_help = "split edges with three or more faces instead of refusing the mesh";

namespace {

// The texels of a texture to the right and upwards, or nothing.
std::optional<std::array<int, 2>> read_resolution(const std::string& text)
{
  constexpr int least = 16, most = 65536;
  std::array<int, 2> sides{0, 0};
  const char* const last = text.data() + text.size();
  const char* end = std::from_chars(text.data(), last, sides[0]).ptr;
  const bool has_height = end != last && *end == 'x';
  if (has_height) { end = std::from_chars(end + 1, last, sides[1]).ptr; }
  else { sides[1] = sides[0]; }
  const auto is_side = [&](int n) { return n >= least && n <= most; };
  if (end != last || !is_side(sides[0]) || !is_side(sides[1])) { return std::nullopt; }
  return sides;
}

// The bytes that a whole number, or one of K, M or G, names; nothing if it is none.
std::optional<std::uint64_t> read_size(const std::string& text)
{
  constexpr std::uint64_t most = 1ULL << 33;
  const char* const last = text.data() + text.size();
  std::uint64_t n = 0;
  const auto [end, error] = std::from_chars(text.data(), last, n);
  if (error != std::errc() || n == 0) { return std::nullopt; }
  if (end == last) { return n; }
  const std::size_t power = std::string("KMG").find(*end);
  if (end + 1 != last || power == std::string::npos || n > most) { return std::nullopt; }
  return n << 10 * (power + 1);
}

void add_preferences(CLI::App& command, Field_arguments& a)
{
  add_choice(command, "--prefer", a.prefer, "which loops are cut first")->group("The meridians");
  command
    .add_option("--vertex-weights", a.vertex_weights,
                "with --prefer weights: a text file of numbers, one a vertex of MESH, high where loops shall not be")
    ->type_name("FILE")
    ->group("The meridians");
  add_choice(command, "--levels", a.levels, "where loops are taken")->group("The meridians");
  command
    .add_option("--direction", a.direction,
                "with --prefer position: loops far out in this direction first; with hidden: towards the eye")
    ->expected(3)
    ->type_name("X Y Z")
    ->group("The meridians");
}

void add_link_options(CLI::App& command, Cut_arguments& a)
{
  add_choice(command, "--join", a.join, "with --method generators: how the pairs are joined")->group("The links");
  add_choice(command, "--links", a.links, "how the boundaries are joined")->group("The links");
  command.add_flag("--bifurcations", a.bifurcations, "let links end on other links, which makes the cut shorter")
    ->group("The links");
  command.add_option("--source", a.source, "a vertex of MESH that the links shall pass through")
    ->type_name("V")
    ->group("The links");
}

} // namespace

CLI::Validator number_from(double low, double high, const std::string& meaning)
{
  return {[=](const std::string& text) {
            double x = std::numeric_limits<double>::quiet_NaN();
            const bool is_number = CLI::detail::lexical_cast(text, x);
            return is_number && x >= low && x <= high ? std::string() : text + " is not " + meaning;
          },
          ""};
}

void add_common_options(CLI::App& command, Common_arguments& a)
{
  command.add_option("--report", a.report, "write everything that was counted and measured as JSON")->type_name("FILE");
  command.add_flag("--quiet", a.quiet, "print nothing but errors");
  command
    .add_option_function<std::string>(
      "--max-memory", [](const std::string& text) { limit_memory(*read_size(text)); },
      "end with an error rather than take more memory than this")
    ->check(CLI::Validator(
      [](const std::string& text) { return read_size(text) ? "" : "'" + text + "' is no size, such as 500M or 2G"; },
      ""))
    ->type_name("SIZE");
}

void add_field_options(CLI::App& command, Field_arguments& a)
{
  add_choice(command, "--field", a.field, "the field whose contours are cut")->group("The field");
  command.add_option("--values", a.values, "a field from a text file of numbers, one a vertex of MESH")
    ->type_name("FILE")
    ->group("The field");
  command.add_option("--eigenfunction", a.eigenfunction, "which one, from 1; otherwise the genus + 1")
    ->check(CLI::Range(1, 1000000000))
    ->group("The field");
  add_choice(command, "--weights", a.weights, "how the Laplacian is discretized")->group("The field");
  add_choice(command, "--extrema", a.extrema, "where a harmonic field is lowest and highest")->group("The field");
  command.add_option("--minimum", a.minima, "vertices of MESH (from 0) where the field is lowest, instead")
    ->type_name("V...")
    ->group("The field");
  command.add_option("--maximum", a.maxima, "vertices of MESH where the field is highest")
    ->type_name("V...")
    ->group("The field");
  command.add_option("--from", a.from, "a vertex of MESH (from 0): where distances begin, or the loops of tree-cotree")
    ->type_name("V")
    ->group("The field");
  add_preferences(command, a);
}

void add_cut_options(CLI::App& command, Cut_arguments& a, Tightening tightened, const std::string& unless)
{
  command.add_option("--view", a.view, "write a page that shows the result in a browser")->type_name("FILE");
  command.add_option("--curves", a.curves, "write the curves of the cut as OBJ lines")->type_name("FILE");
  add_choice(command, "--map", a.map, "how the map back to MESH is written");
  add_common_options(command, a);
  command.add_flag("--repair", a.repair, repair_help);
  add_field_options(command, a);
  add_choice(command, "--method", a.method, "what cuts the handles");
  command
    .add_option("--bases", a.bases,
                "with --method tree-cotree: how many base points are tried, unless --from names one")
    ->check(CLI::Range(1, 1000000000))
    ->capture_default_str();
  add_choice<Tightening>(
    command, "--tighten", [&a](Tightening chosen) { a.tighten = chosen; }, name_of(tightened),
    "what is made shorter" + unless);
  command.add_flag("--on-edges", a.on_edges, "cut existing edges only, so that there are no new vertices");
  command.add_flag("--refine-where-needed", a.refine_where_needed,
                   "with --on-edges: divide the triangles where the mesh is too coarse for disjoint loops of edges");
  add_link_options(command, a);
}

CLI::Option* add_resolution(CLI::App& command, const char* option, std::array<int, 2>& resolution, const char* help)
{
  const CLI::Validator is_resolution(
    [](const std::string& text) {
      return read_resolution(text) ? "" : "'" + text + "' is not N or WIDTHxHEIGHT, each from 16 to 65536";
    },
    "");
  return command
    .add_option_function<std::string>(
      option, [&resolution](const std::string& text) { resolution = *read_resolution(text); }, help)
    ->check(is_resolution)
    ->type_name("N|WIDTHxHEIGHT");
}

void add_pack_options(CLI::App& command, Pack_options& packing)
{
  add_resolution(command, "--resolution", packing.resolution,
                 "texels along the sides of the texture that is packed for, to the right and upwards if they differ")
    ->default_str(std::to_string(packing.resolution[0]))
    ->group("Charts");
  CLI::Option* density =
    command.add_option("--density", packing.density, "texels along a unit of length of MESH; otherwise as many as fit")
      ->check(number_from(1e-30, 1e30, "a number from 1e-30 to 1e30"))
      ->type_name("D")
      ->group("Charts");
  command.add_option("--tiles", packing.tiles, "with --density: textures that there may be, in the order of UDIM")
    ->check(CLI::Range(1, 100))
    ->type_name("N")
    ->capture_default_str()
    ->needs(density)
    ->group("Charts");
  command.add_option("--padding", packing.padding, "texels between charts, at least")
    ->check(number_from(0, 1024, "a number from 0 to 1024"))
    ->type_name("P")
    ->capture_default_str()
    ->group("Charts");
}

Padding padding_of(const Pack_options& packing)
{
  return {packing.padding, packing.resolution[0], packing.resolution[1]};
}

double texels_of(const Pack_options& packing)
{
  return static_cast<double>(packing.resolution[0]) * packing.resolution[1];
}

void check_padding(const Pack_options& packing)
{
  if (4 * packing.padding > std::min(packing.resolution[0], packing.resolution[1]))
  {
    throw Usage_error("--padding is more than a quarter of --resolution");
  }
}

void note_field_options(const CLI::App& command, Field_arguments& a)
{
  a.has_direction = command.count("--direction") > 0;
  a.has_from = command.count("--from") > 0;
  a.has_extrema = command.count("--extrema") > 0;
}

void note_cut_options(const CLI::App& command, Cut_arguments& a)
{
  note_field_options(command, a);
  a.has_source = command.count("--source") > 0;
  a.has_bases = command.count("--bases") > 0;
}

} // namespace program
} // namespace meridian
