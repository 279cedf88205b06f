// SPDX-License-Identifier: GPL-3.0-or-later
#include "given_seams.h"

#include "files/Mesh_attributes.h"
#include "files/read_paths.h"

#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/examine_surface.h>
#include <meridian/surface/measures.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace meridian {
namespace program {

namespace {

// The angle of `sharp:ANGLE`, in degrees.
std::optional<double> sharp_angle(const std::string& word)
{
  const std::string head = "sharp:";
  if (word.compare(0, head.size(), head) != 0) { return std::nullopt; }
  double angle = -1;
  const char *first = word.data() + head.size(), *last = word.data() + word.size();
  const auto [end, error] = std::from_chars(first, last, angle);
  return error == std::errc() && end == last && angle > 0 && angle < 180 ? std::optional<double>(angle) : std::nullopt;
}

// Whether an edge of a component, given by a halfedge, is a seam.
using Is_seam = std::function<bool(const Surface_component&, Index)>;

Is_seam is_sharper_than(double degrees)
{
  const double angle = degrees * std::acos(-1.) / 180;
  return [angle](const Surface_component& c, Index h) { return exterior_dihedral_angle(c.surface, h) > angle; };
}

// Where texture coordinates of the file differ on the two sides.
Is_seam is_seam_of_texture(const Unwrap_arguments& a, const Loaded_mesh& loaded)
{
  const files::Mesh_attributes& attributes = loaded.attributes;
  if (attributes.texture.empty())
  {
    throw files::File_error(a.mesh
                            + ": it has no texture coordinates, which --seams uv needs; OBJ files may have them");
  }
  return [&loaded, &attributes](const Surface_component& c, Index h) {
    const Index p = c.polygon_of[h / 3], q = c.polygon_of[c.surface.opposite[h] / 3];
    const auto differs = [&](Index v) {
      const Index point = point_of(loaded, c, v);
      const std::int32_t one = files::find_at_corner(loaded.soup, attributes.texture_of, p, point),
                         other = files::find_at_corner(loaded.soup, attributes.texture_of, q, point);
      return one != other && (one < 0 || other < 0 || attributes.texture[one] != attributes.texture[other]);
    };
    return p != q && (differs(c.surface.source(h)) || differs(c.surface.target(h)));
  };
}

// Between polygons of different parts.
Is_seam is_between_parts(const Unwrap_arguments& a, const Loaded_mesh& loaded, files::Part_kind kind)
{
  const files::Named_parts& parts = loaded.attributes.of(kind);
  if (parts.of.empty())
  {
    throw files::File_error(a.mesh + ": it names no " + files::meaning_of(kind)
                            + ", which --chart-per asks for; OBJ files may");
  }
  return [&parts](const Surface_component& c, Index h) {
    return parts.of[c.polygon_of[h / 3]] != parts.of[c.polygon_of[c.surface.opposite[h] / 3]];
  };
}

// On paths of a file.
Is_seam is_on_paths(const std::string& path, const Loaded_mesh& loaded)
{
  using Edge = std::array<Index, 2>;
  const auto edge = [](Index v, Index w) { return Edge{std::min(v, w), std::max(v, w)}; };
  std::map<Edge, bool> edges; // and whether the mesh has them
  for (const auto& vertices : files::read_paths(path, loaded.soup.points.size()))
  {
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) { edges.emplace(edge(vertices[i], vertices[i + 1]), false); }
  }
  const auto edge_of = [&](const Surface_component& c, Index h) {
    return edge(point_of(loaded, c, c.surface.source(h)), point_of(loaded, c, c.surface.target(h)));
  };
  for (const Surface_component& c : loaded.examination.components)
    for (Index h = 0; h < c.surface.number_of_halfedges(); ++h)
    {
      const auto found = edges.find(edge_of(c, h));
      if (found != edges.end()) { found->second = true; }
    }
  const auto missing = std::find_if(edges.begin(), edges.end(), [](const auto& e) { return !e.second; });
  if (missing != edges.end())
  {
    const auto count = std::count_if(edges.begin(), edges.end(), [](const auto& e) { return !e.second; });
    throw files::File_error(path + ": " + std::to_string(count) + " steps of its paths are no edges of the mesh, the "
                            + "first from vertex " + std::to_string(missing->first[0]) + " to vertex "
                            + std::to_string(missing->first[1]) + "; vertices are counted from 0");
  }
  return [edges, edge_of](const Surface_component& c, Index h) { return edges.count(edge_of(c, h)) > 0; };
}

Is_seam is_between(const Unwrap_arguments& a, const Loaded_mesh& loaded, Chart_per per)
{
  constexpr double smooth = 30; // degrees
  switch (per)
  {
  case Chart_per::OBJECT: return is_between_parts(a, loaded, files::Part_kind::OBJECT);
  case Chart_per::GROUP: return is_between_parts(a, loaded, files::Part_kind::GROUP);
  case Chart_per::MATERIAL: return is_between_parts(a, loaded, files::Part_kind::MATERIAL);
  case Chart_per::SMOOTHING: return is_between_parts(a, loaded, files::Part_kind::SMOOTHING);
  case Chart_per::SMOOTH_ANGLE: return is_sharper_than(smooth);
  }
  return {};
}

} // namespace

bool is_kind_of_seam(const std::string& word) { return word == "uv" || sharp_angle(word).has_value(); }

std::vector<std::vector<Index>> find_given_seams(const Unwrap_arguments& a, const Loaded_mesh& loaded)
{
  std::vector<Is_seam> kinds;
  if (a.seams == "uv") { kinds.push_back(is_seam_of_texture(a, loaded)); }
  else if (const auto angle = sharp_angle(a.seams)) { kinds.push_back(is_sharper_than(*angle)); }
  else if (!a.seams.empty()) { kinds.push_back(is_on_paths(a.seams, loaded)); }
  if (a.chart_per) { kinds.push_back(is_between(a, loaded, *a.chart_per)); }
  std::vector<std::vector<Index>> seams;
  for (const Surface_component& c : loaded.examination.components)
  {
    auto& of_component = seams.emplace_back();
    for (Index h = 0; h < c.surface.number_of_halfedges(); ++h)
      if (c.surface.opposite[h] > h
          && std::any_of(kinds.begin(), kinds.end(), [&](const Is_seam& is_seam) { return is_seam(c, h); }))
      {
        of_component.push_back(h);
      }
  }
  return seams;
}

std::string describe_completion(const std::vector<Unwrap_options>& options, const std::vector<Cut>& cuts)
{
  constexpr std::size_t few = 8;
  std::array<std::size_t, number_of<Curve_kind>> count{}; // so far, as curves are numbered
  std::vector<std::string> through_handles;
  std::size_t edges = 0, links = 0;
  for (std::size_t i = 0; i < cuts.size(); ++i)
    for (const Named_curve& c : cuts[i].curves)
    {
      const std::size_t number = count[static_cast<std::size_t>(c.kind)]++;
      if (options[i].seams.empty()) { continue; }
      links += c.kind == Curve_kind::LINK;
      if (c.kind == Curve_kind::MERIDIAN || c.kind == Curve_kind::PATH)
      {
        through_handles.push_back(std::string(name_of(c.kind)) + "_" + std::to_string(number));
      }
    }
  for (const Unwrap_options& o : options) { edges += o.seams.size(); }
  if (edges == 0) { return "note: the mesh has no such seams; it is cut as it is without"; }
  std::string note = "note: seams that were given: " + std::to_string(edges) + " edges";
  if (through_handles.empty() && links == 0) { return note + ", and no more is cut"; }
  if (!through_handles.empty())
  {
    note += "; the handles that they leave are cut along ";
    for (std::size_t i = 0; i < std::min(few, through_handles.size()); ++i)
    {
      note += (i > 0 ? ", " : "") + through_handles[i];
    }
    if (through_handles.size() > few) { note += " and " + std::to_string(through_handles.size() - few) + " more"; }
  }
  return links == 0 ? note : note + "; boundaries are joined by links, " + std::to_string(links);
}

} // namespace program
} // namespace meridian
