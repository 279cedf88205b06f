// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/find_arc.h>

#include <meridian/curves/sleeve.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/shortest_ways.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

namespace {

// The vertices of the border of a disc, in order.
std::vector<Index> border_of(const Triangle_surface& disc)
{
  std::vector<Index> border;
  const auto loops = boundary_loops(disc);
  for (Index h : loops.front()) { border.push_back(disc.source(h)); }
  return border;
}

// What an arc shall keep out of: it is farther away than anything else, and what is reached across it too.
class Detours
{
public:
  Detours(const Triangle_surface& disc, const std::vector<char>& kept_out) : m_disc(disc), m_kept_out(kept_out)
  {
    for (Index h = 0; h < disc.number_of_halfedges() && !kept_out.empty(); ++h) { m_length += disc.length(h); }
  }

  double into(Index f) const { return is_kept_out(f) ? m_length : 0; }
  double along(Index h) const
  {
    const Index o = m_disc.opposite[h];
    return is_kept_out(m_disc.face(h)) && (o < 0 || is_kept_out(m_disc.face(o))) ? m_length : 0;
  }
  // Whether a way of some length makes one.
  bool makes(double length) const { return !m_kept_out.empty() && !(length < m_length); }

private:
  bool is_kept_out(Index f) const { return !m_kept_out.empty() && m_kept_out[f]; }

  const Triangle_surface& m_disc;
  const std::vector<char>& m_kept_out;
  double m_length = 0;
};

// The Voronoi diagram of the border's vertices, face by face. The distance of a face is measured to the middle of the
// edge by which it was entered.
class Face_cells
{
public:
  Face_cells(const Triangle_surface& disc, const std::vector<Index>& border, const Detours& detours)
    : m_disc(disc), m_border(border), m_detours(detours), m_reached(disc.number_of_faces())
  {
    grow();
  }

  // The place along the border of the vertex in whose cell a face is.
  Index cell(Index f) const { return m_reached[f].cell; }
  // The length of the way from there through a face to the middle of one of its halfedges.
  double length_to(Index h) const
  {
    const Reached& r = m_reached[m_disc.face(h)];
    return r.distance + distance(r.entry, m_disc.point_on(h, 0.5));
  }

  // The halfedges that are crossed on the way from the border to a face, and the vertex where it begins.
  Index way_to(Index f, std::vector<Index>& halfedges) const
  {
    halfedges.clear();
    for (; m_reached[f].by >= 0; f = m_disc.face(m_reached[f].by)) { halfedges.push_back(m_reached[f].by); }
    std::reverse(halfedges.begin(), halfedges.end());
    return m_border[cell(f)];
  }

private:
  struct Reached
  {
    double distance = std::numeric_limits<double>::infinity();
    Point entry{0, 0, 0};
    Index by = -1; // the halfedge by which the face before was left
    Index cell = -1;
  };

  void grow()
  {
    Nearest_first<Index> queue;
    for (std::size_t i = 0; i < m_border.size(); ++i)
      m_disc.for_each_outgoing(m_border[i], [&](Index h) {
        Reached& r = m_reached[m_disc.face(h)];
        if (r.cell >= 0) { return; }
        r = {m_detours.into(m_disc.face(h)), m_disc.points[m_border[i]], -1, static_cast<Index>(i)};
        queue.reach(r.distance, m_disc.face(h));
      });
    std::vector<char> is_done(m_disc.number_of_faces(), 0);
    queue.search([&](double, Index f) {
      if (std::exchange(is_done[f], 1)) { return false; }
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        if (m_disc.opposite[h] < 0 || is_done[m_disc.face(m_disc.opposite[h])]) { continue; }
        const double d = length_to(h) + m_detours.into(m_disc.face(m_disc.opposite[h]));
        Reached& r = m_reached[m_disc.face(m_disc.opposite[h])];
        if (!(d < r.distance)) { continue; }
        r = {d, m_disc.point_on(h, 0.5), h, cell(f)};
        queue.reach(d, m_disc.face(m_disc.opposite[h]));
      }
      return false;
    });
  }

  const Triangle_surface& m_disc;
  const std::vector<Index>& m_border;
  const Detours& m_detours;
  std::vector<Reached> m_reached;
};

// The same vertex by vertex, along edges.
class Vertex_cells
{
public:
  Vertex_cells(const Triangle_surface& disc, const std::vector<Index>& border, const Detours& detours)
    : m_disc(disc), m_by(disc.number_of_vertices(), -1), m_cell(disc.number_of_vertices(), -1)
  {
    std::vector<std::pair<double, Index>> starts;
    for (Index v : border)
    {
      m_cell[v] = static_cast<Index>(starts.size());
      starts.emplace_back(0, v);
    }
    m_distance = find_shortest_ways(disc.number_of_vertices(), starts, [&](Index v, const auto& reach) {
      disc.for_each_outgoing(v, [&](Index h) {
        if (!reach(disc.target(h), disc.length(h) + detours.along(h))) { return; }
        m_by[disc.target(h)] = h;
        m_cell[disc.target(h)] = m_cell[v];
      });
    });
  }

  Index cell(Index v) const { return m_cell[v]; }
  double distance_of(Index v) const { return m_distance[v]; }
  Index cell_of_face(Index f) const
  {
    const auto& t = m_disc.triangles[f];
    return m_cell[*std::min_element(t.begin(), t.end(),
                                    [&](Index v, Index w) { return m_distance[v] < m_distance[w]; })];
  }
  // The vertices from one to the border.
  std::vector<Index> way_from(Index v) const
  {
    std::vector<Index> way{v};
    for (; m_by[v] >= 0; v = m_disc.source(m_by[v])) { way.push_back(m_disc.source(m_by[v])); }
    return way;
  }

private:
  const Triangle_surface& m_disc;
  std::vector<Index> m_by, m_cell; // of each vertex: the halfedge that leads to it, the place of the border's vertex
  std::vector<double> m_distance;
};

// How many of some pairs of faces a cut between two places of the border parts: counted for pairs of stretches of the
// border, on either side of which faces are nearest.
class Pair_counts
{
public:
  // `cell`: of each face.
  Pair_counts(std::size_t border, const std::vector<Index>& cell, const std::vector<std::array<Index, 2>>& pairs)
    : m_border(border), m_pairs(static_cast<double>(pairs.size())), m_bins(std::min<std::size_t>(border, 64)),
      m_counts((m_bins + 1) * (m_bins + 1), 0)
  {
    for (const auto& [f, g] : pairs)
    {
      const std::size_t a = bin(cell[f]), b = bin(cell[g]);
      ++at(a + 1, b + 1);
      ++at(b + 1, a + 1);
    }
    for (std::size_t a = 1; a <= m_bins; ++a)
      for (std::size_t b = 1; b <= m_bins; ++b) { at(a, b) += at(a - 1, b) + at(a, b - 1) - at(a - 1, b - 1); }
  }

  bool is_empty() const { return !(m_pairs > 0); }

  // The part of the pairs that have one place from `first` to before `last`, and the other elsewhere.
  double parted(Index first, Index last) const
  {
    const std::size_t a = bin(first), b = bin(last);
    return (at(b, m_bins) - at(a, m_bins) - (at(b, b) - at(a, b) - at(b, a) + at(a, a))) / m_pairs;
  }

private:
  std::size_t bin(Index place) const { return static_cast<std::size_t>(place) * m_bins / m_border; }
  double& at(std::size_t a, std::size_t b) { return m_counts[a * (m_bins + 1) + b]; }
  double at(std::size_t a, std::size_t b) const { return m_counts[a * (m_bins + 1) + b]; }

  std::size_t m_border;
  double m_pairs;
  std::size_t m_bins;
  std::vector<double> m_counts; // of pairs with both places before two bins
};

// An arc: across a halfedge, or along one that joins two vertices of the border.
struct Arc_candidate
{
  double cost;
  Index halfedge;
  bool along;
};

// What arcs between two places of the border bring.
class Arc_values
{
public:
  // `cell`: of each face.
  Arc_values(const Triangle_surface& disc, std::size_t border, const std::vector<Index>& cell,
             const std::vector<std::array<Index, 2>>& apart, const Detours& detours)
    : m_pairs(border, cell, apart), m_detours(detours), m_area_before(border + 1, 0)
  {
    for (Index f = 0; f < disc.number_of_faces(); ++f)
    {
      const auto& t = disc.triangles[f];
      m_area_before[cell[f] + 1] +=
        norm(cross(disc.points[t[1]] - disc.points[t[0]], disc.points[t[2]] - disc.points[t[0]])) / 2;
    }
    for (std::size_t i = 0; i < border; ++i) { m_area_before[i + 1] += m_area_before[i]; }
  }

  // Adds an arc to some candidates, unless it brings nothing.
  void add(std::vector<Arc_candidate>& all, Index a, Index b, double length, Index h, bool along) const
  {
    if (a == b || m_detours.makes(length)) { return; }
    const double smaller = smaller_part(std::min(a, b), std::max(a, b));
    const double parted = m_pairs.is_empty() ? 1 : m_pairs.parted(std::min(a, b), std::max(a, b));
    if (!(smaller > 0) || !(parted > 0)) { return; }
    // to part what should be apart counts for more than a short way
    all.push_back({length / (smaller * parted * parted), h, along});
  }

  static void sort(std::vector<Arc_candidate>& all)
  {
    std::sort(all.begin(), all.end(), [](const Arc_candidate& x, const Arc_candidate& y) {
      return x.cost < y.cost || (!(y.cost < x.cost) && x.halfedge < y.halfedge);
    });
  }

private:
  // The area of the smaller part, as a part of all. Cells that the arc goes through itself are large at the tips of
  // slits, and how they are divided is not known: they hardly count.
  double smaller_part(Index a, Index b) const
  {
    constexpr double hardly = 1e-3;
    const double whole = m_area_before.back(), with = m_area_before[b] - m_area_before[a],
                 without = m_area_before[b] - m_area_before[a + 1],
                 beyond = whole - m_area_before[b + 1] + m_area_before[a];
    return (std::min(without, beyond) + hardly * std::min(with, whole - with)) / whole;
  }

  const Pair_counts m_pairs;
  const Detours& m_detours;
  std::vector<double> m_area_before; // of the cells before each place
};

// The arc of a candidate, straight, or nothing if it shrinks to a part of the border.
Surface_curve straight_arc(const Triangle_surface& disc, const Face_cells& cells, const Detours& detours,
                           const Arc_candidate& c)
{
  Sleeve sleeve{disc.source(c.halfedge), disc.target(c.halfedge), {}};
  if (!c.along)
  {
    std::vector<Index> back;
    sleeve.start = cells.way_to(disc.face(c.halfedge), sleeve.halfedges);
    sleeve.end = cells.way_to(disc.face(disc.opposite[c.halfedge]), back);
    sleeve.halfedges.push_back(c.halfedge);
    for (auto h = back.rbegin(); h != back.rend(); ++h) { sleeve.halfedges.push_back(disc.opposite[*h]); }
    trim(disc, sleeve);
    if (sleeve.halfedges.empty())
    {
      const Index h = disc.find_halfedge(sleeve.start, sleeve.end);
      if (sleeve.start == sleeve.end || h < 0 || disc.opposite[h] < 0) { return {}; }
    }
  }
  const auto may_cross = [&](Index h) {
    const Index o = disc.opposite[h];
    return o >= 0 && !(detours.into(disc.face(h)) > 0) && !(detours.into(disc.face(o)) > 0);
  };
  return shortest_curve(disc, sleeve, may_cross, [&](Index v) { return !disc.is_boundary_vertex(v); });
}

Surface_curve find_straight_arc(const Triangle_surface& disc, const std::vector<std::array<Index, 2>>& apart,
                                const std::function<bool(const Surface_curve&)>& is_good, const Detours& detours)
{
  const std::vector<Index> border = border_of(disc);
  std::vector<Index> place(disc.number_of_vertices(), -1), cell;
  for (std::size_t i = 0; i < border.size(); ++i) { place[border[i]] = static_cast<Index>(i); }
  const Face_cells cells(disc, border, detours);
  for (Index f = 0; f < disc.number_of_faces(); ++f) { cell.push_back(cells.cell(f)); }
  const Arc_values values(disc, border.size(), cell, apart, detours);
  std::vector<Arc_candidate> all;
  for (Index h = 0; h < disc.number_of_halfedges(); ++h)
  {
    const Index o = disc.opposite[h];
    if (o < h) { continue; }
    const Index a = place[disc.source(h)], b = place[disc.target(h)];
    if (a >= 0 && b >= 0) { values.add(all, a, b, disc.length(h) + detours.along(h), h, true); }
    values.add(all, cell[disc.face(h)], cell[disc.face(o)], cells.length_to(h) + cells.length_to(o), h, false);
  }
  Arc_values::sort(all);
  int left = 100;
  for (const Arc_candidate& candidate : all)
  {
    Surface_curve arc = straight_arc(disc, cells, detours, candidate);
    if (arc.points.empty()) { continue; }
    if (!is_good || is_good(arc)) { return arc; }
    if (--left == 0) { break; }
  }
  return {};
}

Surface_curve find_arc_of_edges(const Triangle_surface& disc, const std::vector<std::array<Index, 2>>& apart,
                                const Detours& detours)
{
  const std::vector<Index> border = border_of(disc);
  const Vertex_cells cells(disc, border, detours);
  std::vector<Index> cell;
  for (Index f = 0; f < disc.number_of_faces(); ++f) { cell.push_back(cells.cell_of_face(f)); }
  const Arc_values values(disc, border.size(), cell, apart, detours);
  std::vector<Arc_candidate> all;
  for (Index h = 0; h < disc.number_of_halfedges(); ++h)
  {
    if (disc.opposite[h] < h) { continue; }
    const Index v = disc.source(h), w = disc.target(h);
    values.add(all, cells.cell(v), cells.cell(w),
               cells.distance_of(v) + disc.length(h) + detours.along(h) + cells.distance_of(w), h, true);
  }
  if (all.empty()) { return {}; }
  Arc_values::sort(all);
  std::vector<Index> path = cells.way_from(disc.source(all.front().halfedge));
  std::reverse(path.begin(), path.end());
  const std::vector<Index> rest = cells.way_from(disc.target(all.front().halfedge));
  path.insert(path.end(), rest.begin(), rest.end());
  Surface_curve arc;
  for (Index v : path) { arc.points.push_back(Curve_point::on_vertex(v)); }
  return arc;
}

} // namespace

} // namespace internal

Surface_curve find_arc(const Triangle_surface& disc, const std::vector<std::array<Index, 2>>& apart, bool on_edges,
                       const std::function<bool(const Surface_curve&)>& is_good, const std::vector<char>& kept_out)
{
  const internal::Detours detours(disc, kept_out);
  return on_edges ? internal::find_arc_of_edges(disc, apart, detours)
                  : internal::find_straight_arc(disc, apart, is_good, detours);
}

} // namespace meridian
