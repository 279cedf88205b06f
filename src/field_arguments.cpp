// SPDX-License-Identifier: GPL-3.0-or-later
#include "field_arguments.h"
#include "files/read_mesh.h"
#include "files/write_mesh.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <set>

namespace meridian {
namespace program {

void check_arguments(const Field_arguments& a)
{
  const auto place = [](const std::string& path) { return std::filesystem::weakly_canonical(std::filesystem::absolute(path)).string(); };
  std::set<std::string> places{place(a.mesh)};
  for (const std::string& path : {a.out, files::map_path(a.out), a.report, a.view, a.curves})
    if (!path.empty() && !places.insert(place(path)).second)
      throw Usage_error(path + " would be written twice, or over the mesh that is read; give every file a name of its own");
  if (a.has_direction && a.prefer != "position") { throw Usage_error("--direction goes with --prefer position"); }
}

void check_vertex(const char* option, Index v, const Examination& examination)
{
  for (const Surface_component& c : examination.components)
    if (std::binary_search(c.vertex_of.begin(), c.vertex_of.end(), v)) { return; }
  throw Usage_error(std::string(option) + ": no face of the mesh has a vertex " + std::to_string(v) + "; vertices are counted from 0");
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

void set_field_options(const Field_arguments& a, const Surface_component& c, std::size_t place, Field_options& field, Preference& preference)
{
  field.weights = a.weights == "cotangent" ? Weights::COTANGENT : a.weights == "mean-value" ? Weights::MEAN_VALUE : Weights::POSITIVE;
  field.minima = find_local(a.minima, c);
  field.maxima = find_local(a.maxima, c);
  if (c.genus() > 0 && field.minima.empty() != field.maxima.empty())
    throw Usage_error("--minimum and --maximum go together: component " + std::to_string(place) + " has one of them and needs the other");
  if (c.genus() > 0 && !field.minima.empty())
  {
    const Node_graph g = make_node_graph(c.surface);
    for (Index v : field.minima)
      for (Index w : field.maxima)
        if (g.node[v] == g.node[w])
          throw Usage_error("--minimum " + std::to_string(c.vertex_of[v]) + " and --maximum " + std::to_string(c.vertex_of[w])
                            + (v == w ? " are one vertex" : " lie on one boundary loop, which is one place of the field") + "; choose them apart");
  }
  if (a.prefer == "mean-curvature") { preference = preference::mean_curvature; }
  if (a.prefer == "length") { preference = preference::short_length; }
  if (a.prefer == "position") { preference = preference::position({a.direction[0], a.direction[1], a.direction[2]}); }
}

} // namespace program
} // namespace meridian
