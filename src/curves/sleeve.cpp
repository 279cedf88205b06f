// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/sleeve.h>

#include <meridian/curves/place_crossings.h>
#include <meridian/surface/measures.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace meridian {

namespace internal {

void trim(const Triangle_surface& s, Sleeve& sleeve)
{
  auto& h = sleeve.halfedges;
  std::size_t first = 0, last = h.size();
  while (first < last && touches(s, h[first], sleeve.start)) { ++first; }
  while (first < last && touches(s, h[last - 1], sleeve.end)) { --last; }
  h = {h.begin() + first, h.begin() + last};
}

namespace {

// A corner of a triangle, seen from the side across: how long that is, how far along it and how high the corner lies.
struct Corner_over_side
{
  double length, along, height;
};

Corner_over_side corner_over_side(const Triangle_surface& s, Index from, Index to, Index corner)
{
  const Point ab = s.points[to] - s.points[from], ac = s.points[corner] - s.points[from];
  const double l = norm(ab);
  if (!(l > 0)) { return {0, 0, norm(ac)}; }
  return {l, dot(ab, ac) / l, norm(cross(ab, ac)) / l};
}

// Where the corner lies, to the left (`side` is 1) or to the right (-1) of the side from a to b.
Point_2 place(const Corner_over_side& c, const Point_2& a, const Point_2& b, double side)
{
  if (!(c.length > 0)) { return {a[0], a[1] + side * c.height}; }
  const double x = c.along, y = side * c.height;
  const Point_2 u{(b[0] - a[0]) / c.length, (b[1] - a[1]) / c.length};
  return {a[0] + x * u[0] - y * u[1], a[1] + x * u[1] + y * u[0]};
}

// The funnel from the last bend of a path, its apex, to the part of a portal that can be seen from there.
class Funnel
{
public:
  // `turn`: after how many portals the sleeve comes again, or all of them.
  Funnel(const Triangle_surface& s, const Sleeve& sleeve, std::size_t turn)
    : m_surface(s), m_sleeve(sleeve), m_turn(turn)
  {}

  Pulled_path pull()
  {
    unfold();
    find_corners();
    find_fractions();
    return std::move(m_path);
  }

private:
  using Corner = Pulled_path::Corner;
  enum class Bend
  {
    NONE,
    LEFT,
    RIGHT
  };
  // A side of the funnel: the portal whose end it goes to.
  struct Side
  {
    std::size_t portal;
    Point_2 at;
    bool is_apex;
  };

  // Lays the portals out in the plane, one triangle after the other.
  void unfold()
  {
    const Triangle_surface& s = m_surface;
    std::vector<Corner_over_side> corners; // behind each portal of the first turn
    corners.reserve(m_turn);
    for (std::size_t i = 0; i < m_turn; ++i)
    {
      const Index h = m_sleeve.halfedges[i];
      corners.push_back(corner_over_side(s, s.source(h), s.target(h), s.apex(s.opposite[h])));
    }
    const std::size_t n = m_sleeve.halfedges.size();
    for (auto* points : {&m_path.left, &m_path.right}) { points->reserve(n); }
    for (auto* firsts : {&m_first_left, &m_first_right}) { firsts->reserve(n); }
    const Index h0 = m_sleeve.halfedges.front();
    m_path.right.push_back({0, 0});
    m_path.left.push_back({s.length(h0), 0});
    m_start =
      place(corner_over_side(s, s.source(h0), s.target(h0), m_sleeve.start), m_path.right[0], m_path.left[0], 1);
    for (std::size_t i = 0; i < n; ++i)
    {
      const Index o = s.opposite[m_sleeve.halfedges[i]];
      const Point_2 c = place(corners[i % m_turn], m_path.right[i], m_path.left[i], -1);
      if (i + 1 == n)
      {
        m_end = c;
        break;
      }
      const bool moves_left = m_sleeve.halfedges[i + 1] == s.next(o); // the new portal keeps the right end
      m_path.right.push_back(moves_left ? m_path.right[i] : c);
      m_path.left.push_back(moves_left ? c : m_path.left[i]);
      m_first_right.push_back(moves_left ? m_first_right[i] : i + 1);
      m_first_left.push_back(moves_left ? i + 1 : m_first_left[i]);
    }
  }

  Corner left_of(std::size_t i) const
  {
    return {m_surface.target(m_sleeve.halfedges[i]), true, i, m_first_left[i], m_path.left[i]};
  }
  Corner right_of(std::size_t i) const
  {
    return {m_surface.source(m_sleeve.halfedges[i]), false, i, m_first_right[i], m_path.right[i]};
  }

  // Lets the path bend wherever the funnel closes.
  void find_corners()
  {
    const std::size_t n = m_sleeve.halfedges.size();
    restart({m_sleeve.start, true, 0, 0, m_start});
    for (std::size_t i = 0; i <= n; ++i)
    {
      const Bend bend = i == n ? bend_before_end() : narrow(i);
      if (bend == Bend::NONE) { continue; }
      restart(bend == Bend::LEFT ? left_of(m_left.portal) : right_of(m_right.portal));
      i = m_apex.portal; // the loop goes on with the portal after it
    }
    m_path.corners.push_back({m_sleeve.end, true, n, n, m_end});
  }

  void restart(const Corner& bend)
  {
    m_path.corners.push_back(bend);
    m_apex = bend;
    m_left = m_right = {bend.portal, bend.at, true};
  }

  Bend bend_before_end() const
  {
    if (!m_right.is_apex && turn(m_apex.at, m_right.at, m_end) < 0) { return Bend::RIGHT; }
    if (!m_left.is_apex && turn(m_apex.at, m_left.at, m_end) > 0) { return Bend::LEFT; }
    return Bend::NONE;
  }

  // Narrows the funnel to portal `i`. If that lies all on one side of it, says on which the path bends.
  Bend narrow(std::size_t i)
  {
    const Point_2 &r = m_path.right[i], &l = m_path.left[i];
    const bool is_bend = m_path.corners.size() > 1;
    if (m_right.is_apex || turn(m_apex.at, m_right.at, r) >= 0)
    {
      if (!m_right.is_apex && !m_left.is_apex && turn(m_apex.at, m_left.at, r) >= 0) { return Bend::LEFT; }
      m_right = {i, r, is_bend && !m_apex.is_left && m_first_right[i] == m_apex.first};
    }
    if (m_left.is_apex || turn(m_apex.at, m_left.at, l) <= 0)
    {
      if (!m_left.is_apex && !m_right.is_apex && turn(m_apex.at, m_right.at, l) <= 0) { return Bend::RIGHT; }
      m_left = {i, l, is_bend && m_apex.is_left && m_first_left[i] == m_apex.first};
    }
    return Bend::NONE;
  }

  // Finds where the path crosses the portals between its corners, in the middle turn.
  void find_fractions()
  {
    const auto& corners = m_path.corners;
    const std::size_t first = m_sleeve.halfedges.size() / m_turn / 2 * m_turn;
    std::size_t k = 1;
    for (std::size_t i = first; i < first + m_turn; ++i)
    {
      while (k + 1 < corners.size() && corners[k].portal < i) { ++k; }
      const Corner &a = corners[k - 1], &b = corners[k];
      const bool at_a = k > 1 && ends_at(i, a), at_b = k + 1 < corners.size() && ends_at(i, b);
      double t = 1;
      if ((at_a && !a.is_left) || (at_b && !b.is_left)) { t = 0; }
      else if (!at_a && !at_b)
      {
        const double p = turn(a.at, b.at, m_path.right[i]), q = turn(a.at, b.at, m_path.left[i]);
        t = q - p > 0 ? std::min(std::max(0., -p / (q - p)), 1.) : 0.5; // 0 if they are infinite
      }
      m_path.fraction.push_back(t);
    }
  }

  // Whether a bend is an end of portal `i`.
  bool ends_at(std::size_t i, const Corner& bend) const
  {
    return bend.first == (bend.is_left ? m_first_left : m_first_right)[i];
  }

  const Triangle_surface& m_surface;
  const Sleeve& m_sleeve;
  const std::size_t m_turn;
  Pulled_path m_path;
  Point_2 m_start{0, 0}, m_end{0, 0};
  // Of each portal: the first with the same end. A closed sleeve comes to a vertex again; that is another end.
  std::vector<std::size_t> m_first_left{0}, m_first_right{0};
  Corner m_apex{};
  Side m_left{}, m_right{};
};

} // namespace

Pulled_path pull(const Triangle_surface& s, const Sleeve& sleeve)
{
  return Funnel(s, sleeve, sleeve.halfedges.size()).pull();
}

namespace {

// Whether a path through three turns bends at one corner in all of them. Then what lies between is the tight loop.
bool comes_again(const Pulled_path& path, std::size_t turn)
{
  const auto bends_at = [&](const Pulled_path::Corner& corner, std::size_t first) {
    return std::any_of(path.corners.begin() + 1, path.corners.end() - 1,
                       [&](const Pulled_path::Corner& c) { return c.first == first && c.is_left == corner.is_left; });
  };
  for (std::size_t k = 1; k + 1 < path.corners.size() && path.corners[k].portal < turn; ++k)
  {
    const Pulled_path::Corner& corner = path.corners[k];
    if (bends_at(corner, corner.first + turn) && bends_at(corner, corner.first + 2 * turn)) { return true; }
  }
  return false;
}

} // namespace

Pulled_path pull_closed(const Triangle_surface& s, const std::vector<Index>& halfedges, std::size_t& turns)
{
  constexpr std::size_t few = 3, most = 5;
  Sleeve sleeve{s.apex(halfedges.front()), s.apex(s.opposite[halfedges.back()]), {}};
  const auto pull_through = [&](std::size_t wanted) {
    for (turns = wanted; sleeve.halfedges.size() < turns * halfedges.size();)
    {
      sleeve.halfedges.insert(sleeve.halfedges.end(), halfedges.begin(), halfedges.end());
    }
    return Funnel(s, sleeve, halfedges.size()).pull();
  };
  const Pulled_path path = pull_through(few);
  return comes_again(path, halfedges.size()) ? path : pull_through(most);
}

double angle(const Point_2& at, const Point_2& p, const Point_2& q)
{
  const double x1 = p[0] - at[0], y1 = p[1] - at[1], x2 = q[0] - at[0], y2 = q[1] - at[1];
  return std::abs(std::atan2(x1 * y2 - y1 * x2, x1 * x2 + y1 * y2));
}

namespace {

// Moves a sleeve over the corners of its path, each once in a pass.
class Sleeve_straightener
{
public:
  Sleeve_straightener(const Triangle_surface& s, Sleeve& sleeve, const May_cross& may_cross, const Is_free& is_free)
    : m_surface(s), m_sleeve(sleeve), m_may_cross(may_cross), m_is_free(is_free), m_path(pull(s, sleeve))
  {}

  Pulled_path straighten()
  {
    constexpr int passes = 100;
    for (int pass = 0; pass < passes && !m_sleeve.halfedges.empty(); ++pass)
    {
      if (!move_over_corners()) { break; }
      trim(m_surface, m_sleeve);
      if (!m_sleeve.halfedges.empty()) { m_path = pull(m_surface, m_sleeve); }
    }
    return std::move(m_path);
  }

private:
  // The portals that end at a corner: from `begin` to before `end`.
  struct Stretch
  {
    std::size_t begin, end;
  };

  // From the end of the path to its start, so that portals before a corner keep their numbers. Returns whether the
  // sleeve changed.
  bool move_over_corners()
  {
    m_faces.clear();
    for (Index h : m_sleeve.halfedges) { m_faces.insert(m_surface.face(h)); }
    m_faces.insert(m_surface.face(m_surface.opposite[m_sleeve.halfedges.back()]));
    std::size_t last_begin = m_sleeve.halfedges.size();
    bool changed = false;
    for (std::size_t k = m_path.corners.size() - 1; k-- > 1;)
    {
      const auto& corner = m_path.corners[k];
      if (!m_is_free(corner.vertex) || corner.portal >= m_sleeve.halfedges.size()) { continue; }
      const Stretch stretch = portals_at(corner);
      if (stretch.end >= last_begin || !is_shorter_beyond(k, stretch) || !replace(stretch, corner.is_left))
      {
        continue;
      }
      last_begin = stretch.begin;
      changed = true;
    }
    return changed;
  }

  Stretch portals_at(const Pulled_path::Corner& corner) const
  {
    const auto& all = m_sleeve.halfedges;
    std::size_t begin = corner.portal, end = corner.portal + 1;
    while (begin > 0 && touches(m_surface, all[begin - 1], corner.vertex)) { --begin; }
    while (end < all.size() && touches(m_surface, all[end], corner.vertex)) { ++end; }
    return {begin, end};
  }

  // Whether the angle on the other side of a corner is less than a straight one.
  bool is_shorter_beyond(std::size_t k, const Stretch& stretch) const
  {
    constexpr double straight = 3.141592653589793 - 1e-6;
    const auto& corner = m_path.corners[k];
    double around = 0;
    m_surface.for_each_outgoing(corner.vertex, [&](Index h) { around += corner_angle(m_surface, h); });
    const auto rim = [&](std::size_t i) { return corner.is_left ? m_path.right[i] : m_path.left[i]; };
    double inside = angle(corner.at, m_path.corners[k - 1].at, rim(stretch.begin))
                    + angle(corner.at, m_path.corners[k + 1].at, rim(stretch.end - 1));
    for (std::size_t i = stretch.begin; i + 1 < stretch.end; ++i) { inside += angle(corner.at, rim(i), rim(i + 1)); }
    return !(around - inside >= straight);
  }

  // Takes the way round the other side, if that is free.
  bool replace(const Stretch& stretch, bool is_left)
  {
    const Triangle_surface& s = m_surface;
    auto& all = m_sleeve.halfedges;
    const Index goal = s.face(s.opposite[all[stretch.end - 1]]), h0 = all[stretch.begin];
    std::vector<Index> detour;
    for (Index g = is_left ? s.next(h0) : s.prev(h0);; g = is_left ? s.next(s.opposite[g]) : s.prev(s.opposite[g]))
    {
      if (!m_may_cross(g)) { return false; }
      detour.push_back(g);
      const Index f = s.face(s.opposite[g]);
      if (f == goal) { break; }
      if (m_faces.count(f) > 0) { return false; }
    }
    for (Index h : detour) { m_faces.insert(s.face(s.opposite[h])); }
    all.erase(all.begin() + stretch.begin, all.begin() + stretch.end);
    all.insert(all.begin() + stretch.begin, detour.begin(), detour.end());
    return true;
  }

  const Triangle_surface& m_surface;
  Sleeve& m_sleeve;
  const May_cross& m_may_cross;
  const Is_free& m_is_free;
  Pulled_path m_path;
  std::set<Index> m_faces; // that the sleeve has, or had in this pass
};

// The crossings of a path. Beside a vertex that cannot be passed, room is left for the next link.
std::vector<Piece_crossing> crossings_of(const Triangle_surface& s, const Sleeve& sleeve, const Pulled_path& path,
                                         const Is_free& is_free)
{
  constexpr double beside = 0.2;
  std::vector<Piece_crossing> crossings;
  for (std::size_t i = 0; i < sleeve.halfedges.size(); ++i)
  {
    const Index h = sleeve.halfedges[i];
    double t = path.fraction[i];
    if (!is_free(s.source(h))) { t = std::max(t, beside); }
    if (!is_free(s.target(h))) { t = std::min(t, std::max(1 - beside, 0.5)); }
    crossings.push_back({{h, 0, turn_fraction(s, h, t)}, s.edge(h)});
  }
  return crossings;
}

} // namespace

Pulled_path straighten(const Triangle_surface& s, Sleeve& sleeve, const May_cross& may_cross, const Is_free& is_free)
{
  return Sleeve_straightener(s, sleeve, may_cross, is_free).straighten();
}

Surface_curve shortest_curve(const Triangle_surface& s, Sleeve& sleeve, const May_cross& may_cross,
                             const Is_free& is_free)
{
  Surface_curve curve;
  curve.points.push_back(Curve_point::on_vertex(sleeve.start));
  if (!sleeve.halfedges.empty())
  {
    const Pulled_path path = straighten(s, sleeve, may_cross, is_free);
    const std::vector<Piece_crossing> crossings = crossings_of(s, sleeve, path, is_free);
    if (!crossings.empty())
    {
      const Surface_curve inside = place_crossings(s, {crossings}, false, is_free).front();
      curve.points.insert(curve.points.end(), inside.points.begin(), inside.points.end());
    }
  }
  curve.points.push_back(Curve_point::on_vertex(sleeve.end));
  return curve;
}

} // namespace internal

} // namespace meridian
