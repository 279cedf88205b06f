// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/place_crossings.h>

#include <algorithm>
#include <set>
#include <tuple>

namespace meridian {

namespace internal {

bool is_before(const Piece_crossing& a, const Piece_crossing& b)
{
  if (a.edge != b.edge) { return a.edge < b.edge; }
  return a.from_source ? std::tie(a.piece, a.place) < std::tie(b.piece, b.place)
                       : std::tie(b.piece, b.place) < std::tie(a.piece, a.place);
}

namespace {

// What a crossing keeps from end `v` of its edge.
double margin_at(const Triangle_surface& s, Index v, Index edge)
{
  constexpr double margin = 0.05; // of its edge, a crossing keeps from its ends and, if there is room, from others;
  constexpr double beside = 0.25; // but of the shortest edge at a vertex, no more than this
  constexpr double least_margin = 1e-3;
  double shortest = s.length(edge);
  const double whole = shortest;
  s.for_each_outgoing(v, [&](Index h) { shortest = std::min(shortest, s.length(h)); });
  return std::max(least_margin, whole > 0 ? std::min(margin, beside * shortest / whole) : margin);
}

// Places the crossings of curves: first on their edges, then some of them in vertices.
class Crossing_placer
{
public:
  Crossing_placer(const Triangle_surface& s, const std::vector<std::vector<Piece_crossing>>& curves, bool closed,
                  const std::function<bool(Index)>& is_free)
    : m_surface(s), m_curves(curves), m_is_closed(closed), m_is_free(is_free), m_placed(curves.size())
  {
    for (std::size_t c = 0; c < curves.size(); ++c) { m_placed[c].resize(curves[c].size()); }
  }

  std::vector<Surface_curve> place()
  {
    space_out();
    pass_vertices(find_runs());
    std::vector<Surface_curve> result(m_curves.size());
    for (std::size_t c = 0; c < m_curves.size(); ++c)
    {
      result[c].closed = m_is_closed;
      for (std::size_t i = 0; i < m_curves[c].size(); ++i)
      {
        const Piece_crossing& x = m_curves[c][i];
        const Placed& p = m_placed[c][i];
        if (p.vertex >= 0) { result[c].points.push_back(Curve_point::on_vertex(p.vertex)); }
        else if (p.vertex == none)
          result[c].points.push_back({{x.halfedge, turn_fraction(m_surface, x.halfedge, p.fraction)}, -1, x.node});
      }
    }
    return result;
  }

private:
  static constexpr Index none = -1, dropped = -2;

  // Where a crossing goes.
  struct Placed
  {
    double fraction = 0;
    bool is_first = false, is_last = false; // of all on its edge
    Index vertex = none;                    // the vertex in its place; `dropped` where another stands for it
  };
  struct Place
  {
    std::size_t curve, position;
  };
  // A longest stretch of crossings whose edges share a vertex, which the curve goes round.
  struct Run
  {
    double reach; // the largest fraction from the vertex
    std::size_t curve, begin, length;
    Index vertex;
  };

  const Piece_crossing& at(const Place& p) const { return m_curves[p.curve][p.position]; }
  Placed& placed(const Place& p) { return m_placed[p.curve][p.position]; }

  // Gives the crossings of every edge fractions that keep their order and some distance.
  void space_out()
  {
    std::vector<Place> places;
    for (std::size_t c = 0; c < m_curves.size(); ++c)
      for (std::size_t i = 0; i < m_curves[c].size(); ++i) { places.push_back({c, i}); }
    std::sort(places.begin(), places.end(), [&](const Place& p, const Place& q) { return is_before(at(p), at(q)); });
    for (std::size_t i = 0, j; i < places.size(); i = j)
    {
      for (j = i; j < places.size() && at(places[j]).edge == at(places[i]).edge; ++j) {}
      space_out(places, i, j);
    }
  }

  // Those of one edge, from `begin` to before `end`: up from its source first, then down from its target.
  void space_out(const std::vector<Place>& places, std::size_t begin, std::size_t end)
  {
    constexpr double part = 0.3; // all margins on an edge take no more than this of it
    const Index e = at(places[begin]).edge;
    const double room = part / static_cast<double>(end - begin + 1);
    const double from_source = std::min(room, margin_at(m_surface, m_surface.source(e), e)),
                 from_target = std::min(room, margin_at(m_surface, m_surface.target(e), e));
    const double gap = std::min(from_source, from_target);
    double least = from_source - gap, most = 1 - from_target + gap;
    const auto is_one = [&](std::size_t k) {
      return at(places[k]).node >= 0 && at(places[k]).node == at(places[k - 1]).node;
    };
    for (std::size_t k = begin; k < end; ++k)
    {
      double& t = placed(places[k]).fraction;
      t = least = std::max(at(places[k]).t, least + (k > begin && is_one(k) ? 0 : gap));
    }
    for (std::size_t k = end; k-- > begin;)
    {
      double& t = placed(places[k]).fraction;
      t = most = std::min(t, most - (k + 1 < end && is_one(k + 1) ? 0 : gap));
    }
    placed(places[begin]).is_first = true;
    placed(places[end - 1]).is_last = true;
  }

  bool touches(std::size_t c, std::size_t i, Index v) const
  {
    const Index e = m_curves[c][i % m_curves[c].size()].edge;
    return m_surface.source(e) == v || m_surface.target(e) == v;
  }

  // How far from `v` a crossing was before it was placed; 2 if another is nearer to `v`.
  double reach_from(std::size_t c, std::size_t i, Index v) const
  {
    const Piece_crossing& x = m_curves[c][i];
    const bool is_source = m_surface.source(x.edge) == v;
    if (!(is_source ? m_placed[c][i].is_first : m_placed[c][i].is_last)) { return 2.; }
    return is_source ? x.t : 1 - x.t;
  }

  // The runs that come close to their vertices, the closest first.
  std::vector<Run> find_runs() const
  {
    constexpr double close = 0.2; // a curve that passes a vertex within this fraction of all edges goes through it
    std::vector<Run> runs;
    for (std::size_t c = 0; c < m_curves.size(); ++c)
    {
      const auto& curve = m_curves[c];
      const std::size_t n = curve.size();
      for (std::size_t i = 0; i < n; ++i)
        for (Index v : {m_surface.source(curve[i].edge), m_surface.target(curve[i].edge)})
        {
          if ((m_is_closed || i > 0) && touches(c, i + n - 1, v)) { continue; } // not the first of its run
          if (!m_is_free(v)) { continue; }
          const Run run = run_from(c, i, v);
          if (run.length < n && run.reach <= close) { runs.push_back(run); }
        }
    }
    std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) {
      return std::tie(a.reach, a.curve, a.begin, a.vertex) < std::tie(b.reach, b.curve, b.begin, b.vertex);
    });
    return runs;
  }

  Run run_from(std::size_t c, std::size_t i, Index v) const
  {
    const auto& curve = m_curves[c];
    const std::size_t n = curve.size();
    Run run{0, c, i, 0, v};
    while (run.length < n && (m_is_closed || i + run.length < n) && touches(c, i + run.length, v))
    {
      const std::size_t k = (i + run.length) % n;
      run.reach = curve[k].node >= 0 ? 2 : std::max(run.reach, reach_from(c, k, v));
      ++run.length;
    }
    return run;
  }

  // Puts a vertex in the place of each run whose vertex is not used yet.
  void pass_vertices(const std::vector<Run>& runs)
  {
    std::vector<std::size_t> left; // points of each curve
    for (const auto& curve : m_curves) { left.push_back(curve.size()); }
    std::set<Index> used;
    for (const Run& run : runs)
    {
      auto& curve = m_placed[run.curve];
      const std::size_t n = curve.size();
      std::vector<std::size_t> own;
      for (std::size_t k = 0; k < run.length; ++k)
        if (curve[(run.begin + k) % n].vertex == none) { own.push_back((run.begin + k) % n); }
      if (own.empty() || (own.back() + n - own.front()) % n + 1 != own.size()) { continue; } // others keep its middle
      if (used.count(run.vertex) || (m_is_closed && left[run.curve] - own.size() + 1 < 3)) { continue; }
      used.insert(run.vertex);
      left[run.curve] -= own.size() - 1;
      for (std::size_t i : own) { curve[i].vertex = dropped; }
      curve[own.front()].vertex = run.vertex;
    }
  }

  const Triangle_surface& m_surface;
  const std::vector<std::vector<Piece_crossing>>& m_curves;
  bool m_is_closed;
  const std::function<bool(Index)>& m_is_free;
  std::vector<std::vector<Placed>> m_placed; // of each crossing
};

} // namespace

std::vector<Surface_curve> place_crossings(const Triangle_surface& s,
                                           const std::vector<std::vector<Piece_crossing>>& curves, bool closed,
                                           const std::function<bool(Index)>& is_free)
{
  return Crossing_placer(s, curves, closed, is_free).place();
}

} // namespace internal

} // namespace meridian
