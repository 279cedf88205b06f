// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIND_GENERATORS_H
#define MERIDIAN_FIND_GENERATORS_H

#include <meridian/fill_boundary.h>
#include <meridian/internal/find_crossing_loop.h>
#include <meridian/internal/flow_loops.h>
#include <meridian/internal/place_normal_curves.h>
#include <meridian/project_contours.h>
#include <meridian/insert_curves.h>
#include <meridian/select_meridians.h>
#include <meridian/tighten_curves.h>

#include <memory>

namespace meridian {

/// \ingroup PkgMeridianGenerators
/// what one may choose about generators. Vertices are those of the surface.
struct Generator_options : Field_options
{
  Preference preference = preference::gaussian_curvature;
  bool is_open = false; ///< whether the field's boundary is free, so that level lines may end there
  bool keep_complex = false; ///< whether the quasi Morse-Smale complex of the field is kept
  bool flow = true;    ///< whether longitudes are sought among flow lines first
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
  bool was_flow = false;                       ///< whether it was made of flow lines before it was tightened
  std::map<Index, double> field;               ///< of flow lines: the field at root vertices around, linear along edges
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
  bool is_morse_smale = true;        ///< whether no flow line of the field joins two saddles
  int saddle_connections = 0;        ///< how many do
  std::vector<std::vector<Point>> complex_lines; ///< the flow lines of the field, from saddle to critical point, if asked for
  int genus = 0, boundary_loops = 0;
  int arcs = 0, loops = 0;           ///< with a free boundary: the meridians' level lines that end on it, and those that do not
  double smallest_angle_before = 0, smallest_angle_after = 0; ///< in radians
  Stage_times seconds;
};

namespace internal {

// Contours as curves 2i of a system, in the order that the levels give them.
inline void add_contours(const std::vector<std::vector<Crossing>>& all, Normal_curves& curves)
{
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
//
// `take_flow(i, loop)` may add another curve in place of `loop`, and says whether it did.
template <class Take_flow>
void add_shortest_longitudes(Normal_curves& curves, Index pairs, const Stage_runner& run, const Take_flow& take_flow)
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
    if (!take_flow(i, loops[i])) { curves.add(2 * i + 1, loops[i].steps); }
    loops[i].steps.clear();
    run.progress(Stage::LONGITUDES, (pairs + ++done) / (2. * pairs));
  }
}

} // namespace internal

namespace internal {

// Looks for longitudes among flow lines (Patane 2007, section 4).
template <class SymmetricTraits, class GeneralTraits>
class Flow_longitudes
{
public:
  // `saddles`: of each pair's meridian, in `m.surface`.
  Flow_longitudes(const Triangle_surface& root, const Ordered_surface& m, const Morse_complex& complex, Normal_curves& curves, const std::vector<std::pair<Index, Index>>& saddles)
    : m_root(root), m_ordered(m), m_curves(curves), m_saddles(saddles), m_complex(complex), m_critical(find_critical_points(m.surface, m.rank))
  {
    if (static_cast<int>(saddles.size()) > few) { return; }
    m_fields = std::make_unique<Two_point_fields<SymmetricTraits>>(root);
    m_whole.surface = root;
    for (Index v = 0; v < root.number_of_vertices(); ++v) { m_whole.vertex_of.push_back(v); }
    for (Index f = 0; f < root.number_of_faces(); ++f) { m_whole.face_of.push_back(f); }
  }

  // Adds a longitude of flow lines for pair `i`, if there is one that is not much longer than the arc found for it.
  bool add(Index i, const Crossing_loop& arc, Generator_pair& pair)
  {
    // Both lines of the meridian's saddle may come to one end in the field itself.
    if (m_fields)
      for (bool descend : {false, true})
      {
        Flow_tracer tracer(m_ordered, descend, m_critical);
        if (take(i, find_flow_loops(m_curves, m_whole, m_ordered, {m_saddles[i].first}, tracer), m_ordered, m_whole, arc, pair)) { return true; }
      }
    const Index low = pair.meridian.saddle;
    const Index across = farthest_on(arc, low);
    if (!m_fields) { return add_on_patch(i, arc, low, across, pair); }
    // The saddle becomes the minimum of a field; the maximum is where the shortest flow line from it comes to or, for the second
    // iteration, across the handle.
    for (Index high : {nearest_critical(m_saddles[i].first), across})
    {
      Ordered_surface h;
      if (high < 0 || !m_fields->order(low, high, h)) { continue; }
      if (take_all(i, h, m_whole, arc, pair)) { return true; }
    }
    return false;
  }

private:
  static constexpr int few = 8;            // handles for which fields are solved on the whole surface
  static constexpr double longer = 1.25;   // than the arc, at most
  static constexpr double reach = 0.3;     // of a patch, in lengths of the arc
  static constexpr std::size_t share = 4;  // of all patches together, in faces of the surface, at most

  Index farthest_on(const Crossing_loop& arc, Index from) const
  {
    Index best = -1;
    for (const auto& step : arc.steps)
    {
      const Index v = m_root.source(step.halfedge);
      if (best < 0 || distance(m_root.points[v], m_root.points[from]) > distance(m_root.points[best], m_root.points[from])) { best = v; }
    }
    return best;
  }
  Index nearest_critical(Index saddle) const
  {
    double least = std::numeric_limits<double>::infinity();
    Index best = -1;
    const Complex_graph& graph = m_complex.graph;
    for (auto [e, last] = boost::edges(graph); e != last; ++e)
    {
      const Flow_line& line = m_complex.lines[graph[*e].line];
      if (m_ordered.graph.node[line.start] != m_ordered.graph.node[saddle] || !(graph[*e].length < least)) { continue; }
      least = graph[*e].length;
      best = root_vertex(m_root, m_ordered.surface, line.end);
    }
    return best;
  }
  bool add_on_patch(Index i, const Crossing_loop& arc, Index low, Index high, Generator_pair& pair)
  {
    std::vector<Index> faces;
    for (Index x : m_curves.crossings(2 * i)) { faces.push_back(m_curves.face_after(x)); }
    for (const auto& step : arc.steps) { faces.push_back(m_root.face(step.halfedge)); }
    const Surface_patch patch = cut_patch(m_root, faces, faces.front(), reach * arc.length, share * m_root.number_of_faces() / m_saddles.size());
    if (!patch.vertex.count(low) || !patch.vertex.count(high) || low == high) { return false; }
    Field_options options;
    options.minima = {patch.vertex.at(low)};
    options.maxima = {patch.vertex.at(high)};
    const Node_graph g = make_node_graph(patch.surface);
    if (g.node[options.minima.front()] == g.node[options.maxima.front()]) { return false; }
    const Ordered_surface h = order_surface<SymmetricTraits, GeneralTraits>(patch.surface, options, [](Stage, const auto& work) { work(); });
    return take_all(i, h, patch, arc, pair);
  }
  bool take_all(Index i, const Ordered_surface& h, const Surface_patch& patch, const Crossing_loop& arc, Generator_pair& pair)
  {
    const auto critical = find_critical_points(h.surface, h.rank);
    std::vector<Index> saddles;
    for (const Critical_point& p : critical) { if (p.kind == Critical_kind::SADDLE) { saddles.push_back(p.vertex); } }
    Flow_tracer tracer(h, true, critical);
    return take(i, find_flow_loops(m_curves, patch, h, saddles, tracer), h, patch, arc, pair);
  }
  bool take(Index i, const std::vector<Flow_loop>& loops, const Ordered_surface& h, const Surface_patch& patch, const Crossing_loop& arc, Generator_pair& pair)
  {
    for (const Flow_loop& loop : loops)
    {
      if (loop.length > longer * arc.length) { return false; }
      if (!try_loop(m_curves, 2 * i + 1, loop.steps)) { continue; }
      pair.longitude.method = Curve_method::FLOW;
      pair.longitude.was_flow = true;
      pair.longitude.saddle = loop.saddle;
      for (const auto& step : loop.steps)
        for (Index v : {m_root.source(step.halfedge), m_root.target(step.halfedge)})
          pair.longitude.field.emplace(v, h.field(h.graph.node[patch.vertex.empty() ? v : patch.vertex.at(v)]));
      return true;
    }
    return false;
  }

  const Triangle_surface& m_root;
  const Ordered_surface& m_ordered;
  Normal_curves& m_curves;
  const std::vector<std::pair<Index, Index>>& m_saddles;
  const Morse_complex& m_complex;
  std::vector<Critical_point> m_critical;
  std::unique_ptr<Two_point_fields<SymmetricTraits>> m_fields; // on the whole surface
  Surface_patch m_whole;
};

// The edges that a curve crosses, with fractions along the halfedges by which it leaves faces.
inline std::vector<Passing> passings_of(const Normal_curves& curves, Index c)
{
  std::vector<Passing> passings;
  for (Index x : curves.crossings(c))
    passings.push_back({curves[x].halfedge, curves.edge(x) == curves[x].halfedge ? curves[x].t : 1 - curves[x].t});
  return passings;
}

// Whether a closed curve rises once and falls once in a field, linear along edges.
inline bool is_monotone(const Refined_surface& s, const std::vector<Index>& loop, const std::map<Index, double>& field)
{
  std::vector<double> value;
  for (Index v : loop)
  {
    const Origin o = s.origin(v);
    if (o.kind == Origin::FACE) { return false; }
    const auto a = field.find(o.index[0]), b = o.kind == Origin::EDGE ? field.find(o.index[1]) : a;
    if (a == field.end() || b == field.end()) { return false; }
    value.push_back(o.kind == Origin::EDGE ? a->second + o.weight[0] * (b->second - a->second) : a->second);
  }
  int turns = 0;
  for (std::size_t i = 0; i < value.size(); ++i)
  {
    const double before = value[(i + value.size() - 1) % value.size()], at = value[i], after = value[(i + 1) % value.size()];
    if (!(at < after) && !(at > after)) { return false; }
    turns += (before < at) != (at < after);
  }
  return turns == 2;
}

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

// A vertex of a filled surface, or the surface's vertex next to it.
inline Index nearest_on_surface(const Triangle_surface& root, const Filled_surface* filled, Index v)
{ return v < root.number_of_vertices() ? v : filled->surface.target(filled->surface.outgoing[v]); }

// Generators on a surface that is ordered. Returns for each pair its two saddles, as vertices of `m.surface`; the second may be -1. If
// `crossings` is given, only the edges that the curves cross are written to it. If
// `filled` is given, `m` orders that surface.
template <class SymmetricTraits, class GeneralTraits>
std::vector<std::pair<Index, Index>> find_generators(const Triangle_surface& root, const Ordered_surface& m, const Generator_options& options,
                                                     const Stage_runner& run, Generators& g, std::vector<std::vector<Passing>>* crossings = nullptr,
                                                     const Filled_surface* filled = nullptr)
{
  std::vector<std::pair<Index, Index>> saddles;
  static_cast<Field_summary&>(g) = summarize_field(root, m);
  Meridian_search search;
  run(Stage::CONTOURS, [&] { search.loops = trace_saddle_loops(m); });
  Normal_curves curves(root, 2 * g.genus);
  run(Stage::MERIDIANS, [&] {
    find_meridians(filled ? filled->surface : root, m, g.genus, options.preference, search);
    add_contours(filled ? project_from_filled(root, *filled, m, search.chosen(), g.arcs, g.loops) : project_crossings(root, m, search.chosen()), curves);
    g.pairs.resize(g.genus);
    for (int i = 0; i < g.genus; ++i)
    {
      const std::size_t loop = search.choices[i].loop;
      g.pairs[i].meridian.saddle = nearest_on_surface(root, filled, search.candidates[loop].saddle);
      g.pairs[i].meridian.method = Curve_method::CONTOUR;
      saddles.emplace_back(search.loops[loop].saddle, -1);
    }
  });
  Morse_complex complex;
  run(Stage::FLOW, [&] {
    complex = make_morse_complex(m);
    g.is_morse_smale = complex.is_morse_smale();
    g.saddle_connections = static_cast<int>(complex.connections.size());
    for (Index i = 0; i < static_cast<Index>(complex.lines.size()) && options.keep_complex; ++i)
    {
      auto& points = g.complex_lines.emplace_back();
      for (const Curve_point& p : whole_line(complex.lines, i)) { points.push_back(position(m.surface, p)); }
    }
  });
  run(Stage::LONGITUDES, [&] {
    std::unique_ptr<Flow_longitudes<SymmetricTraits, GeneralTraits>> flow;
    if (options.flow && !filled) { flow = std::make_unique<Flow_longitudes<SymmetricTraits, GeneralTraits>>(root, m, complex, curves, saddles); }
    add_shortest_longitudes(curves, g.genus, run, [&](Index i, const Crossing_loop& arc) { return flow && flow->add(i, arc, g.pairs[i]); });
    check_contract(curves);
    for (int i = 0; i < g.genus; ++i)
    {
      saddles[i].second = find_far_saddle(m, curves, 2 * i + 1, saddles[i].first);
      if (saddles[i].second >= 0 && g.pairs[i].longitude.saddle < 0) { g.pairs[i].longitude.saddle = nearest_on_surface(root, filled, root_vertex(filled ? filled->surface : root, m.surface, saddles[i].second)); }
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
  if (crossings)
  {
    for (Index c = 0; c < curves.number_of_curves(); ++c) { crossings->push_back(passings_of(curves, c)); }
    return saddles;
  }
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
      Generator_curve& l = g.pairs[i].longitude;
      if (l.method == Curve_method::FLOW && !is_monotone(g.surface, l.vertices, l.field))
      {
        l.method = Curve_method::ARC;
        l.field.clear();
      }
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
 * along disjoint meridians and arcs that join their two sides leaves the surface connected. Then all curves are tightened. If flow
 * lines are wanted, they are looked for first.
 *
 * With a free boundary, level lines may be arcs; one that is part of a meridian is closed along the boundary loops it ends on.
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
    if (options.is_open && g.boundary_loops > 0)
    {
      const Filled_surface filled = fill_boundary(root);
      const Ordered_surface m = order_with_free_boundary<SymmetricTraits, GeneralTraits>(filled, options, run);
      internal::find_generators<SymmetricTraits, GeneralTraits>(root, m, options, run, g, nullptr, &filled);
    }
    else
    {
      const Ordered_surface m = order_surface<SymmetricTraits, GeneralTraits>(root, options, run);
      internal::find_generators<SymmetricTraits, GeneralTraits>(root, m, options, run, g);
    }
  }
  g.smallest_angle_after = smallest_angle(g.surface);
  return g;
}

} // namespace meridian

#endif // MERIDIAN_FIND_GENERATORS_H
