// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/internal/network_moves.h>

#include <meridian/curves/sleeve.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/measures.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <type_traits>

namespace meridian {

namespace internal {

Network_star make_star(const Normal_curves& curves, Index v)
{
  const Triangle_surface& s = curves.surface();
  Network_star star;
  star.is_closed = !s.is_boundary_vertex(v);
  s.for_each_outgoing(v, [&](Index h) {
    star.spokes.push_back(h);
    star.angle.push_back(star.whole);
    star.whole += corner_angle(s, h);
  });
  const auto rank = [&](Index h) {
    return static_cast<Index>(std::find(star.spokes.begin(), star.spokes.end(), h) - star.spokes.begin());
  };
  for (const Network_end& e : curves.ends_at(v))
  {
    const Index x = curves.nearest(e);
    if (x < 0)
    {
      const Index edge = curves.edge_along(e.curve),
                  h = s.source(edge) == v && (s.target(edge) != v) ? edge : s.opposite[edge];
      star.arms.push_back({e, 2 * rank(h), 0, star.angle[rank(h)]});
      continue;
    }
    const Index side = e.is_last ? s.opposite[curves[x].halfedge] : curves[x].halfedge, h = s.prev(side), i = rank(h);
    const Index n = static_cast<Index>(curves.on(s.edge(side)).size());
    const Point to = s.point_on(s.edge(side), curves[x].t) - s.points[v], along = s.points[s.target(h)] - s.points[v];
    const double part = std::atan2(norm(cross(along, to)), dot(along, to));
    star.arms.push_back(
      {e, 2 * i + 1, s.edge(side) == side ? curves[x].place : n - 1 - curves[x].place, star.angle[i] + part});
  }
  std::sort(star.arms.begin(), star.arms.end(),
            [](const auto& a, const auto& b) { return std::tie(a.at, a.place) < std::tie(b.at, b.place); });
  return star;
}

std::vector<Index> spokes_between(const Network_star& star, Index from, Index to)
{
  const Index n = static_cast<Index>(star.spokes.size());
  if (to <= from) { to += 2 * n; }
  std::vector<Index> between;
  for (Index i = from / 2 + 1; 2 * i < to; ++i) { between.push_back(star.spokes[i % n]); }
  return between;
}

void drag(Normal_curves& curves, const Network_star& star, Index v, const Network_star::Arm& arm, Index to, Index at,
          bool on_right)
{
  std::vector<Index> way = on_right ? spokes_between(star, arm.at, at) : spokes_between(star, at, arm.at);
  if (on_right) { std::reverse(way.begin(), way.end()); }
  else
  {
    for (Index& h : way) { h = curves.surface().opposite[h]; }
  }
  curves.extend(arm.end, to, way, v);
}

double curve_length(const Normal_curves& curves, Index c)
{
  const Triangle_surface& s = curves.surface();
  double sum = 0;
  Point last = s.points[curves.vertex({c, false})];
  for (Index x : curves.crossings(c))
  {
    const Point p = s.point_on(curves.edge(x), curves[x].t);
    sum += distance(last, p);
    last = p;
  }
  return sum + distance(last, s.points[curves.vertex({c, true})]);
}

namespace {

// The curves that end at some vertices, each once, by number.
std::vector<Index> curves_at(const Normal_curves& curves, std::initializer_list<Index> vertices)
{
  std::vector<Index> all;
  for (Index v : vertices)
    for (const Network_end& e : curves.ends_at(v)) { all.push_back(e.curve); }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

} // namespace

double length_around(const Normal_curves& curves, std::initializer_list<Index> vertices)
{
  double sum = 0;
  for (Index c : curves_at(curves, vertices)) { sum += curve_length(curves, c); }
  return sum;
}

void tighten_around(Normal_curves& curves, std::initializer_list<Index> vertices, const Tighten_options& options)
{
  for (Index c : curves_at(curves, vertices)) { tighten_curve(curves, c, options); }
}

std::vector<Vertex_move> find_vertex_moves(const Normal_curves& curves, const Network_star& star)
{
  const Triangle_surface& s = curves.surface();
  const std::size_t n = star.arms.size();
  std::vector<Vertex_move> moves;
  const auto is_open_to = [&](Index v) { return curves.ends_at(v).empty(); };
  const auto cosine = [&](const Network_star::Arm& arm, double angle) {
    double turn = std::abs(arm.angle - angle);
    if (star.is_closed) { turn = std::min(turn, star.whole - turn); }
    return std::cos(std::min(turn, 3.141592653589793));
  };
  for (std::size_t i = 0; i < star.spokes.size(); ++i)
  {
    const Index h = star.spokes[i], v = s.target(h), at = static_cast<Index>(2 * i);
    if (!is_open_to(v)) { continue; }
    if (s.opposite[h] < 0) // a boundary edge; only the first is a halfedge that leaves
    {
      moves.push_back({-cosine(star.arms.front(), star.angle[i]), v, at});
      continue;
    }
    if (s.is_boundary_vertex(v) || !curves.is_free(s.edge(h))) { continue; }
    const auto after = std::find_if(star.arms.begin(), star.arms.end(), [&](const auto& a) { return a.at > at; });
    if (!star.is_closed && (after == star.arms.begin() || after == star.arms.end())) { continue; }
    double slope = n == 3 && star.is_closed ? 0 : 1;
    if (n == 3 && star.is_closed)
    {
      for (const auto& arm : star.arms) { slope -= cosine(arm, star.angle[i]); }
    }
    else
    {
      const auto& left = after == star.arms.end() ? star.arms.front() : *after;
      const auto& right = after == star.arms.begin() ? star.arms.back() : *std::prev(after);
      slope -= cosine(left, star.angle[i]) + cosine(right, star.angle[i]);
    }
    moves.push_back({slope, v, at});
  }
  if (!star.is_closed)
  {
    const Index h = s.prev(star.spokes.back()), v = s.source(h); // the boundary edge that comes in
    if (is_open_to(v))
    {
      moves.push_back({-cosine(star.arms.back(), star.whole), v, static_cast<Index>(2 * star.spokes.size())});
    }
  }
  moves.erase(std::remove_if(moves.begin(), moves.end(), [](const Vertex_move& m) { return !(m.slope < -1e-3); }),
              moves.end());
  std::stable_sort(moves.begin(), moves.end(),
                   [](const Vertex_move& a, const Vertex_move& b) { return a.slope < b.slope; });
  return moves;
}

void apply(Normal_curves& curves, const Network_star& star, Index v, const Vertex_move& move)
{
  const auto& arms = star.arms;
  if (!star.is_closed && (move.at == 0 || move.at == static_cast<Index>(2 * star.spokes.size())))
  {
    const bool is_first = move.at == 0;
    drag(curves, star, v, is_first ? arms.front() : arms.back(), move.to, move.at, !is_first);
    return;
  }
  const std::size_t n = arms.size();
  const std::size_t after =
    std::find_if(arms.begin(), arms.end(), [&](const auto& a) { return a.at > move.at; }) - arms.begin();
  const auto &left = arms[after % n], &right = arms[(after + n - 1) % n];
  drag(curves, star, v, right, move.to, move.at, true);
  drag(curves, star, v, left, move.to, move.at, false);
  if (n == 3 && star.is_closed) { drag(curves, star, v, arms[(after + 1) % n], move.to, move.at, true); }
  else { curves.add(v, move.to, {}); }
}

std::optional<Index> move_vertex(Normal_curves& curves, Index v, const Tighten_options& options)
{
  constexpr std::size_t tries = 2;
  const Network_star star = make_star(curves, v);
  if (star.is_closed && star.arms.size() < 3) { return {}; }
  const auto moves = find_vertex_moves(curves, star);
  for (std::size_t i = 0; i < std::min(tries, moves.size()); ++i)
  {
    const double before = length_around(curves, {v});
    Normal_curves::Trial trial(curves);
    apply(curves, star, v, moves[i]);
    tighten_around(curves, {v, moves[i].to}, options);
    if (!(length_around(curves, {v, moves[i].to}) < before * (1 - 1e-9))) { continue; }
    trial.keep();
    return moves[i].to;
  }
  return {};
}

void contract(Normal_curves& curves, Index curve, bool to_last)
{
  const Index v = curves.vertex({curve, !to_last}), to = curves.vertex({curve, to_last});
  Network_star star = make_star(curves, v);
  const auto own =
    std::find_if(star.arms.begin(), star.arms.end(), [&](const auto& a) { return a.end.curve == curve; });
  const Index at = own->at;
  std::rotate(star.arms.begin(), own, star.arms.end());
  curves.remove(curve);
  const std::size_t n = star.arms.size(), half = n / 2;
  for (std::size_t i = 1; i <= half; ++i) { drag(curves, star, v, star.arms[i], to, at, false); }
  for (std::size_t i = n - 1; i > half; --i) { drag(curves, star, v, star.arms[i], to, at, true); }
}

bool exchange_neighbors(Normal_curves& curves, Index curve, const Tighten_options& options)
{
  const Triangle_surface& s = curves.surface();
  const Index v = curves.vertex({curve, false}), to = curves.vertex({curve, true});
  if (v == to || s.is_boundary_vertex(v) || s.is_boundary_vertex(to)) { return false; }
  for (bool to_last : {true, false})
  {
    const Index goal = to_last ? to : v;
    const double before = length_around(curves, {v, to});
    Normal_curves::Trial trial(curves);
    contract(curves, curve, to_last);
    tighten_around(curves, {goal}, options);
    const double drawn_together = length_around(curves, {goal});
    if (drawn_together < before * (1 - 1e-9))
    {
      trial.keep();
      return true;
    }
    const Network_star star = make_star(curves, goal);
    const auto moves = find_vertex_moves(curves, star);
    for (std::size_t i = 0; i < std::min<std::size_t>(4, moves.size()); ++i)
    {
      // the slope only gets less along the edge
      const double most = -moves[i].slope * distance(s.points[goal], s.points[moves[i].to]);
      if (!(drawn_together - most < before)) { continue; }
      Normal_curves::Trial inner(curves);
      apply(curves, star, goal, moves[i]);
      tighten_around(curves, {goal, moves[i].to}, options);
      if (!(length_around(curves, {goal, moves[i].to}) < before * (1 - 1e-9))) { continue; }
      inner.keep();
      trial.keep();
      return true;
    }
  }
  return false;
}

} // namespace internal

} // namespace meridian
