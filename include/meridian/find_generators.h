// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIND_GENERATORS_H
#define MERIDIAN_FIND_GENERATORS_H

#include <meridian/internal/find_crossing_loop.h>
#include <meridian/internal/place_normal_curves.h>
#include <meridian/project_contours.h>
#include <meridian/insert_curves.h>
#include <meridian/select_meridians.h>
#include <meridian/tighten_curves.h>

namespace meridian {

/// \ingroup PkgMeridianGenerators
/// what one may choose about generators. Vertices are those of the surface.
struct Generator_options : Field_options
{
  Preference preference = preference::gaussian_curvature;
  bool tighten = true; ///< whether the curves are shortened within their classes
  Tighten_options tightening;
  Progress_observer* observer = nullptr;
};

/// \ingroup PkgMeridianGenerators
/// how a curve was made.
enum class Curve_method
{
  CONTOUR, ///< a contour of the field
  FLOW,    ///< flow lines: every segment is monotone in a field
  ARC      ///< a shortest path between the two sides of the meridian
};

/// \ingroup PkgMeridianGenerators
/// \returns the name of a method as it stands in reports
inline const char* name_of(Curve_method method)
{
  switch (method)
  {
  case Curve_method::CONTOUR: return "contour";
  case Curve_method::FLOW: return "flow";
  case Curve_method::ARC: return "arc";
  }
  return "";
}

/// \ingroup PkgMeridianGenerators
/// on which side of its surface a curve bounds, up to homology (Dey, Li, Sun 2007).
enum class Loop_class
{
  HANDLE,  ///< on the bounded side, like the meridian of a torus
  TUNNEL,  ///< on the other side, like its longitude
  NEITHER,
  UNKNOWN  ///< the surface has a boundary, meets itself or has faces without area
};

/// \ingroup PkgMeridianGenerators
/// \returns the name of a class as it stands in reports
inline const char* name_of(Loop_class c)
{
  switch (c)
  {
  case Loop_class::HANDLE: return "handle";
  case Loop_class::TUNNEL: return "tunnel";
  case Loop_class::NEITHER: return "neither";
  case Loop_class::UNKNOWN: return "unknown";
  }
  return "";
}

/// \ingroup PkgMeridianGenerators
/// a closed curve of a pair.
struct Generator_curve
{
  std::vector<Index> vertices; ///< of the refined surface, the one shared by the pair first
  double length = 0;
  double length_found = 0;     ///< before tightening
  Index saddle = -1;           ///< the root vertex of the saddle it belongs to, or nearest to it; -1 if there is none
  Curve_method method = Curve_method::ARC;
  Loop_class loop_class = Loop_class::UNKNOWN; ///< written by `classify_generators()`
};

/// \ingroup PkgMeridianGenerators
/// a meridian and a longitude of one handle.
struct Generator_pair { Generator_curve meridian, longitude; };

/// \ingroup PkgMeridianGenerators
/// generators of one connected surface, and what was counted on the way.
struct Generators : Field_summary
{
  Refined_surface surface;           ///< the input, refined; the curves are its seams
  std::vector<Generator_pair> pairs; ///< as many as the genus
  int genus = 0, boundary_loops = 0;
  double smallest_angle_before = 0, smallest_angle_after = 0; ///< in radians
  Stage_times seconds;
};

namespace internal {

// Contours as curves 2i of a system, in the order that the levels give them.
inline void add_contours(const Triangle_surface& root, const Ordered_surface& m, const std::vector<const Contour*>& contours,
                         Normal_curves& curves)
{
  const auto all = project_crossings(root, m, contours);
  struct Place { std::size_t curve, position; };
  std::vector<Place> places;
  for (std::size_t c = 0; c < all.size(); ++c)
    for (std::size_t i = 0; i < all[c].size(); ++i) { places.push_back({c, i}); }
  const auto at = [&](const Place& p) -> const Crossing& { return all[p.curve][p.position]; };
  std::sort(places.begin(), places.end(), [&](const Place& p, const Place& q) { return is_before(at(p), at(q)); });
  std::vector<std::vector<double>> rank(all.size());
  for (std::size_t c = 0; c < all.size(); ++c) { rank[c].resize(all[c].size()); }
  for (std::size_t i = 0; i < places.size(); ++i) { rank[places[i].curve][places[i].position] = static_cast<double>(i); }
  for (std::size_t c = 0; c < all.size(); ++c)
  {
    std::vector<Normal_curves::Step> steps;
    for (std::size_t i = 0; i < all[c].size(); ++i)
    {
      Index place = 0;
      for (Index x : curves.on(all[c][i].edge)) { place += curves[x].t < rank[c][i]; }
      steps.push_back({all[c][i].halfedge, place, rank[c][i]});
    }
    curves.add(static_cast<Index>(2 * c), steps);
  }
  for (std::size_t c = 0; c < all.size(); ++c)
  {
    const auto crossings = curves.crossings(static_cast<Index>(2 * c));
    for (std::size_t i = 0; i < crossings.size(); ++i) { curves.move(crossings[i], all[c][i].t); }
  }
}

inline double length(const Normal_curves& curves, Index c)
{
  const Triangle_surface& s = curves.surface();
  double sum = 0;
  for (Index x : curves.crossings(c))
  {
    const Index y = curves[x].next;
    sum += distance(s.point_on(curves.edge(x), curves[x].t), s.point_on(curves.edge(y), curves[y].t));
  }
  return sum;
}

inline double length(const Triangle_surface& s, const std::vector<Index>& loop)
{
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) { sum += distance(s.points[loop[i]], s.points[loop[(i + 1) % loop.size()]]); }
  return sum;
}

// The contract, on normal curves.
inline void check_contract(const Normal_curves& curves)
{
  for (Index n : curves.count_crossings())
    if (n != 1) { throw Internal_error("find_generators: a meridian and its longitude cross " + std::to_string(n) + " times"); }
}

// Finds longitudes, the shortest first: one is taken when no other could be shorter. Curves that are there only lengthen
// the way of the others, so a way is the shortest still if nothing has come to its edges since it was found.
inline void add_shortest_longitudes(Normal_curves& curves, Index pairs, const Stage_runner& run)
{
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  constexpr double enough = 1.1; // a loop need not be searched for again that is at most so much longer than the next
  Crossing_loop_search searcher(curves);
  std::vector<Crossing_loop> loops(pairs);
  std::vector<std::vector<std::size_t>> crowd(pairs); // how many crossings the edges of a loop had
  const auto count = [&](Index i) {
    std::vector<std::size_t> sizes;
    for (const auto& step : loops[i].steps) { sizes.push_back(curves.on(curves.surface().edge(step.halfedge)).size()); }
    return sizes;
  };
  const auto search = [&](Index i) {
    loops[i] = searcher.find(2 * i);
    crowd[i] = count(i);
  };
  for (Index i = 0; i < pairs; ++i)
  {
    search(i);
    queue.emplace(loops[i].length, i);
    run.progress(Stage::LONGITUDES, (i + 1.) / (2 * pairs));
  }
  for (Index done = 0; !queue.empty();)
  {
    const Index i = queue.top().second;
    queue.pop();
    if (count(i) != crowd[i])
    {
      search(i);
      if (!queue.empty() && loops[i].length > enough * queue.top().first)
      {
        queue.emplace(loops[i].length, i);
        continue;
      }
    }
    curves.add(2 * i + 1, loops[i].steps);
    loops[i].steps.clear();
    run.progress(Stage::LONGITUDES, (pairs + ++done) / (2. * pairs));
  }
}

} // namespace internal

namespace internal {

// The saddle that a longitude turns at on the far side of its handle: of the two extremes of the field along it, the one farther from
// the meridian's saddle lies beyond it. Returns a vertex of `m.surface`.
inline Index find_far_saddle(const Ordered_surface& m, const Normal_curves& curves, Index longitude, Index saddle)
{
  const Triangle_surface& root = curves.surface();
  Index low = m.order.nodes.size(), high = -1;
  for (Index x : curves.crossings(longitude))
    for (Index v : {root.source(curves[x].halfedge), root.target(curves[x].halfedge)})
    {
      low = std::min(low, m.rank[v]);
      high = std::max(high, m.rank[v]);
    }
  const Index at = m.rank[saddle];
  const bool upwards = high - at > at - low;
  Index best = -1;
  for (const Critical_point& p : find_critical_points(m.surface, m.rank))
  {
    const Index r = m.rank[p.vertex];
    if (p.kind != Critical_kind::SADDLE || r == at || (upwards ? r > high || r < at : r < low || r > at)) { continue; }
    if (best < 0 || (upwards ? r > m.rank[best] : r < m.rank[best])) { best = p.vertex; }
  }
  return best;
}

// Generators on a surface that is ordered. Returns for each pair its two saddles, as vertices of `m.surface`; the second may be -1.
inline std::vector<std::pair<Index, Index>> find_generators(const Triangle_surface& root, const Ordered_surface& m, const Generator_options& options,
                                                            const Stage_runner& run, Generators& g)
{
  std::vector<std::pair<Index, Index>> saddles;
  static_cast<Field_summary&>(g) = summarize_field(root, m);
  Meridian_search search;
  run(Stage::CONTOURS, [&] { search.loops = trace_saddle_loops(m); });
  Normal_curves curves(root, 2 * g.genus);
  run(Stage::MERIDIANS, [&] {
    find_meridians(root, m, g.genus, options.preference, search);
    add_contours(root, m, search.chosen(), curves);
    g.pairs.resize(g.genus);
    for (int i = 0; i < g.genus; ++i)
    {
      const std::size_t loop = search.choices[i].loop;
      g.pairs[i].meridian.saddle = search.candidates[loop].saddle;
      g.pairs[i].meridian.method = Curve_method::CONTOUR;
      saddles.emplace_back(search.loops[loop].saddle, -1);
    }
  });
  run(Stage::LONGITUDES, [&] {
    add_shortest_longitudes(curves, g.genus, run);
    check_contract(curves);
    for (int i = 0; i < g.genus; ++i)
    {
      saddles[i].second = find_far_saddle(m, curves, 2 * i + 1, saddles[i].first);
      if (saddles[i].second >= 0) { g.pairs[i].longitude.saddle = root_vertex(root, m.surface, saddles[i].second); }
    }
  });
  for (int i = 0; i < g.genus; ++i)
  {
    g.pairs[i].meridian.length_found = length(curves, 2 * i);
    g.pairs[i].longitude.length_found = length(curves, 2 * i + 1);
  }
  if (options.tighten)
    run(Stage::TIGHTEN, [&] {
      Tighten_options tightening = options.tightening;
      tightening.progress = [&](double done) { run.progress(Stage::TIGHTEN, done); };
      tighten_curves(curves, tightening);
      check_contract(curves);
    });
  run(Stage::INSERT, [&] {
    const auto paths = insert_curves(root, g.surface, place_normal_curves(curves)).vertices;
    for (int i = 0; i < g.genus; ++i)
    {
      std::vector<Index> meridian = paths[2 * i], longitude = paths[2 * i + 1];
      std::vector<Index> sorted = longitude;
      std::sort(sorted.begin(), sorted.end());
      const auto shared = std::find_if(meridian.begin(), meridian.end(), [&](Index v) { return std::binary_search(sorted.begin(), sorted.end(), v); });
      if (shared == meridian.end()) { throw Internal_error("find_generators: a pair shares no vertex"); }
      const Index v = *shared;
      std::rotate(meridian.begin(), shared, meridian.end());
      std::rotate(longitude.begin(), std::find(longitude.begin(), longitude.end(), v), longitude.end());
      g.pairs[i].meridian.length = length(g.surface, meridian);
      g.pairs[i].longitude.length = length(g.surface, longitude);
      g.pairs[i].meridian.vertices = std::move(meridian);
      g.pairs[i].longitude.vertices = std::move(longitude);
    }
  });
  return saddles;
}

} // namespace internal

/*!
 * \ingroup PkgMeridianGenerators
 *
 * finds a meridian and a longitude around every handle of a connected surface (Patane 2007, section 4).
 *
 * Meridians are contours of a harmonic field, chosen as for a cut. A longitude is the shortest way from one side of its
 * meridian to the other that crosses no other curve, and back along it; the shortest are taken first. One always exists: cutting
 * along disjoint meridians and arcs that join their two sides leaves the surface connected. Then all curves are tightened.
 *
 * \tparam SymmetricTraits, GeneralTraits models of CGAL's `SparseLinearAlgebraWithFactorTraits_d`; the second serves
 *         mean-value weights
 * \param root the surface
 * \param options see there
 *
 * \returns the generators
 * \pre `root` is connected
 * \post there are as many pairs as the genus; each curve is simple and closed; the two of a pair share one vertex and cross there,
 *       the longitude from right to left; curves of different pairs are disjoint
 * \throws Invalid_input_error if minima and maxima coincide, Solver_error if the field cannot be solved, Cancelled if the
 *         observer says so, Internal_error if an invariant broke
 * \par Complexity
 * One factorization, and for each handle a search as far as its longitude is long.
 */
template <class SymmetricTraits = Symmetric_solver_traits, class GeneralTraits = General_solver_traits>
Generators find_generators(const Triangle_surface& root, const Generator_options& options = Generator_options())
{
  Generators g;
  const internal::Stage_runner run{options.observer, g.seconds};
  g.boundary_loops = static_cast<int>(boundary_loops(root).size());
  const int characteristic = root.number_of_vertices() - root.number_of_edges() + root.number_of_faces();
  g.genus = (2 - characteristic - g.boundary_loops) / 2;
  g.smallest_angle_before = smallest_angle(root);
  g.surface = Refined_surface(root);
  if (g.genus > 0)
  {
    const Ordered_surface m = order_surface<SymmetricTraits, GeneralTraits>(root, options, run);
    internal::find_generators(root, m, options, run, g);
  }
  g.smallest_angle_after = smallest_angle(g.surface);
  return g;
}

} // namespace meridian

#endif // MERIDIAN_FIND_GENERATORS_H
