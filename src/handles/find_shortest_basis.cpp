// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/handles/find_shortest_basis.h>

#include <meridian/base/Stage_runner.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/curves/contours.h>
#include <meridian/curves/passings.h>
#include <meridian/curves/place_crossings.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/field/order_surface.h>
#include <meridian/handles/find_generators.h>
#include <meridian/handles/internal/dual_loops.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/check_surface.h>
#include <meridian/surface/insert_curves.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/root_edges.h>
#include <meridian/surface/shortest_ways.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

namespace {

// A closed curve of the root, through each face once, on a refined surface: through the same faces of the root, from
// edge to edge. Between two edges it takes the shortest way through the parts of a face, and so through each part once.
class Loop_transfer
{
public:
  Loop_transfer(const Triangle_surface& root, const Refined_surface& s)
    : m_root(root), m_surface(s), m_parts(root.number_of_faces())
  {
    for (Index f = 0; f < s.number_of_faces(); ++f) { m_parts[s.face_of[f]].push_back(f); }
  }

  std::vector<Edge_place> transfer(const std::vector<Edge_place>& loop) const
  {
    const std::size_t n = loop.size();
    std::vector<Edge_place> gates; // the halfedge of the refined surface by which each face of the root is left
    for (const Edge_place& c : loop) { gates.push_back(find_part(c)); }
    std::vector<Edge_place> crossings;
    for (std::size_t i = 0; i < n; ++i)
    {
      crossings.push_back(gates[i]);
      cross(m_surface.opposite[gates[i].halfedge], gates[(i + 1) % n].halfedge, crossings);
    }
    cancel(m_surface, crossings);
    return crossings;
  }

private:
  // The part of a halfedge of the root that holds a fraction of it.
  Edge_place find_part(const Edge_place& c) const
  {
    const Index v = m_root.source(c.halfedge), w = m_root.target(c.halfedge);
    Edge_place best{-1, 0.5};
    for (Index f : m_parts[m_root.face(c.halfedge)])
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        Root_stretch on;
        if (m_surface.opposite[h] < 0 || !find_stretch(m_root, m_surface, h, on) || on.halfedge != c.halfedge)
        {
          continue;
        }
        if (on.lower != std::min(v, w)) { continue; }
        const bool from_lower = v < w;
        // along c.halfedge
        const double from = from_lower ? on.at[0] : 1 - on.at[0], to = from_lower ? on.at[1] : 1 - on.at[1];
        if (best.halfedge < 0 || (from <= c.t && c.t <= to))
        {
          best = {h, std::min(std::max((c.t - from) / (to - from), 0.05), 0.95)};
        }
      }
    if (best.halfedge < 0) { throw Internal_error("transfer: an edge of the root has no part"); }
    return best;
  }
  // Adds the crossings between the face of `entry` and that of `exit`, parts of one face of the root.
  void cross(Index entry, Index exit, std::vector<Edge_place>& crossings) const
  {
    const Index first = m_surface.face(entry), last = m_surface.face(exit), whole = m_surface.face_of[first];
    // face: distance, and the halfedge by which the one before was left
    std::map<Index, std::pair<double, Index>> reached{{first, {0, -1}}};
    Nearest_first<Index> queue;
    queue.reach(0, first);
    const auto from = [&](Index f) { return m_surface.point_on(f == first ? entry : reached.at(f).second, 0.5); };
    queue.search([&](double d, Index f) {
      if (f == last) { return true; }
      if (d > reached.at(f).first) { return false; }
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        const Index o = m_surface.opposite[h];
        if (o < 0 || m_surface.face_of[m_surface.face(o)] != whole) { continue; }
        const double at = d + distance(from(f), m_surface.point_on(h, 0.5));
        const auto [old, is_new] = reached.try_emplace(m_surface.face(o), at, h);
        if (!is_new && !(at < old->second.first)) { continue; }
        old->second = {at, h};
        queue.reach(at, m_surface.face(o));
      }
      return false;
    });
    if (!reached.count(last)) { throw Internal_error("transfer: a face of the root is not connected"); }
    std::vector<Edge_place> way;
    for (Index f = last; f != first; f = m_surface.face(way.back().halfedge))
    {
      way.push_back({reached.at(f).second, 0.5});
    }
    crossings.insert(crossings.end(), way.rbegin(), way.rend());
  }

  const Triangle_surface& m_root;
  const Refined_surface& m_surface;
  std::vector<std::vector<Index>> m_parts; // of each face of the root
};

// A closed curve on its own, which crosses no edge twice.
Normal_curves curve_of(const Triangle_surface& s, const std::vector<Edge_place>& loop)
{
  Normal_curves curves(s, 1);
  std::vector<Crossing> steps;
  for (const Edge_place& c : loop) { steps.push_back({c.halfedge, 0, turn_fraction(s, c.halfedge, c.t)}); }
  curves.add(0, steps);
  return curves;
}

// Whether a closed curve runs through a face more than once: its crossings alone do not say in which order, then.
bool returns_to_a_face(const Triangle_surface& s, const std::vector<Edge_place>& loop)
{
  std::set<Index> faces;
  return !std::all_of(loop.begin(), loop.end(),
                      [&](const Edge_place& c) { return faces.insert(s.face(c.halfedge)).second; });
}

// Places the one curve that is there; it passes through no vertex that another one uses.
Surface_curve place_loop(const Refined_surface& s, const Normal_curves& curves)
{
  std::vector<Piece_crossing> crossings;
  for (Index x : curves.crossings(0)) { crossings.push_back({curves[x], curves.edge(x)}); }
  return place_crossings(s, {crossings}, true,
                         [&](Index v) {
                           bool is_free = !s.is_boundary_vertex(v);
                           s.for_each_outgoing(v, [&](Index h) { is_free = is_free && !s.seam[h]; });
                           return is_free;
                         })
    .front();
}

// Candidates for a basis. Meridians and longitudes are among them.
std::vector<Dual_loop> find_candidates(const Triangle_surface& root, int genus, const Basis_options& options,
                                       const Stage_runner& run)
{
  Generator_options pair_options;
  pair_options.flow = false;
  pair_options.solvers = options.solvers;
  pair_options.tighten = options.tighten;
  const Ordered_surface m = order_surface(root, {pair_options, false, pair_options.solvers}, run_unwatched);
  Generators pairs;
  pairs.genus = genus;
  Stage_times ignored;
  std::vector<std::vector<Edge_place>> crossings;
  find_generators(root, m, pair_options, Stage_runner{nullptr, ignored}, pairs, &crossings);
  return find_dual_loops(
    root, options.bases > 0 ? options.bases : std::min(std::max(5000000 / root.number_of_faces(), 16), 96),
    2 * static_cast<std::size_t>(genus), crossings, [&](double done) { run.progress(Stage::LONGITUDES, done); });
}

// Shortens all candidates if that is wanted, and chooses among them.
std::vector<Dual_loop> tighten_and_choose(const Triangle_surface& root, std::vector<Dual_loop> loops,
                                          std::size_t wanted, const Basis_options& options, const Stage_runner& run)
{
  for (std::size_t i = 0; i < loops.size() && options.tighten; ++i)
  {
    Normal_curves curves = curve_of(root, loops[i].crossings);
    loops[i].length = tighten_curve(curves, 0, options.tightening);
    std::vector<Edge_place> tightened = places_of(curves, 0);
    if (!returns_to_a_face(root, tightened)) { loops[i].crossings = std::move(tightened); }
    run.progress(Stage::TIGHTEN, (i + 1.) / loops.size());
  }
  return choose_basis(std::move(loops), wanted);
}

// The new vertices on edges, by the edges' ends: the fraction of the way from the first of them, and the vertex.
using Divided_edges = std::map<std::pair<Index, Index>, std::vector<std::pair<double, Index>>>;

// Inserts a curve. Returns its vertices, and where it divides edges that were there.
std::pair<std::vector<Index>, Divided_edges> insert_loop(const Triangle_surface& root, Refined_surface& s,
                                                         const Surface_curve& placed)
{
  std::vector<std::pair<std::pair<Index, Index>, double>> places; // of each point: the ends of its edge, the fraction
  for (const Curve_point& p : placed.points)
  {
    if (p.is_vertex())
    {
      places.push_back({{-1, -1}, 0});
      continue;
    }
    const Index u = s.source(p.halfedge), v = s.target(p.halfedge);
    places.emplace_back(std::minmax(u, v), u < v ? p.t : 1 - p.t);
  }
  std::vector<Index> vertices = insert_curves(root, s, {placed}).vertices.front();
  Divided_edges on;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const auto& [ends, fraction] = places[i];
    if (ends.first >= 0) { on[ends].emplace_back(fraction, vertices[i]); }
  }
  return {std::move(vertices), std::move(on)};
}

// The vertices of an earlier curve, with those that now divide its edges.
std::vector<Index> refine_loop(const std::vector<Index>& vertices, Divided_edges& on)
{
  std::vector<Index> path;
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const Index u = vertices[i], v = vertices[(i + 1) % vertices.size()];
    path.push_back(u);
    auto between = on.find(std::minmax({u, v}));
    if (between == on.end()) { continue; }
    std::sort(between->second.begin(), between->second.end());
    std::vector<Index> added;
    for (const auto& [d, w] : between->second) { added.push_back(w); }
    if (u > v) { std::reverse(added.begin(), added.end()); }
    path.insert(path.end(), added.begin(), added.end());
  }
  return path;
}

// Inserts the chosen loops one after another.
void insert_loops(const Triangle_surface& root, const std::vector<Dual_loop>& loops, const Basis_options& options,
                  Homology_basis& basis)
{
  Refined_surface& s = basis.surface;
  for (const Dual_loop& loop : loops)
  {
    Normal_curves curves = curve_of(s, Loop_transfer(root, s).transfer(loop.crossings));
    if (options.tighten) { tighten_curve(curves, 0, options.tightening); }
    Generator_curve curve;
    auto [vertices, on] = insert_loop(root, s, place_loop(s, curves));
    curve.vertices = std::move(vertices);
    for (Generator_curve& earlier : basis.loops) { earlier.vertices = refine_loop(earlier.vertices, on); }
    curve.length_found = loop.length_found;
    basis.loops.push_back(std::move(curve));
  }
  for (Generator_curve& c : basis.loops) { c.length = length(s, c.vertices); }
}

} // namespace

} // namespace internal

Homology_basis find_shortest_basis(const Triangle_surface& root, const Basis_options& options)
{
  check_surface(root);
  Homology_basis basis;
  const Stage_runner run{options.observer, basis.seconds};
  basis.boundary_loops = static_cast<int>(boundary_loops(root).size());
  basis.genus = genus(root);
  basis.smallest_angle_before = basis.smallest_angle_after = smallest_angle(root);
  basis.surface = Refined_surface(root);
  if (basis.genus == 0) { return basis; }
  const std::size_t wanted = 2 * static_cast<std::size_t>(basis.genus);
  std::vector<internal::Dual_loop> loops;
  run(Stage::LONGITUDES, [&] { loops = internal::find_candidates(root, basis.genus, options, run); });
  run(Stage::TIGHTEN, [&] { loops = internal::tighten_and_choose(root, std::move(loops), wanted, options, run); });
  run(Stage::INSERT, [&] { internal::insert_loops(root, loops, options, basis); });
  basis.smallest_angle_after = smallest_angle(basis.surface);
  return basis;
}

} // namespace meridian
