// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/tighten_curves.h>

#include <meridian/curves/chords.h>
#include <meridian/curves/sleeve.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/measures.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace meridian {

namespace internal {

namespace {

// A curve pulled tight in the strip of faces it runs through.
struct Taut_curve
{
  // at the vertex that `size` crossings from `begin` on share
  struct Bend
  {
    Index vertex;
    bool is_left;
    std::size_t begin, size;
  };
  std::vector<double> fraction; // where it crosses each halfedge
  std::vector<Bend> bends;      // that are shorter on the other side of their vertex
  double length = 0;
};

// Appends the bends of a pulled path at vertices inside the surface. Of a closed curve the strip is several turns long:
// bends are taken from the middle one.
void find_bends(const Triangle_surface& s, const std::vector<Index>& halfedges, const Pulled_path& path,
                std::size_t turns, Taut_curve& curve)
{
  const std::size_t period = halfedges.size(), from = turns / 2 * period, size = turns * period;
  const auto halfedge = [&](std::size_t i) { return halfedges[i % period]; };
  constexpr double straight = 3.141592653589793 - 1e-6;
  for (std::size_t k = 1; k + 1 < path.corners.size(); ++k)
  {
    const auto& corner = path.corners[k];
    if (corner.portal < from || corner.portal >= from + period || s.is_boundary_vertex(corner.vertex)) { continue; }
    std::size_t begin = corner.portal, end = corner.portal + 1;
    while (begin > 0 && end - begin < period && touches(s, halfedge(begin - 1), corner.vertex)) { --begin; }
    while (end < size && end - begin < period && touches(s, halfedge(end), corner.vertex)) { ++end; }
    if (turns > 1 && (end - begin >= period || begin == 0 || end == size)) { continue; }
    const auto rim = [&](std::size_t i) { return corner.is_left ? path.right[i] : path.left[i]; };
    double around = 0, inside = angle(corner.at, path.corners[k - 1].at, rim(begin))
                                + angle(corner.at, path.corners[k + 1].at, rim(end - 1));
    for (std::size_t i = begin; i + 1 < end; ++i) { inside += angle(corner.at, rim(i), rim(i + 1)); }
    s.for_each_outgoing(corner.vertex, [&](Index h) { around += corner_angle(s, h); });
    if (around - inside < straight)
    {
      curve.bends.push_back({corner.vertex, corner.is_left, begin % period, end - begin});
    }
  }
}

Taut_curve pull_loop(const Triangle_surface& s, const std::vector<Index>& halfedges)
{
  std::size_t turns = 0;
  const Pulled_path path = pull_closed(s, halfedges, turns);
  Taut_curve loop;
  loop.fraction = path.fraction;
  Point last = s.point_on(halfedges.back(), loop.fraction.back());
  for (std::size_t i = 0; i < halfedges.size(); ++i)
  {
    const Point p = s.point_on(halfedges[i], loop.fraction[i]);
    loop.length += distance(last, p);
    last = p;
  }
  find_bends(s, halfedges, path, turns, loop);
  return loop;
}

// An open curve, which crosses at least one edge, between its ends.
Taut_curve pull_open(const Triangle_surface& s, const Sleeve& sleeve)
{
  const Pulled_path path = pull(s, sleeve);
  Taut_curve curve;
  curve.fraction = path.fraction;
  Point last = s.points[sleeve.start];
  for (std::size_t i = 0; i < sleeve.halfedges.size(); ++i)
  {
    const Point p = s.point_on(sleeve.halfedges[i], curve.fraction[i]);
    curve.length += distance(last, p);
    last = p;
  }
  curve.length += distance(last, s.points[sleeve.end]);
  find_bends(s, sleeve.halfedges, path, 1, curve);
  return curve;
}

// Whether nothing but the partner lies between a run of crossings and the vertex it goes round; and whether the partner
// does.
bool is_way_free(const Normal_curves& curves, const std::vector<Index>& run, bool is_left, bool& passes_partner)
{
  const Triangle_surface& s = curves.surface();
  const Index p = Normal_curves::partner(curves[run.front()].curve);
  for (Index x : run)
  {
    const Index h = curves[x].halfedge;
    const auto& list = curves.on(s.edge(h));
    const Index k = curves[x].place;
    const bool upwards = is_left == (s.edge(h) == h); // towards the vertex
    for (Index i = upwards ? k + 1 : k - 1; i >= 0 && i < static_cast<Index>(list.size()); i += upwards ? 1 : -1)
    {
      if (curves[list[i]].curve != p) { return false; }
      passes_partner = true;
    }
  }
  return true;
}

// Leaves out what only leads round an end of the curve, where the run is next to it.
void trim_detour(const Normal_curves& curves, const std::vector<Index>& run, std::vector<Index>& detour)
{
  const Index c = curves[run.front()].curve;
  if (!curves.is_open(c)) { return; }
  const auto touches_end = [&](Index h, bool is_last) {
    return touches(curves.surface(), h, curves.vertex({c, is_last}));
  };
  if (curves[run.front()].prev < 0)
  {
    detour.erase(detour.begin(),
                 std::find_if(detour.begin(), detour.end(), [&](Index h) { return !touches_end(h, false); }));
  }
  if (curves[run.back()].next < 0)
  {
    while (!detour.empty() && touches_end(detour.back(), true)) { detour.pop_back(); }
  }
}

// The way round the other side of the vertex that a run of crossings goes round. Returns false if there is none.
bool find_detour(const Normal_curves& curves, const std::vector<Index>& run, bool is_left, std::vector<Index>& detour)
{
  const Triangle_surface& s = curves.surface();
  const Index goal = face_after(curves, run.back()), h0 = curves[run.front()].halfedge;
  if (s.face(h0) == goal) { return false; }
  for (Index g = is_left ? s.next(h0) : s.prev(h0);; g = is_left ? s.next(s.opposite[g]) : s.prev(s.opposite[g]))
  {
    if (s.opposite[g] < 0) { return false; }
    detour.push_back(g);
    if (s.face(s.opposite[g]) == goal) { break; }
  }
  trim_detour(curves, run, detour);
  return true;
}

// Reroutes a curve around the vertex where it crosses its partner, if it goes on to cross it once.
bool reroute_at_meeting(Normal_curves& curves, const std::vector<Index>& run, const std::vector<Index>& detour,
                        bool is_left, const std::vector<Index>& star)
{
  const Index c = curves[run.front()].curve;
  Normal_curves::Trial trial(curves);
  curves.reroute(run.front(), run.back(), detour, !is_left);
  Index count = 0, meeting = -1;
  for (Index f : star)
  {
    const Index here = count_in_face(curves, c, f);
    count += here;
    if (here > 0) { meeting = f; }
  }
  if (count != 1) { return false; }
  curves.set_meeting(c, meeting);
  trial.keep();
  return true;
}

// Moves a curve over a vertex that a run of its crossings goes round. No other curve may be in the way or end there but
// its partner, with whom it must go on to cross as often.
bool move_over(Normal_curves& curves, const std::vector<Index>& run, Index vertex, bool is_left)
{
  const Triangle_surface& s = curves.surface();
  const Index c = curves[run.front()].curve;
  bool passes_partner = false;
  std::vector<Index> detour;
  if (!curves.ends_at(vertex).empty() || !is_way_free(curves, run, is_left, passes_partner)
      || !find_detour(curves, run, is_left, detour))
  {
    return false;
  }
  bool is_at_meeting = false;
  std::vector<Index> star;
  s.for_each_outgoing(vertex, [&](Index h) {
    star.push_back(s.face(h));
    is_at_meeting = is_at_meeting || s.face(h) == curves.meeting(c);
  });
  if (is_at_meeting) { return reroute_at_meeting(curves, run, detour, is_left, star); }
  if (passes_partner) { return false; } // away from where the partners cross, nothing changes between them
  curves.reroute(run.front(), run.back(), detour, !is_left);
  for (bool is_last : {false, true})
  {
    if (curves.is_open(c) && curves.nearest({c, is_last}) >= 0) { curves.trim({c, is_last}); }
  }
  return true;
}

} // namespace

double tighten_curve(Normal_curves& curves, Index c, const Tighten_options& options)
{
  if (const auto known = curves.tight_length(c)) { return *known; }
  const Triangle_surface& s = curves.surface();
  double last = std::numeric_limits<double>::infinity();
  for (int pass = 0;; ++pass)
  {
    const std::vector<Index> crossings = curves.crossings(c);
    const bool open = curves.is_open(c);
    if (crossings.empty()) { return s.length(curves.edge_along(c)); }
    std::vector<Index> halfedges;
    for (Index x : crossings) { halfedges.push_back(curves[x].halfedge); }
    const Taut_curve loop =
      open ? pull_open(s, {curves.vertex({c, false}), curves.vertex({c, true}), halfedges}) : pull_loop(s, halfedges);
    const std::size_t n = crossings.size();
    for (std::size_t i = 0; i < n; ++i)
      curves.move(crossings[i], s.edge(halfedges[i]) == halfedges[i] ? loop.fraction[i] : 1 - loop.fraction[i]);
    const bool is_last = pass == options.passes || !(loop.length < (1 - options.least_gain) * last);
    last = std::min(last, loop.length);
    if (is_last) { return loop.length; }
    std::vector<char> is_gone(n, 0);
    bool moved = false;
    for (const auto& bend : loop.bends)
    {
      std::vector<Index> run;
      bool is_whole = (open && bend.begin == 0) || !is_gone[(bend.begin + n - 1) % n];
      is_whole = is_whole && ((open && bend.begin + bend.size == n) || !is_gone[(bend.begin + bend.size) % n]);
      for (std::size_t i = 0; i < bend.size; ++i)
      {
        run.push_back(crossings[(bend.begin + i) % n]);
        is_whole = is_whole && !is_gone[(bend.begin + i) % n];
      }
      if (!is_whole || !move_over(curves, run, bend.vertex, bend.is_left)) { continue; }
      moved = true;
      if (open && (bend.begin == 0 || bend.begin + bend.size == n)) { break; } // more crossings than these may be gone
      for (std::size_t i = 0; i < bend.size; ++i) { is_gone[(bend.begin + i) % n] = 1; }
    }
    if (!moved)
    {
      curves.set_tight(c, loop.length);
      return loop.length;
    }
  }
}

} // namespace internal

double tighten_curves(Normal_curves& curves, const Tighten_options& options, const Progress& progress)
{
  double last = std::numeric_limits<double>::infinity();
  for (int round = 0;; ++round)
  {
    double sum = 0;
    for (Index c = 0; c < curves.number_of_curves(); ++c)
    {
      if (curves.is_present(c)) { sum += internal::tighten_curve(curves, c, options); }
      if (progress) { progress((round + (c + 1.) / curves.number_of_curves()) / (options.rounds + 1)); }
    }
    if (round == options.rounds || !(sum < (1 - options.least_gain) * last)) { return sum; }
    last = std::min(last, sum);
  }
}

} // namespace meridian
