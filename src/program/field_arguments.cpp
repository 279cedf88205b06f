// SPDX-License-Identifier: GPL-3.0-or-later
#include "field_arguments.h"
#include "files/read_mesh.h"
#include "files/read_values.h"
#include "files/write_mesh.h"

#include <meridian/base/vectors.h>
#include <meridian/curves/contours.h>
#include <meridian/field/Field.h>
#include <meridian/field/edge_weights.h>
#include <meridian/field/eigenfunctions.h>
#include <meridian/field/geodesic_distance.h>
#include <meridian/handles/preference.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/examine_surface.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/visibility.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <set>

namespace meridian {
namespace program {

void check_paths(const Field_arguments& a, const std::vector<std::string>& written)
{
  const auto place = [](const std::string& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path)).string();
  };
  std::set<std::string> places;
  for (const std::string& path : {a.mesh, a.values, a.vertex_weights})
  {
    if (!path.empty()) { places.insert(place(path)); }
  }
  for (const std::string& path : written)
    if (!path.empty() && !places.insert(place(path)).second)
      throw Usage_error(path
                        + " would be written twice, or over a file that is read; give every file a name of its own");
}

void check_arguments(const Field_arguments& a)
{
  check_paths(a, {a.out, files::map_path(a.out), a.report, a.view, a.curves});
  const auto forbid = [](bool is_wrong, const char* message) {
    if (is_wrong) { throw Usage_error(message); }
  };
  const double far = std::max({std::abs(a.direction[0]), std::abs(a.direction[1]), std::abs(a.direction[2])});
  forbid(!(far > 0) || !std::isfinite(far), "--direction must be finite and not 0 0 0");
  const bool is_harmonic = a.values.empty() && a.field == Field_kind::HARMONIC;
  forbid(a.has_direction && a.prefer != Prefer::POSITION && a.prefer != Prefer::HIDDEN,
         "--direction goes with --prefer position or hidden");
  forbid((a.prefer == Prefer::WEIGHTS) == a.vertex_weights.empty(),
         "--prefer weights and --vertex-weights go together");
  forbid(!a.values.empty() && a.field != Field_kind::HARMONIC, "--values is a field; leave out --field");
  forbid(a.eigenfunction > 0 && a.field != Field_kind::EIGENFUNCTION,
         "--eigenfunction goes with --field eigenfunction");
  forbid(a.has_extrema && (!is_harmonic || !a.minima.empty() || !a.maxima.empty()),
         "--extrema is for harmonic fields, and without --minimum and --maximum");
  forbid(a.weights != Weights::POSITIVE && (!a.values.empty() || a.field == Field_kind::DISTANCE),
         "--weights goes with fields that are solved for with them: harmonic or eigenfunction");
  forbid(a.weights == Weights::MEAN_VALUE && (a.field == Field_kind::EIGENFUNCTION || a.extrema == Extrema::CURVED),
         "eigenfunctions need symmetric weights; mean-value weights are not");
}

void check_vertex(const char* option, Index v, const Examination& examination)
{
  for (const Surface_component& c : examination.components)
    if (std::binary_search(c.vertex_of.begin(), c.vertex_of.end(), v)) { return; }
  throw Usage_error(std::string(option) + ": no face of the mesh has a vertex " + std::to_string(v)
                    + "; vertices are counted from 0");
}

Loaded_mesh load_mesh(const Field_arguments& a)
{
  Loaded_mesh loaded;
  const auto timed = [](const auto& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  loaded.seconds_reading = timed([&] { loaded.soup = files::read_mesh(a.mesh); });
  heed_interrupts();
  loaded.seconds_examining = timed([&] { loaded.examination = examine_surface(loaded.soup, a.repair); });
  for (Index v : a.minima) { check_vertex("--minimum", v, loaded.examination); }
  for (Index v : a.maxima) { check_vertex("--maximum", v, loaded.examination); }
  if (a.has_from) { check_vertex("--from", a.from, loaded.examination); }
  const std::size_t n = loaded.soup.points.size();
  if (!a.values.empty()) { loaded.values = files::read_values(a.values, n); }
  if (!a.vertex_weights.empty()) { loaded.vertex_weights = files::read_values(a.vertex_weights, n); }
  return loaded;
}

std::vector<Index> find_local(const std::vector<Index>& vertices, const Surface_component& c)
{
  std::vector<Index> found;
  for (Index v : vertices)
  {
    const auto at = std::lower_bound(c.vertex_of.begin(), c.vertex_of.end(), v);
    if (at != c.vertex_of.end() && *at == v) { found.push_back(static_cast<Index>(at - c.vertex_of.begin())); }
  }
  return found;
}

namespace {

// The extrema that options name lie on different places of the component.
void check_extrema(const Field_options& field, const Surface_component& c, std::size_t place)
{
  if (field.minima.empty() != field.maxima.empty())
    throw Usage_error("--minimum and --maximum go together: component " + std::to_string(place)
                      + " has one of them and needs the other");
  if (!field.minima.empty())
  {
    const Closed_model g = make_closed_model(c.surface);
    for (Index v : field.minima)
      for (Index w : field.maxima)
        if (g.node[v] == g.node[w])
          throw Usage_error(
            "--minimum " + std::to_string(c.vertex_of[v]) + " and --maximum " + std::to_string(c.vertex_of[w])
            + (v == w ? " are one vertex" : " lie on one boundary loop, which is one place of the field")
            + "; choose them apart");
  }
}

// Values of the file's vertices, for those of a component.
std::vector<double> local_values(const std::vector<double>& values, const Loaded_mesh& loaded,
                                 const Surface_component& c)
{
  std::vector<double> own;
  for (Index v : c.vertex_of)
  {
    const std::size_t n = values.size(), i = static_cast<std::size_t>(v);
    own.push_back(values[i < n ? i : static_cast<std::size_t>(loaded.examination.added_vertex_of[i - n])]);
  }
  return own;
}

// The field that options ask for, if it is not harmonic between extrema that are far apart or named.
void solve_field(const Field_arguments& a, const Loaded_mesh& loaded, const Surface_component& c, Field_options& field)
{
  if (!a.values.empty()) { field.values = local_values(loaded.values, loaded, c); }
  else if (a.field == Field_kind::EIGENFUNCTION)
  {
    const int i = a.eigenfunction > 0 ? a.eigenfunction : c.genus() + 1;
    field.values_name = "eigenfunction " + std::to_string(i);
    field.values = eigenfunction_field(c.surface, i, field.weights);
  }
  else if (a.field == Field_kind::DISTANCE)
  {
    const auto from = a.has_from ? find_local({a.from}, c) : std::vector<Index>();
    const Closed_model g = make_closed_model(c.surface);
    field.values_name = "distance";
    field.values = geodesic_distance(
      c.surface, {from.empty() ? g.representative[find_distant_nodes(c.surface, g).first] : from.front()});
  }
  else if (a.extrema == Extrema::CURVED)
  {
    const auto [low, high] = find_curved_vertices(c.surface, 4, field.weights);
    field.minima = {low};
    field.maxima = {high};
  }
}

} // namespace

void set_field_options(const Field_arguments& a, const Loaded_mesh& loaded, std::size_t place, Field_options& field,
                       Preference& preference, Levels& levels)
{
  const Surface_component& c = loaded.examination.components[place];
  field.weights = a.weights;
  field.minima = find_local(a.minima, c);
  field.maxima = find_local(a.maxima, c);
  if (c.genus() > 0) { check_extrema(field, c, place); }
  if (c.genus() > 0) { solve_field(a, loaded, c, field); }
  const double far = std::max({std::abs(a.direction[0]), std::abs(a.direction[1]), std::abs(a.direction[2])});
  const Point direction{a.direction[0] / far, a.direction[1] / far, a.direction[2] / far};
  levels = a.levels;
  if (a.prefer == Prefer::HIDDEN) { preference = preference::low_weight(visibility(c.surface, direction)); }
  if (a.prefer == Prefer::WEIGHTS)
  {
    preference = preference::low_weight(local_values(loaded.vertex_weights, loaded, c));
  }
  if (a.prefer == Prefer::MEAN_CURVATURE) { preference = preference::mean_curvature; }
  if (a.prefer == Prefer::LENGTH) { preference = preference::short_length; }
  if (a.prefer == Prefer::POSITION) { preference = preference::position(direction); }
}

} // namespace program
} // namespace meridian
