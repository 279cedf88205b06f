// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_PLACE_CROSSINGS_H
#define MERIDIAN_CURVES_PLACE_CROSSINGS_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <vector>

namespace meridian {
namespace internal {

// A crossing of a curve with an edge. On one edge crossings are ordered by (piece, place), integers and the start of a
// piece, counted from the edge's lower end if `from_source` is set and from its higher end otherwise.
struct Crossing
{
  Index halfedge;   // by which the curve leaves a face
  Index edge;       // its edge
  double piece;     // where the piece of the edge begins
  Index place;      // the order within the piece
  double t;         // fraction along `edge`
  bool from_source; // whether (piece, place) grows along `edge`
  Index node = -1;  // crossings with the same number from 0 on stand together on one edge and become one point
};

// The order of crossings on an edge, edge by edge.
bool is_before(const Crossing& a, const Crossing& b);

// Gives every crossing its final fraction and lets curves pass through vertices that they come close to.
//
// `is_free(v)` tells whether a curve may pass through `v` at all. Curves need at least one crossing.
template <class Is_free>
std::vector<Surface_curve> place_crossings(const Triangle_surface& s, const std::vector<std::vector<Crossing>>& curves,
                                           bool closed, const Is_free& is_free)
{
  constexpr double margin = 0.05; // of its edge, a crossing keeps from its ends and, if there is room, from others;
  constexpr double beside = 0.25; // but of the shortest edge at a vertex, no more than this,
  constexpr double least_margin = 1e-3;
  constexpr double part = 0.3; // and all crossings of an edge no more than this of it
  const auto margin_at = [&](Index v, Index edge) {
    double shortest = s.length(edge);
    const double whole = shortest;
    s.for_each_outgoing(v, [&](Index h) { shortest = std::min(shortest, s.length(h)); });
    return std::max(least_margin, whole > 0 ? std::min(margin, beside * shortest / whole) : margin);
  };
  constexpr double close = 0.2; // a curve that passes a vertex within this fraction of all edges goes through it

  struct Place
  {
    std::size_t curve, position;
  };
  std::vector<Place> places;
  for (std::size_t c = 0; c < curves.size(); ++c)
    for (std::size_t i = 0; i < curves[c].size(); ++i) { places.push_back({c, i}); }
  const auto at = [&](const Place& p) -> const Crossing& { return curves[p.curve][p.position]; };
  std::sort(places.begin(), places.end(), [&](const Place& p, const Place& q) { return is_before(at(p), at(q)); });

  std::vector<std::vector<double>> raw(curves.size()), fraction(curves.size());
  std::vector<std::vector<char>> nearest_source(curves.size()), nearest_target(curves.size());
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    raw[c].resize(curves[c].size());
    fraction[c].resize(curves[c].size());
    nearest_source[c].resize(curves[c].size(), 0);
    nearest_target[c].resize(curves[c].size(), 0);
  }
  for (std::size_t i = 0, j; i < places.size(); i = j)
  {
    for (j = i; j < places.size() && at(places[j]).edge == at(places[i]).edge; ++j) {}
    const Index e = at(places[i]).edge;
    const double room = part / static_cast<double>(j - i + 1);
    const double from_source = std::min(room, margin_at(s.source(e), e)),
                 from_target = std::min(room, margin_at(s.target(e), e));
    const double gap = std::min(from_source, from_target);
    double least = from_source - gap, most = 1 - from_target + gap;
    const auto is_one = [&](std::size_t k) {
      return at(places[k]).node >= 0 && at(places[k]).node == at(places[k - 1]).node;
    };
    for (std::size_t k = i; k < j; ++k)
    {
      double& t = fraction[places[k].curve][places[k].position];
      raw[places[k].curve][places[k].position] = at(places[k]).t;
      t = least = std::max(at(places[k]).t, least + (k > i && is_one(k) ? 0 : gap));
    }
    for (std::size_t k = j; k-- > i;)
    {
      double& t = fraction[places[k].curve][places[k].position];
      t = most = std::min(t, most - (k + 1 < j && is_one(k + 1) ? 0 : gap));
    }
    nearest_source[places[i].curve][places[i].position] = 1;
    nearest_target[places[j - 1].curve][places[j - 1].position] = 1;
  }

  // A run is a longest stretch of crossings whose edges share a vertex, which the curve goes round.
  struct Run
  {
    double reach;
    std::size_t curve, begin, length;
    Index vertex;
  };
  std::vector<Run> runs;
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    const auto& curve = curves[c];
    const std::size_t n = curve.size();
    const auto touches = [&](std::size_t i, Index v) {
      return s.source(curve[i % n].edge) == v || s.target(curve[i % n].edge) == v;
    };
    const auto from = [&](std::size_t i, Index v) { // fraction from `v`, or 2 if another crossing is nearer to it
      const bool is_source = s.source(curve[i % n].edge) == v;
      if (!(is_source ? nearest_source : nearest_target)[c][i % n]) { return 2.; }
      return is_source ? raw[c][i % n] : 1 - raw[c][i % n];
    };
    for (std::size_t i = 0; i < n; ++i)
      for (Index v : {s.source(curve[i].edge), s.target(curve[i].edge)})
      {
        if ((closed || i > 0) && touches(i + n - 1, v)) { continue; } // not the first of its run
        if (!is_free(v)) { continue; }
        Run run{0, c, i, 0, v};
        while (run.length < n && (closed || i + run.length < n) && touches(i + run.length, v))
        {
          run.reach = curve[(i + run.length) % n].node >= 0 ? 2 : std::max(run.reach, from(i + run.length, v));
          ++run.length;
        }
        if (run.length < n && run.reach <= close) { runs.push_back(run); }
      }
  }
  std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) {
    return std::tie(a.reach, a.curve, a.begin, a.vertex) < std::tie(b.reach, b.curve, b.begin, b.vertex);
  });
  std::vector<std::vector<Index>> passes(curves.size()); // the vertex in place of a crossing; -2 where one is dropped
  for (std::size_t c = 0; c < curves.size(); ++c) { passes[c].assign(curves[c].size(), -1); }
  std::vector<std::size_t> left(curves.size());
  for (std::size_t c = 0; c < curves.size(); ++c) { left[c] = curves[c].size(); }
  std::set<Index> used;
  for (const Run& run : runs)
  {
    auto& pass = passes[run.curve];
    const std::size_t n = pass.size();
    std::vector<std::size_t> own;
    for (std::size_t k = 0; k < run.length; ++k)
      if (pass[(run.begin + k) % n] == -1) { own.push_back((run.begin + k) % n); }
    if (own.empty() || (own.back() + n - own.front()) % n + 1 != own.size()) { continue; } // others keep its middle
    if (used.count(run.vertex) || (closed && left[run.curve] - own.size() + 1 < 3)) { continue; }
    used.insert(run.vertex);
    left[run.curve] -= own.size() - 1;
    for (std::size_t i : own) { pass[i] = -2; }
    pass[own.front()] = run.vertex;
  }

  std::vector<Surface_curve> result(curves.size());
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    result[c].closed = closed;
    for (std::size_t i = 0; i < curves[c].size(); ++i)
    {
      const Crossing& x = curves[c][i];
      if (passes[c][i] >= 0) { result[c].points.push_back(Curve_point::on_vertex(passes[c][i])); }
      else if (passes[c][i] == -1)
        result[c].points.push_back(
          {-1, x.halfedge, x.edge == x.halfedge ? fraction[c][i] : 1 - fraction[c][i], x.node});
    }
  }
  return result;
}

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CURVES_PLACE_CROSSINGS_H
