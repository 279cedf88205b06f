// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_TIGHTEN_CURVES_H
#define MERIDIAN_TIGHTEN_CURVES_H

#include <meridian/Normal_curves.h>
#include <meridian/internal/sleeve.h>

#include <functional>

namespace meridian {

/// \ingroup PkgMeridianGenerators
/// what `tighten_curves()` may do.
struct Tighten_options
{
  double least_gain = 1e-4;             ///< a round or pass that shortens by less than this part of the length is the last
  int rounds = 20, passes = 200;        ///< at most: through all curves; moves of one curve in one round
  std::function<void(double)> progress; ///< told how much is done, from 0 to 1; may throw to end the run
};

namespace internal {

// A closed curve pulled tight in the strip of faces it runs through.
struct Taut_loop
{
  struct Bend { Index vertex; bool is_left; std::size_t begin, size; }; // at the vertex that `size` crossings from `begin` on share
  std::vector<double> fraction; // where it crosses each halfedge
  std::vector<Bend> bends;      // that are shorter on the other side of their vertex
  double length = 0;
};

inline double length_of(const Triangle_surface& s, const std::vector<Index>& halfedges, const std::vector<double>& fraction)
{
  double sum = 0;
  const std::size_t n = halfedges.size();
  Point last = s.point_on(halfedges[n - 1], fraction[n - 1]);
  for (std::size_t i = 0; i < n; ++i)
  {
    const Point p = s.point_on(halfedges[i], fraction[i]);
    sum += distance(last, p);
    last = p;
  }
  return sum;
}

// The strip is unrolled several times over and pulled between its far ends; the middle turn is what is wanted.
inline Taut_loop pull_loop(const Triangle_surface& s, const std::vector<Index>& halfedges)
{
  constexpr std::size_t turns = 5, middle = 2;
  constexpr double straight = 3.141592653589793 - 1e-6;
  const std::size_t n = halfedges.size();
  Sleeve sleeve;
  sleeve.start = s.apex(halfedges.front());
  sleeve.end = s.apex(s.opposite[halfedges.back()]);
  for (std::size_t i = 0; i < turns; ++i) { sleeve.halfedges.insert(sleeve.halfedges.end(), halfedges.begin(), halfedges.end()); }
  const Pulled_path path = pull(s, sleeve);
  Taut_loop loop;
  loop.fraction.assign(path.fraction.begin() + middle * n, path.fraction.begin() + (middle + 1) * n);
  loop.length = length_of(s, halfedges, loop.fraction);
  for (std::size_t k = 1; k + 1 < path.corners.size(); ++k)
  {
    const auto& corner = path.corners[k];
    if (corner.portal < middle * n || corner.portal >= (middle + 1) * n || s.is_boundary_vertex(corner.vertex)) { continue; }
    std::size_t begin = corner.portal, end = corner.portal + 1;
    while (begin > 0 && end - begin < n && touches(s, sleeve.halfedges[begin - 1], corner.vertex)) { --begin; }
    while (end < sleeve.halfedges.size() && end - begin < n && touches(s, sleeve.halfedges[end], corner.vertex)) { ++end; }
    if (end - begin >= n || begin == 0 || end == sleeve.halfedges.size()) { continue; }
    const auto rim = [&](std::size_t i) { return corner.is_left ? path.right[i] : path.left[i]; };
    double around = 0, inside = angle(corner.at, path.corners[k - 1].at, rim(begin)) + angle(corner.at, path.corners[k + 1].at, rim(end - 1));
    for (std::size_t i = begin; i + 1 < end; ++i) { inside += angle(corner.at, rim(i), rim(i + 1)); }
    s.for_each_outgoing(corner.vertex, [&](Index h) { around += corner_angle(s, h); });
    if (around - inside < straight) { loop.bends.push_back({corner.vertex, corner.is_left, begin % n, end - begin}); }
  }
  return loop;
}

// Moves a curve over a vertex that a run of its crossings goes round. It may not be in the way of any curve but its
// partner, with whom it must go on to cross as often.
inline bool move_over(Normal_curves& curves, const std::vector<Index>& run, Index vertex, bool is_left)
{
  const Triangle_surface& s = curves.surface();
  const Index c = curves[run.front()].curve, p = Normal_curves::partner(c);
  bool passes_partner = false;
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
  const Index goal = curves.face_after(run.back()), h0 = curves[run.front()].halfedge;
  if (s.face(h0) == goal) { return false; }
  std::vector<Index> detour;
  for (Index g = is_left ? s.next(h0) : s.prev(h0);; g = is_left ? s.next(s.opposite[g]) : s.prev(s.opposite[g]))
  {
    if (s.opposite[g] < 0) { return false; }
    detour.push_back(g);
    if (s.face(s.opposite[g]) == goal) { break; }
  }
  // Away from where the partners cross, nothing changes between them.
  bool is_at_meeting = false;
  std::vector<Index> star;
  s.for_each_outgoing(vertex, [&](Index h) {
    star.push_back(s.face(h));
    is_at_meeting = is_at_meeting || s.face(h) == curves.meeting(c);
  });
  if (!is_at_meeting)
  {
    if (passes_partner) { return false; }
    curves.reroute(run.front(), run.back(), detour, !is_left);
    return true;
  }
  const auto undo = curves.reroute(run.front(), run.back(), detour, !is_left);
  Index count = 0, meeting = -1;
  for (Index f : star)
  {
    const Index here = curves.count_in_face(c, f);
    count += here;
    if (here > 0) { meeting = f; }
  }
  if (count == 1)
  {
    curves.set_meeting(c, meeting);
    return true;
  }
  undo();
  return false;
}

// Shortens one curve. Returns its length.
inline double tighten_curve(Normal_curves& curves, Index c, const Tighten_options& options)
{
  const Triangle_surface& s = curves.surface();
  double last = std::numeric_limits<double>::infinity();
  for (int pass = 0;; ++pass)
  {
    const std::vector<Index> crossings = curves.crossings(c);
    std::vector<Index> halfedges;
    for (Index x : crossings) { halfedges.push_back(curves[x].halfedge); }
    const Taut_loop loop = pull_loop(s, halfedges);
    const std::size_t n = crossings.size();
    for (std::size_t i = 0; i < n; ++i)
      curves.move(crossings[i], s.edge(halfedges[i]) == halfedges[i] ? loop.fraction[i] : 1 - loop.fraction[i]);
    const bool is_last = pass == options.passes || loop.length > (1 - options.least_gain) * last;
    last = std::min(last, loop.length);
    if (is_last) { return loop.length; }
    std::vector<char> is_gone(n, 0);
    bool moved = false;
    for (const auto& bend : loop.bends)
    {
      std::vector<Index> run;
      bool is_whole = !is_gone[(bend.begin + n - 1) % n] && !is_gone[(bend.begin + bend.size) % n];
      for (std::size_t i = 0; i < bend.size; ++i)
      {
        run.push_back(crossings[(bend.begin + i) % n]);
        is_whole = is_whole && !is_gone[(bend.begin + i) % n];
      }
      if (!is_whole || !move_over(curves, run, bend.vertex, bend.is_left)) { continue; }
      moved = true;
      for (std::size_t i = 0; i < bend.size; ++i) { is_gone[(bend.begin + i) % n] = 1; }
    }
    if (!moved) { return loop.length; }
  }
}

} // namespace internal

/*!
 * \ingroup PkgMeridianGenerators
 *
 * shortens curves within their homotopy classes.
 *
 * Each curve in turn is pulled tight in the strip of faces that it runs through (Lee, Preparata 1984) and moved over vertices
 * where it bends and the other side is shorter (Xin, Wang 2007), until no pass over all curves gains more than the least gain.
 * A curve is never moved over another, and two partners go on to cross as often as before: that is read from the orders on
 * edges alone. So disjoint curves stay disjoint, and simple ones simple.
 *
 * \param curves the curves; their crossings are replaced and placed
 * \param options see there
 * \returns the sum of their lengths
 * \par Complexity
 * Linear in the crossings of a curve for each of its passes
 */
inline double tighten_curves(Normal_curves& curves, const Tighten_options& options = Tighten_options())
{
  double last = std::numeric_limits<double>::infinity();
  for (int round = 0;; ++round)
  {
    double sum = 0;
    for (Index c = 0; c < curves.number_of_curves(); ++c)
    {
      if (curves.is_present(c)) { sum += internal::tighten_curve(curves, c, options); }
      if (options.progress) { options.progress((round + (c + 1.) / curves.number_of_curves()) / (options.rounds + 1)); }
    }
    if (round == options.rounds || sum > (1 - options.least_gain) * last) { return sum; }
    last = std::min(last, sum);
  }
}

} // namespace meridian

#endif // MERIDIAN_TIGHTEN_CURVES_H
