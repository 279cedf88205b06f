// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/result/discs_of.h>

#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/surface/open_along.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

namespace meridian {

namespace {

// For each vertex of the root whether a cut touches it. `original` is the root's vertex of each vertex of the disc, or
// -1. A vertex on the seam has a copy, unless the seam ends there: then it lies on the boundary of the disc alone. So
// the answer does not depend on which side of the seam keeps the vertex.
std::vector<char> find_touched_vertices(const Triangle_surface& root, const Triangle_surface& disc,
                                        const std::vector<Index>& original)
{
  const Index n = root.number_of_vertices();
  std::vector<char> is_touched(n, 0), is_whole(root.number_of_faces(), 0);
  for (Index v = n; v < disc.number_of_vertices(); ++v)
  {
    if (original[v] >= 0) { is_touched[original[v]] = 1; }
  }
  for (Index v = 0; v < n; ++v)
    if (disc.outgoing[v] < 0 || disc.is_boundary_vertex(v) != root.is_boundary_vertex(v)) { is_touched[v] = 1; }
  for (const auto& t : disc.triangles)
  {
    const Index a = original[t[0]], b = original[t[1]], c = original[t[2]];
    if (a < 0 || b < 0 || c < 0) { continue; }
    const Index h = root.find_halfedge(a, b);
    if (h >= 0 && root.apex(h) == c) { is_whole[root.face(h)] = 1; }
  }
  for (Index f = 0; f < root.number_of_faces(); ++f)
    for (Index v : root.triangles[f])
    {
      if (!is_whole[f]) { is_touched[v] = 1; }
    }
  return is_touched;
}

// For each vertex of a result the lowest that was one with it before seams were opened.
std::vector<Index> glue_seams(const Result_mesh& result)
{
  std::vector<Index> parent(result.points.size());
  std::iota(parent.begin(), parent.end(), Index(0));
  const auto find = [&](Index v) {
    while (parent[v] != v) { v = parent[v] = parent[parent[v]]; }
    return v;
  };
  const auto join = [&](Index v, Index w) {
    const Index a = find(v), b = find(w);
    parent[std::max(a, b)] = std::min(a, b);
  };
  const Index sides = 3 * static_cast<Index>(result.faces.size());
  for (const auto& [a, b] : result.seams)
  {
    if (a < 0 || b < 0 || a >= sides || b >= sides)
    {
      throw Invalid_input_error("cut_discs_of: a seam names a side that the result does not have");
    }
    const auto &s = result.faces[a / 3], &t = result.faces[b / 3];
    join(s[a % 3], t[(b + 1) % 3]);
    join(s[(a + 1) % 3], t[b % 3]);
  }
  for (std::size_t v = 0; v < parent.size(); ++v) { parent[v] = find(static_cast<Index>(v)); }
  return parent;
}

[[noreturn]] void refuse(const std::string& what)
{
  throw Invalid_input_error("cut_discs_of: the result does not belong to the input: " + what);
}

// The faces of each component of a result.
std::vector<std::vector<Index>> group_faces(const Result_mesh& result, Index components)
{
  std::vector<std::vector<Index>> faces(components);
  for (std::size_t f = 0; f < result.faces.size(); ++f)
  {
    if (result.component_of[f] < 0 || result.component_of[f] >= components)
    {
      refuse("a face lies in component " + std::to_string(result.component_of[f]));
    }
    faces[result.component_of[f]].push_back(static_cast<Index>(f));
  }
  return faces;
}

// Refuses a result whose arrays do not fit. Returns how many of its vertices are neither of the input nor copies.
Index count_new_vertices(const Polygon_soup& input, const Examination& examination, const Result_mesh& result)
{
  const Index n = static_cast<Index>(input.points.size()),
              added = static_cast<Index>(examination.added_vertex_of.size()),
              size = static_cast<Index>(result.points.size());
  if (result.copy_of.size() != result.points.size() || result.origin.size() != result.points.size()
      || result.component_of.size() != result.faces.size())
    refuse("its map has another size");
  const Index new_vertices =
    static_cast<Index>(std::count_if(result.copy_of.begin(), result.copy_of.end(), [](Index v) { return v < 0; })) - n;
  if (new_vertices < 0 || size < n + new_vertices + added) { refuse("it has too few vertices"); }
  for (const auto& t : result.faces)
    for (Index v : t)
    {
      if (v < 0 || v >= size) { refuse("a face has a vertex " + std::to_string(v)); }
    }
  return new_vertices;
}

// Takes the discs of the components out of a result, one after another.
class Disc_extractor
{
public:
  Disc_extractor(const Polygon_soup& input, const Examination& examination, const Result_mesh& result,
                 Index new_vertices)
    : m_examination(examination), m_result(result), m_input_vertices(static_cast<Index>(input.points.size())),
      m_new_vertices(new_vertices), m_glued(glue_seams(result)), m_local(result.points.size(), -1),
      m_root_of(result.points.size(), -1)
  {}

  Cut_disc extract(const Surface_component& c, const std::vector<Index>& faces)
  {
    Cut_disc d;
    d.disc.points = c.surface.points;
    std::vector<Index> place; // of the disc's vertices in the result
    place_root(c, place);
    for (Index v : find_others(faces))
    {
      m_local[v] = static_cast<Index>(place.size());
      place.push_back(v);
      const auto& p = m_result.points[v];
      d.disc.points.push_back({p[0] / c.unit, p[1] / c.unit, p[2] / c.unit});
    }
    for (Index f : faces)
    {
      const auto& t = m_result.faces[f];
      d.disc.triangles.push_back({m_local[t[0]], m_local[t[1]], m_local[t[2]]});
    }
    connect(d.disc);
    std::vector<Index> original;
    for (Index v : place) { original.push_back(m_root_of[m_glued[v]]); }
    d.is_touched = find_touched_vertices(c.surface, d.disc, original);
    for (Index v : place) { m_local[v] = m_root_of[m_glued[v]] = -1; }
    return d;
  }

private:
  // Places the vertices of the root.
  void place_root(const Surface_component& c, std::vector<Index>& place)
  {
    const Index n = m_input_vertices;
    for (Index v : c.vertex_of)
    {
      const Index at = v < n ? v : v + m_new_vertices, original = v < n ? v : m_examination.added_vertex_of[v - n];
      if (m_result.origin[at].kind != Result_origin::VERTEX || m_result.origin[at].index[0] != original)
      {
        refuse("vertex " + std::to_string(at) + " lies elsewhere");
      }
      if (m_root_of[m_glued[at]] >= 0) { refuse("a seam joins vertex " + std::to_string(at) + " to another"); }
      m_local[at] = m_root_of[m_glued[at]] = static_cast<Index>(place.size());
      place.push_back(at);
    }
  }

  // The vertices of some faces that have no place yet, sorted.
  std::vector<Index> find_others(const std::vector<Index>& faces)
  {
    std::vector<Index> others;
    for (Index f : faces)
      for (Index v : m_result.faces[f])
      {
        if (m_local[v] < 0)
        {
          m_local[v] = 0;
          others.push_back(v);
        }
      }
    std::sort(others.begin(), others.end());
    return others;
  }

  const Examination& m_examination;
  const Result_mesh& m_result;
  Index m_input_vertices, m_new_vertices;
  std::vector<Index> m_glued;   // of each vertex of the result
  std::vector<Index> m_local;   // of each vertex of the result: in the disc, or -1
  std::vector<Index> m_root_of; // of glued vertices: in the root, or -1
};

} // namespace

Cut_disc cut_disc_of(const Triangle_surface& root, const Cut& cut)
{
  Cut_disc result;
  result.disc = surface_of(cut.surface, cut.opened);
  const Index refined = cut.surface.number_of_vertices();
  std::vector<Index> original;
  for (Index v = 0; v < result.disc.number_of_vertices(); ++v)
  {
    const Index w = v < refined ? v : cut.opened.copy_of[v - refined];
    original.push_back(w < root.number_of_vertices() ? w : -1);
  }
  result.is_touched = find_touched_vertices(root, result.disc, original);
  return result;
}

std::vector<Cut_disc> cut_discs_of(const Polygon_soup& input, const Examination& examination, const Result_mesh& result)
{
  const Index new_vertices = count_new_vertices(input, examination, result);
  const std::size_t components = examination.components.size();
  const auto faces = group_faces(result, static_cast<Index>(components));
  Disc_extractor extractor(input, examination, result, new_vertices);
  std::vector<Cut_disc> discs;
  for (std::size_t i = 0; i < components; ++i)
  {
    discs.push_back(extractor.extract(examination.components[i], faces[i]));
  }
  return discs;
}

} // namespace meridian
