// SPDX-License-Identifier: GPL-3.0-or-later
#include "field_arguments.h"
#include "check_paths.h"
#include "files/map_file.h"
#include "files/read_mesh.h"
#include "files/read_values.h"
#include "memory.h"

#include <meridian/base/vectors.h>
#include <meridian/curves/contours.h>
#include <meridian/field/Field.h>
#include <meridian/field/edge_weights.h>
#include <meridian/handles/preference.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/examine_surface.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/renumber.h>
#include <meridian/surface/visibility.h>

#include <algorithm>
#include <chrono>
#include <variant>

namespace meridian {
namespace program {

std::vector<std::string> files_read_for(const Field_arguments& a) { return {a.mesh, a.values, a.vertex_weights}; }

void check_arguments(const Field_arguments& a)
{
  check_paths(files_read_for(a), {a.out, files::map_path(a.out, a.map), a.report, a.view, a.curves});
  const auto forbid = [](bool is_wrong, const char* message) {
    if (is_wrong) { throw Usage_error(message); }
  };
  const double far = std::max({std::abs(a.direction[0]), std::abs(a.direction[1]), std::abs(a.direction[2])});
  forbid(!(far > 0) || !std::isfinite(far), "--direction must be finite and not 0 0 0");
  const bool has_harmonic = std::holds_alternative<Harmonic_field>(a.field),
             has_eigenfunction = std::holds_alternative<Eigenfunction_field>(a.field),
             is_harmonic = a.values.empty() && has_harmonic;
  forbid(a.has_direction && a.prefer != Prefer::POSITION && a.prefer != Prefer::HIDDEN,
         "--direction goes with --prefer position or hidden");
  forbid((a.prefer == Prefer::WEIGHTS) == a.vertex_weights.empty(),
         "--prefer weights and --vertex-weights go together");
  forbid(!a.values.empty() && !has_harmonic, "--values is a field; leave out --field");
  forbid(a.eigenfunction > 0 && !has_eigenfunction, "--eigenfunction goes with --field eigenfunction");
  forbid(a.has_extrema && (!is_harmonic || !a.minima.empty() || !a.maxima.empty()),
         "--extrema is for harmonic fields, and without --minimum and --maximum");
  forbid(a.weights != Weights::POSITIVE && (!a.values.empty() || std::holds_alternative<Distance_field>(a.field)),
         "--weights goes with fields that are solved for with them: harmonic or eigenfunction");
  forbid(a.weights == Weights::MEAN_VALUE && (has_eigenfunction || a.extrema == Extrema::CURVED),
         "eigenfunctions need symmetric weights; mean-value weights are not");
}

void check_vertex(const char* option, Index v, const Examination& examination)
{
  for (const Surface_component& c : examination.components)
    if (find_local(v, c) >= 0) { return; }
  throw Usage_error(std::string(option) + ": no face of the mesh has a vertex " + std::to_string(v)
                    + "; vertices are counted from 0");
}

Loaded_mesh load_mesh(const Field_arguments& a, bool with_attributes)
{
  Loaded_mesh loaded;
  const auto timed = [](const auto& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  loaded.seconds_reading =
    timed([&] { loaded.soup = files::read_mesh(a.mesh, with_attributes ? &loaded.attributes : nullptr); });
  reserve_memory_of_blas();
  loaded.seconds_examining = timed([&] {
    loaded.examination = examine_surface(loaded.soup, a.repair);
    for (Surface_component& c : loaded.examination.components)
    {
      if (is_scattered(c.surface)) { renumber(c); }
    }
  });
  for (Index v : a.minima) { check_vertex("--minimum", v, loaded.examination); }
  for (Index v : a.maxima) { check_vertex("--maximum", v, loaded.examination); }
  if (a.has_from) { check_vertex("--from", a.from, loaded.examination); }
  const std::size_t n = loaded.soup.points.size();
  if (!a.values.empty()) { loaded.values = files::read_values(a.values, n); }
  if (!a.vertex_weights.empty()) { loaded.vertex_weights = files::read_values(a.vertex_weights, n); }
  return loaded;
}

Index point_of(const Loaded_mesh& loaded, const Surface_component& c, Index v)
{
  const auto n = static_cast<Index>(loaded.soup.points.size());
  const Index p = c.vertex_of[v];
  return p < n ? p : loaded.examination.added_vertex_of[p - n];
}

Index find_local(Index vertex, const Surface_component& c)
{
  const auto found = find_local(std::vector<Index>{vertex}, c);
  return found.empty() ? -1 : found.front();
}

std::vector<Index> find_local(const std::vector<Index>& vertices, const Surface_component& c)
{
  std::vector<Index> found;
  for (Index v : vertices)
  {
    const auto at = std::find(c.vertex_of.begin(), c.vertex_of.end(), v);
    if (at != c.vertex_of.end()) { found.push_back(static_cast<Index>(at - c.vertex_of.begin())); }
  }
  return found;
}

namespace {

// The extrema that options name lie on different places of the component.
void check_extrema(const Chosen_extrema& field, const Surface_component& c, std::size_t place)
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

// The field that options ask for, on a component.
Field field_of(const Field_arguments& a, const Loaded_mesh& loaded, const Surface_component& c)
{
  if (!a.values.empty()) { return Given_field{local_values(loaded.values, loaded, c)}; }
  Field field = a.field;
  if (auto* harmonic = std::get_if<Harmonic_field>(&field)) { *harmonic = {a.weights, a.extrema}; }
  if (auto* eigenfunction = std::get_if<Eigenfunction_field>(&field)) { *eigenfunction = {a.eigenfunction, a.weights}; }
  if (auto* distance = std::get_if<Distance_field>(&field))
  {
    distance->source = a.has_from ? find_local(a.from, c) : -1;
  }
  return field;
}

} // namespace

Field_options field_options(const Field_arguments& a, const Loaded_mesh& loaded, std::size_t place)
{
  const Surface_component& c = loaded.examination.components[place];
  Field_options o{{find_local(a.minima, c), find_local(a.maxima, c)}, field_of(a, loaded, c)};
  if (c.genus() > 0) { check_extrema(o, c, place); }
  return o;
}

Meridian_options meridian_options(const Field_arguments& a, const Loaded_mesh& loaded, std::size_t place)
{
  const Surface_component& c = loaded.examination.components[place];
  const double far = std::max({std::abs(a.direction[0]), std::abs(a.direction[1]), std::abs(a.direction[2])});
  const Point direction{a.direction[0] / far, a.direction[1] / far, a.direction[2] / far};
  Meridian_options o;
  o.levels = a.levels;
  if (a.prefer == Prefer::HIDDEN) { o.preference = preference::low_weight(visibility(c.surface, direction)); }
  if (a.prefer == Prefer::WEIGHTS)
  {
    o.preference = preference::low_weight(local_values(loaded.vertex_weights, loaded, c));
  }
  if (a.prefer == Prefer::MEAN_CURVATURE) { o.preference = preference::mean_curvature; }
  if (a.prefer == Prefer::LENGTH) { o.preference = preference::short_length; }
  if (a.prefer == Prefer::POSITION) { o.preference = preference::position(direction); }
  return o;
}

} // namespace program
} // namespace meridian
