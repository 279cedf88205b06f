// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/internal/split_face.h>

#include <meridian/base/exceptions.h>

#include <algorithm>
#include <iterator>
#include <tuple>

namespace meridian {

namespace internal {

double shape(const Point& a, const Point& b, const Point& c)
{
  std::array<double, 3> l{distance(a, b), distance(b, c), distance(c, a)};
  std::sort(l.begin(), l.end());
  const double product = l[1] * l[2];
  return product > 0 ? norm(cross(b - a, c - a)) / product : 0;
}

void triangulate_part(const std::vector<Point>& points, const Rim& rim, Triangles& out)
{
  const std::size_t n = rim.size();
  if (n < 3) { throw Internal_error("split_face: a chord joins neighbouring points of one side"); }
  if (n == 3)
  {
    out.push_back({rim[0].vertex, rim[1].vertex, rim[2].vertex});
    return;
  }
  std::vector<double> best(n * n, 0);
  std::vector<std::size_t> choice(n * n, 0);
  for (std::size_t gap = 1; gap < n; ++gap)
    for (std::size_t i = 0; i + gap < n; ++i)
    {
      const std::size_t j = i + gap;
      double& value = best[i * n + j];
      if (gap == 1)
      {
        value = 2;
        continue;
      }
      value = -1;
      const bool whole = i == 0 && j == n - 1; // the closing side is a side of the part, not a diagonal
      if (!whole && (rim[i].sides & rim[j].sides)) { continue; }
      for (std::size_t m = i + 1; m < j; ++m)
      {
        if (rim[i].sides & rim[m].sides & rim[j].sides) { continue; }
        if (best[i * n + m] < 0 || best[m * n + j] < 0) { continue; }
        const double s = std::min({shape(points[rim[i].vertex], points[rim[m].vertex], points[rim[j].vertex]),
                                   best[i * n + m], best[m * n + j]});
        const double quality = s > 0 ? s : 0; // also where a length overflowed
        if (quality > value)
        {
          value = quality;
          choice[i * n + j] = m;
        }
      }
    }
  if (best[n - 1] < 0) { throw Internal_error("split_face: a part of a face has no triangulation"); }
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, n - 1}};
  while (!open.empty())
  {
    const auto [i, j] = open.back();
    open.pop_back();
    if (j - i < 2) { continue; }
    const std::size_t m = choice[i * n + j];
    out.push_back({rim[i].vertex, rim[m].vertex, rim[j].vertex});
    open.emplace_back(m, j);
    open.emplace_back(i, m);
  }
}

void split_part(const std::vector<Point>& points, const Rim& whole,
                const std::vector<std::pair<Index, Index>>& all_chords, Triangles& out)
{
  std::vector<std::pair<Rim, std::vector<std::pair<Index, Index>>>> open{{whole, all_chords}};
  while (!open.empty())
  {
    auto [rim, chords] = std::move(open.back());
    open.pop_back();
    if (chords.empty())
    {
      triangulate_part(points, rim, out);
      continue;
    }
    const auto place = [&rim = rim](Index v) {
      for (std::size_t i = 0; i < rim.size(); ++i)
      {
        if (rim[i].vertex == v) { return i; }
      }
      throw Internal_error("split_face: two curves cross in a face");
    };
    const std::size_t a = place(chords.back().first), b = place(chords.back().second);
    chords.pop_back();
    const std::size_t i = std::min(a, b), j = std::max(a, b);
    std::pair<Rim, std::vector<std::pair<Index, Index>>> inner, outer;
    inner.first.assign(rim.begin() + i, rim.begin() + j + 1);
    outer.first.assign(rim.begin() + j, rim.end());
    outer.first.insert(outer.first.end(), rim.begin(), rim.begin() + i + 1);
    for (const auto& chord : chords)
    {
      const std::size_t p = place(chord.first), q = place(chord.second);
      const bool is_inner = i <= p && p <= j && i <= q && q <= j;
      const bool is_outer = (p <= i || p >= j) && (q <= i || q >= j);
      if (!is_inner && !is_outer) { throw Internal_error("split_face: two curves cross in a face"); }
      (is_inner ? inner : outer).second.push_back(chord);
    }
    open.push_back(std::move(outer));
    open.push_back(std::move(inner));
  }
}

void split_faces(Refined_surface& s, std::vector<Edge_point>& edge_points, std::vector<Chord>& chords,
                 Index& first_new_face, std::vector<Index>& parent)
{
  first_new_face = s.number_of_faces();
  std::sort(edge_points.begin(), edge_points.end(), [](const Edge_point& a, const Edge_point& b) {
    return std::tie(a.edge, a.t, a.vertex) < std::tie(b.edge, b.t, b.vertex);
  });
  std::sort(chords.begin(), chords.end(), [](const Chord& a, const Chord& b) {
    return std::tie(a.face, a.from, a.to) < std::tie(b.face, b.from, b.to);
  });
  std::vector<Index> faces;
  for (const Edge_point& p : edge_points)
  {
    faces.push_back(s.face(p.edge));
    if (s.opposite[p.edge] >= 0) { faces.push_back(s.face(s.opposite[p.edge])); }
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  const auto is_split = [&](Index f) { return std::binary_search(faces.begin(), faces.end(), f); };

  // Halfedges whose twins must be found again: those of the parts, and those of untouched neighbours. They belong
  // together if they lie on one old edge, or inside one face, and have the same ends: two faces may share all their
  // vertices.
  struct Loose
  {
    Index place, low, high, halfedge;
  };
  std::vector<Loose> loose;
  const auto loosen = [&](Index h, Index place) {
    loose.push_back({place, std::min(s.source(h), s.target(h)), std::max(s.source(h), s.target(h)), h});
  };
  struct Flag
  {
    Index from, to;
  };
  std::vector<Flag> flags;
  struct Parts
  {
    Index face;
    Triangles triangles;
    Rim rim;
    std::array<Index, 3> edges;
  };
  std::vector<Parts> parts;
  for (Index f : faces)
  {
    parts.push_back({f, {}, {}, {s.edge(3 * f), s.edge(3 * f + 1), s.edge(3 * f + 2)}});
    Rim& rim = parts.back().rim;
    for (int k = 0; k < 3; ++k)
    {
      const Index h = 3 * f + k, e = s.edge(h), o = s.opposite[h];
      const unsigned side = 1u << k, side_before = 1u << ((k + 2) % 3);
      const std::size_t begin = rim.size();
      rim.push_back({s.source(h), side | side_before});
      const auto first = std::lower_bound(edge_points.begin(), edge_points.end(), e,
                                          [](const Edge_point& p, Index edge) { return p.edge < edge; });
      auto last = first;
      while (last != edge_points.end() && last->edge == e) { ++last; }
      if (e == h)
      {
        for (auto p = first; p != last; ++p) { rim.push_back({p->vertex, side}); }
      }
      else
      {
        for (auto p = last; p != first; --p) { rim.push_back({std::prev(p)->vertex, side}); }
      }
      if (s.seam[h]) // its parts stay seams
      {
        for (std::size_t i = begin; i < rim.size(); ++i)
        {
          flags.push_back({rim[i].vertex, i + 1 < rim.size() ? rim[i + 1].vertex : s.target(h)});
        }
      }
      if (o >= 0 && !is_split(s.face(o))) { loosen(o, e); }
    }
    std::vector<std::pair<Index, Index>> inside;
    auto c =
      std::lower_bound(chords.begin(), chords.end(), f, [](const Chord& a, Index face) { return a.face < face; });
    for (; c != chords.end() && c->face == f; ++c) { inside.emplace_back(c->from, c->to); }
    split_part(s.points, rim, inside, parts.back().triangles);
  }

  std::vector<Index> touched; // first parts keep the index, the others are appended
  for (const Parts& p : parts)
    for (std::size_t i = 0; i < p.triangles.size(); ++i)
    {
      Index g = p.face;
      if (i == 0) { s.triangles[g] = p.triangles[0]; }
      else
      {
        g = s.number_of_faces();
        s.triangles.push_back(p.triangles[i]);
        s.face_of.push_back(s.face_of[p.face]);
        s.opposite.resize(s.number_of_halfedges());
        s.seam.resize(s.number_of_halfedges());
        parent.push_back(p.face);
      }
      touched.push_back(g);
      const auto sides = [&](Index v) {
        return std::find_if(p.rim.begin(), p.rim.end(), [&](const Rim_vertex& r) { return r.vertex == v; })->sides;
      };
      for (Index h = 3 * g; h < 3 * g + 3; ++h)
      {
        const unsigned common = sides(s.source(h)) & sides(s.target(h));
        s.opposite[h] = -1;
        s.seam[h] = 0;
        loosen(h, common == 0 ? -1 - p.face : p.edges[common == 1 ? 0 : common == 2 ? 1 : 2]);
      }
    }
  std::sort(loose.begin(), loose.end(), [](const Loose& a, const Loose& b) {
    return std::tie(a.place, a.low, a.high, a.halfedge) < std::tie(b.place, b.low, b.high, b.halfedge);
  });
  for (std::size_t i = 0; i + 1 < loose.size(); ++i)
    if (loose[i].place == loose[i + 1].place && loose[i].low == loose[i + 1].low && loose[i].high == loose[i + 1].high)
    {
      s.opposite[loose[i].halfedge] = loose[i + 1].halfedge;
      s.opposite[loose[i + 1].halfedge] = loose[i].halfedge;
      ++i;
    }
  const auto was_touched = [&](Index f) { return f >= first_new_face || is_split(f); };
  for (int pass = 0; pass < 2; ++pass) // boundary halfedges last, so that they win
    for (Index f : touched)
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        Index& out = s.outgoing[s.source(h)];
        if (pass == 0 ? out < 0 || was_touched(s.face(out)) : s.opposite[h] < 0) { out = h; }
      }
  for (const Flag& flag : flags)
  {
    const Index h = s.find_halfedge(flag.from, flag.to);
    if (h < 0) { throw Internal_error("split_face: a part of a seam is missing"); }
    s.seam[h] = 1;
    if (s.opposite[h] >= 0) { s.seam[s.opposite[h]] = 1; }
  }
}

} // namespace internal

} // namespace meridian
