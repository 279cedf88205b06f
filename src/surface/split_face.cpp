// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/internal/split_face.h>

#include <meridian/base/exceptions.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <tuple>
#include <utility>
#include <vector>

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

namespace {

// The faces that have one of the points on their rim, ascending.
std::vector<Index> faces_of(const Refined_surface& s, const std::vector<New_vertex>& new_vertices)
{
  std::vector<Index> faces;
  for (const New_vertex& p : new_vertices)
  {
    faces.push_back(s.face(p.halfedge));
    if (s.opposite[p.halfedge] >= 0) { faces.push_back(s.face(s.opposite[p.halfedge])); }
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

// Divides faces while all of the old surface can still be read, then stores the parts and joins them to what is around.
class Face_splitter
{
public:
  // Points and chords are sorted.
  Face_splitter(Refined_surface& s, const std::vector<New_vertex>& new_vertices, const std::vector<Chord>& chords)
    : m_surface(s), m_new_vertices(new_vertices), m_chords(chords), m_first_new_face(s.number_of_faces()),
      m_faces(faces_of(s, new_vertices))
  {}

  void split(std::vector<Index>& parent)
  {
    for (Index f : m_faces) { divide(f); }
    for (const Parts& parts : m_parts) { store(parts, parent); }
    join_twins();
    find_outgoing();
    restore_seams();
  }

private:
  // A halfedge whose twin must be found again: one of a part, or of an untouched neighbour. Two belong together if they
  // lie on one old edge, or inside one face, and have the same ends: two faces may share all their vertices.
  struct Loose
  {
    Index place, low, high, halfedge;
  };
  // A part of a seam.
  struct Flag
  {
    Index from, to;
  };
  // What becomes of a face. `edges` are its sides.
  struct Parts
  {
    Index face;
    Triangles triangles;
    Rim rim;
    std::array<Index, 3> edges;
  };

  bool is_split(Index f) const { return std::binary_search(m_faces.begin(), m_faces.end(), f); }

  void loosen(Index h, Index place)
  {
    const auto [low, high] = std::minmax({m_surface.source(h), m_surface.target(h)});
    m_loose.push_back({place, low, high, h});
  }

  // Triangulates the parts of a face between its chords.
  void divide(Index f)
  {
    const Refined_surface& s = m_surface;
    Parts parts{f, {}, {}, {s.edge(3 * f), s.edge(3 * f + 1), s.edge(3 * f + 2)}};
    for (int k = 0; k < 3; ++k) { add_side(parts.rim, f, k); }
    std::vector<std::pair<Index, Index>> inside;
    auto c =
      std::lower_bound(m_chords.begin(), m_chords.end(), f, [](const Chord& a, Index face) { return a.face < face; });
    for (; c != m_chords.end() && c->face == f; ++c) { inside.emplace_back(c->from, c->to); }
    split_part(s.points, parts.rim, inside, parts.triangles);
    m_parts.push_back(std::move(parts));
  }

  // Appends corner `k` of a face and the points on the side after it to the rim, and notes what lies along that side.
  void add_side(Rim& rim, Index f, int k)
  {
    const Index h = 3 * f + k, e = m_surface.edge(h), o = m_surface.opposite[h];
    const unsigned side = 1u << k, side_before = 1u << ((k + 2) % 3);
    const std::size_t begin = rim.size();
    rim.push_back({m_surface.source(h), side | side_before});
    add_points(rim, e, e == h, side);
    if (m_surface.seam[h]) // its parts stay seams
    {
      for (std::size_t i = begin; i < rim.size(); ++i)
      {
        m_flags.push_back({rim[i].vertex, i + 1 < rim.size() ? rim[i + 1].vertex : m_surface.target(h)});
      }
    }
    if (o >= 0 && !is_split(m_surface.face(o))) { loosen(o, e); }
  }

  // Appends the new points of an edge, along it or against it.
  void add_points(Rim& rim, Index e, bool along, unsigned side) const
  {
    const auto first = std::lower_bound(m_new_vertices.begin(), m_new_vertices.end(), e,
                                        [](const New_vertex& p, Index edge) { return p.halfedge < edge; });
    auto last = first;
    while (last != m_new_vertices.end() && last->halfedge == e) { ++last; }
    if (along)
    {
      for (auto p = first; p != last; ++p) { rim.push_back({p->vertex, side}); }
    }
    else
    {
      for (auto p = last; p != first; --p) { rim.push_back({std::prev(p)->vertex, side}); }
    }
  }

  // The first part keeps the index of the face, the others are appended.
  void store(const Parts& parts, std::vector<Index>& parent)
  {
    for (std::size_t i = 0; i < parts.triangles.size(); ++i)
    {
      const Index g = i == 0 ? parts.face : append_face(parts.face, parent);
      m_surface.triangles[g] = parts.triangles[i];
      m_touched.push_back(g);
      loosen_sides(g, parts);
    }
  }

  Index append_face(Index of, std::vector<Index>& parent)
  {
    const Index g = m_surface.number_of_faces();
    m_surface.triangles.emplace_back();
    m_surface.face_of.push_back(m_surface.face_of[of]);
    m_surface.opposite.resize(m_surface.number_of_halfedges());
    m_surface.seam.resize(m_surface.number_of_halfedges());
    parent.push_back(of);
    return g;
  }

  // The sides of a part lie on the side of the face that both ends are on, or inside it.
  void loosen_sides(Index g, const Parts& parts)
  {
    const auto sides = [&](Index v) {
      return std::find_if(parts.rim.begin(), parts.rim.end(), [&](const Rim_vertex& r) { return r.vertex == v; })
        ->sides;
    };
    for (Index h = 3 * g; h < 3 * g + 3; ++h)
    {
      const unsigned common = sides(m_surface.source(h)) & sides(m_surface.target(h));
      m_surface.opposite[h] = -1;
      m_surface.seam[h] = 0;
      loosen(h, common == 0 ? -1 - parts.face : parts.edges[common == 1 ? 0 : common == 2 ? 1 : 2]);
    }
  }

  void join_twins()
  {
    std::sort(m_loose.begin(), m_loose.end(), [](const Loose& a, const Loose& b) {
      return std::tie(a.place, a.low, a.high, a.halfedge) < std::tie(b.place, b.low, b.high, b.halfedge);
    });
    for (std::size_t i = 0; i + 1 < m_loose.size(); ++i)
    {
      const Loose &a = m_loose[i], &b = m_loose[i + 1];
      if (std::tie(a.place, a.low, a.high) != std::tie(b.place, b.low, b.high)) { continue; }
      m_surface.opposite[a.halfedge] = b.halfedge;
      m_surface.opposite[b.halfedge] = a.halfedge;
      ++i;
    }
  }

  void find_outgoing()
  {
    const auto was_touched = [&](Index f) { return f >= m_first_new_face || is_split(f); };
    for (int pass = 0; pass < 2; ++pass) // boundary halfedges last, so that they win
      for (Index f : m_touched)
        for (Index h = 3 * f; h < 3 * f + 3; ++h)
        {
          Index& out = m_surface.outgoing[m_surface.source(h)];
          if (pass == 0 ? out < 0 || was_touched(m_surface.face(out)) : m_surface.opposite[h] < 0) { out = h; }
        }
  }

  void restore_seams()
  {
    for (const Flag& flag : m_flags)
    {
      const Index h = m_surface.find_halfedge(flag.from, flag.to);
      if (h < 0) { throw Internal_error("split_face: a part of a seam is missing"); }
      m_surface.seam[h] = 1;
      if (m_surface.opposite[h] >= 0) { m_surface.seam[m_surface.opposite[h]] = 1; }
    }
  }

  Refined_surface& m_surface;
  const std::vector<New_vertex>& m_new_vertices;
  const std::vector<Chord>& m_chords;
  Index m_first_new_face;
  std::vector<Index> m_faces; // that are split
  std::vector<Loose> m_loose;
  std::vector<Flag> m_flags;
  std::vector<Parts> m_parts;
  std::vector<Index> m_touched; // the faces of all parts
};

} // namespace

void split_faces(Refined_surface& s, std::vector<New_vertex>& new_vertices, std::vector<Chord>& chords,
                 Index& first_new_face, std::vector<Index>& parent)
{
  first_new_face = s.number_of_faces();
  std::sort(new_vertices.begin(), new_vertices.end(), [](const New_vertex& a, const New_vertex& b) {
    return std::tie(a.halfedge, a.t, a.vertex) < std::tie(b.halfedge, b.t, b.vertex);
  });
  std::sort(chords.begin(), chords.end(), [](const Chord& a, const Chord& b) {
    return std::tie(a.face, a.from, a.to) < std::tie(b.face, b.from, b.to);
  });
  Face_splitter(s, new_vertices, chords).split(parent);
}

} // namespace internal

} // namespace meridian
