// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/handles/internal/flow_loops.h>

#include <meridian/base/Polygon_soup.h>
#include <meridian/curves/chords.h>
#include <meridian/curves/contours.h>
#include <meridian/curves/morse_complex.h>
#include <meridian/surface/examine_surface.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/root_edges.h>
#include <meridian/surface/shortest_ways.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

namespace {

// The faces within a distance of some others, sorted. Empty if there are more than `most`.
std::vector<Index> find_faces_within(const Triangle_surface& s, const std::vector<Index>& faces, double reach,
                                     std::size_t most)
{
  const auto centre = [&](Index f) {
    const auto& t = s.triangles[f];
    return (1. / 3) * (s.points[t[0]] + s.points[t[1]] + s.points[t[2]]);
  };
  std::unordered_map<Index, double> at;
  Nearest_first<Index> queue;
  for (Index f : faces)
  {
    at[f] = 0;
    queue.reach(0, f);
  }
  std::vector<Index> chosen;
  const bool are_too_many = queue.search([&](double d, Index f) {
    if (d > at[f]) { return false; }
    chosen.push_back(f);
    if (chosen.size() > most) { return true; }
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      if (s.opposite[h] < 0) { continue; }
      const Index g = s.face(s.opposite[h]);
      const double reached = d + distance(centre(f), centre(g));
      const auto [old, is_new] = at.try_emplace(g, reached);
      if (reached > reach || (!is_new && !(reached < old->second)))
      {
        if (is_new) { at.erase(old); }
        continue;
      }
      old->second = reached;
      queue.reach(reached, g);
    }
    return false;
  });
  if (are_too_many) { return {}; }
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

// The place of an element in a sorted list.
Index place_in(const std::vector<Index>& sorted, Index element)
{
  return static_cast<Index>(std::lower_bound(sorted.begin(), sorted.end(), element) - sorted.begin());
}

// Faces as a soup. Their vertices, sorted, are written to `vertices`.
Polygon_soup make_soup(const Triangle_surface& s, const std::vector<Index>& faces, std::vector<Index>& vertices)
{
  for (Index f : faces) { vertices.insert(vertices.end(), s.triangles[f].begin(), s.triangles[f].end()); }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  Polygon_soup soup;
  for (Index v : vertices) { soup.points.push_back(s.points[v]); }
  for (Index f : faces)
  {
    std::array<Index, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) { corners[k] = place_in(vertices, s.triangles[f][k]); }
    soup.add_polygon(corners.data(), 3);
  }
  return soup;
}

// The face to the left of the way from a point of a polyline to the next; -1 if there is none.
Index face_to_left(const Triangle_surface& s, const Curve_point& p, const Curve_point& q)
{
  const auto face_of = [&](Index along) { return along < 0 ? -1 : s.face(along); };
  const auto is_end = [&](Index v, Index h) { return s.source(h) == v || s.target(h) == v; };
  // along an edge
  if (p.is_vertex() && q.is_vertex()) { return face_of(s.find_halfedge(p.vertex, q.vertex)); }
  if (p.is_vertex() && is_end(p.vertex, q.halfedge))
  {
    return face_of(s.source(q.halfedge) == p.vertex ? q.halfedge : s.opposite[q.halfedge]);
  }
  if (q.is_vertex() && is_end(q.vertex, p.halfedge))
  {
    return face_of(s.target(p.halfedge) == q.vertex ? p.halfedge : s.opposite[p.halfedge]);
  }
  // through a face that holds both
  const auto holds = [&](const Curve_point& x, Index f) {
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      if (x.is_vertex() ? s.source(h) == x.vertex : s.edge(h) == s.edge(x.halfedge)) { return true; }
    }
    return false;
  };
  const Curve_point& inner = p.is_vertex() ? q : p;
  Index face = -1;
  for (Index h : {inner.halfedge, s.opposite[inner.halfedge]})
    if (h >= 0 && holds(p, s.face(h)) && holds(q, s.face(h))) { face = s.face(h); }
  return face;
}

// Adds the crossings at a point of a polyline between the faces on its left, before and after. False if they would
// leave the surface.
bool pass_point(const Triangle_surface& s, const Curve_point& p, Index from, Index to,
                std::vector<Edge_place>& crossings)
{
  constexpr double beside = 0.02; // of an edge, from the vertex that is passed
  if (from == to) { return true; }
  if (!p.is_vertex())
  {
    for (Index h : {p.halfedge, s.opposite[p.halfedge]})
      if (h >= 0 && s.face(h) == from) { crossings.push_back({h, h == p.halfedge ? p.t : 1 - p.t}); }
    return true;
  }
  Index h = 3 * from; // clockwise around the vertex, which stays on the right
  while (s.source(h) != p.vertex) { ++h; }
  while (s.face(h) != to)
  {
    crossings.push_back({h, beside});
    if (s.opposite[h] < 0) { return false; }
    h = s.next(s.opposite[h]);
    if (s.face(h) == from) { return false; }
  }
  return true;
}

} // namespace

Surface_patch cut_patch(const Triangle_surface& s, const std::vector<Index>& faces, Index start, double reach,
                        std::size_t most)
{
  const std::vector<Index> chosen = find_faces_within(s, faces, reach, most);
  if (chosen.empty()) { return {}; }
  std::vector<Index> vertices;
  Examination examination = examine_surface(make_soup(s, chosen, vertices), true);
  Surface_patch patch;
  for (Surface_component& c : examination.components)
  {
    if (!std::binary_search(c.triangle_of.begin(), c.triangle_of.end(), place_in(chosen, start))) { continue; }
    const auto is_flipped = std::find(c.is_flipped.begin(), c.is_flipped.end(), 1) != c.is_flipped.end();
    if (is_flipped) { return {}; }
    patch.surface = std::move(c.surface);
    for (Index f : c.triangle_of) { patch.face_of.push_back(chosen[f]); }
    for (Index v : c.vertex_of)
    {
      patch.vertex_of.push_back(
        vertices[v < static_cast<Index>(vertices.size()) ? v : examination.added_vertex_of[v - vertices.size()]]);
    }
    for (std::size_t v = 0; v < patch.vertex_of.size(); ++v)
    {
      patch.vertex.emplace(patch.vertex_of[v], static_cast<Index>(v));
    }
  }
  return patch;
}

bool push_left(const Triangle_surface& s, const std::vector<Curve_point>& loop, std::vector<Edge_place>& crossings)
{
  const std::size_t n = loop.size();
  std::vector<Index> face(n); // to the left of the way from each point to the next
  for (std::size_t i = 0; i < n; ++i)
  {
    face[i] = face_to_left(s, loop[i], loop[(i + 1) % n]);
    if (face[i] < 0) { return false; }
  }
  crossings.clear();
  for (std::size_t i = 0; i < n; ++i)
  {
    if (!pass_point(s, loop[i], face[(i + n - 1) % n], face[i], crossings)) { return false; }
  }
  return true;
}

std::vector<Flow_loop> find_flow_loops(const Normal_curves& curves, const Surface_patch& patch,
                                       const Ordered_surface& m, const std::vector<Index>& saddles, Flow_tracer& tracer)
{
  const Triangle_surface &root = curves.surface(), &local = patch.surface;
  std::vector<std::pair<Index, std::pair<Index, Index>>> pairs; // a saddle and its two lines
  for (Index saddle : saddles)
  {
    std::vector<Index> own;
    const auto first = static_cast<Index>(tracer.lines().size());
    tracer.trace(saddle);
    for (Index i = first; i < static_cast<Index>(tracer.lines().size()); ++i)
      if (m.graph.node[tracer.lines()[i].start] == m.graph.node[saddle]) { own.push_back(i); }
    if (own.size() == 2 && !m.surface.is_boundary_vertex(saddle)) { pairs.push_back({saddle, {own[0], own[1]}}); }
  }
  std::vector<Flow_loop> loops;
  for (const auto& [saddle, lines] : pairs)
  {
    const auto one = whole_line(tracer.lines(), lines.first), other = whole_line(tracer.lines(), lines.second);
    const auto key = [](const Curve_point& p) { return p.is_vertex() ? p.vertex : -1 - p.node; };
    std::unordered_map<Index, std::size_t> place;
    for (std::size_t i = 1; i < one.size(); ++i) { place.emplace(key(one[i]), i); }
    std::size_t meet = 1;
    while (meet < other.size() && !place.count(key(other[meet]))) { ++meet; }
    if (meet == other.size()) { continue; } // they come to different ends
    std::vector<Curve_point> loop(one.begin(), one.begin() + place.at(key(other[meet])) + 1);
    for (std::size_t i = meet; i-- > 1;) { loop.push_back(other[i]); }
    std::vector<Edge_place> pushed, crossings;
    if (loop.size() < 3 || !push_left(m.surface, loop, pushed)) { continue; }
    for (const Edge_place& c : pushed)
    {
      Root_stretch on;
      if (!find_stretch(local, m.surface, c.halfedge, on)) { continue; }
      const double t = on.at[0] + c.t * (on.at[1] - on.at[0]); // from the lower vertex of the edge
      const Index h = 3 * patch.face_of[local.face(on.halfedge)] + on.halfedge % 3;
      crossings.push_back({h, local.source(on.halfedge) == on.lower ? t : 1 - t});
    }
    cancel(root, crossings);
    if (crossings.size() < 3) { continue; }
    Flow_loop found{
      {}, length(m.surface, Surface_curve{loop, true}), patch.vertex_of[root_vertex(local, m.surface, saddle)]};
    for (const Edge_place& c : crossings)
    {
      found.steps.push_back({c.halfedge, 0, turn_fraction(root, c.halfedge, c.t)});
    }
    loops.push_back(std::move(found));
  }
  std::sort(loops.begin(), loops.end(), [](const Flow_loop& a, const Flow_loop& b) { return a.length < b.length; });
  return loops;
}

std::vector<Crossing> reversed(const Triangle_surface& s, std::vector<Crossing> steps)
{
  std::reverse(steps.begin(), steps.end());
  for (auto& step : steps) { step.halfedge = s.opposite[step.halfedge]; }
  return steps;
}

bool try_loop(Normal_curves& curves, Index curve, std::vector<Crossing> steps)
{
  for (auto& step : steps)
    for (Index x : curves.on(curves.surface().edge(step.halfedge))) { step.place += curves[x].t < step.t; }
  curves.add(curve, steps);
  const bool is_good = crosses_partner_once(curves, curve);
  if (is_good && runs_from_right(curves, curve)) { return true; }
  curves.remove(curve);
  if (!is_good) { return false; }
  curves.add(curve, reversed(curves.surface(), steps));
  return true;
}

} // namespace internal

} // namespace meridian
