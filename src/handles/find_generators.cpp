// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/handles/find_generators.h>

#include <meridian/base/Progress_observer.h>
#include <meridian/base/exceptions.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/curves/add_contours.h>
#include <meridian/curves/chords.h>
#include <meridian/curves/contours.h>
#include <meridian/curves/find_crossing_loop.h>
#include <meridian/curves/morse_complex.h>
#include <meridian/curves/place_normal_curves.h>
#include <meridian/curves/project_contours.h>
#include <meridian/curves/tighten_curves.h>
#include <meridian/field/Field.h>
#include <meridian/field/critical_points.h>
#include <meridian/field/order_surface.h>
#include <meridian/field/order_with_free_boundary.h>
#include <meridian/handles/find_meridians.h>
#include <meridian/handles/internal/arc_longitudes.h>
#include <meridian/handles/internal/flow_longitudes.h>
#include <meridian/handles/internal/project_from_filled.h>
#include <meridian/handles/preference.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/check_surface.h>
#include <meridian/surface/insert_curves.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/root_edges.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

namespace {

// Whether a closed curve rises once and falls once in a field, linear along edges.
bool is_monotone(const Refined_surface& s, const std::vector<Index>& loop, const std::map<Index, double>& field)
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
    const double before = value[(i + value.size() - 1) % value.size()], at = value[i],
                 after = value[(i + 1) % value.size()];
    if (!(at < after) && !(at > after)) { return false; }
    turns += (before < at) != (at < after);
  }
  return turns == 2;
}

// The saddle that a longitude turns at on the far side of its handle: of the two extremes of the field along it, the
// one farther from the meridian's saddle lies beyond it. Returns a vertex of `m.surface`.
Index find_far_saddle(const Ordered_surface& m, const std::vector<Critical_point>& critical,
                      const Normal_curves& curves, Index longitude, Index saddle)
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
  for (const Critical_point& p : critical)
  {
    const Index r = m.rank[p.vertex];
    if (p.kind != Critical_kind::SADDLE || r == at || (upwards ? r > high || r < at : r < low || r > at)) { continue; }
    if (best < 0 || (upwards ? r > m.rank[best] : r < m.rank[best])) { best = p.vertex; }
  }
  return best;
}

// A vertex of a filled surface, or the surface's vertex next to it.
Index nearest_on_surface(const Triangle_surface& root, const Filled_surface* filled, Index v)
{
  return v < root.number_of_vertices() ? v : filled->surface.target(filled->surface.outgoing[v]);
}

// Turns two closed walks to begin at the first vertex of the first that both visit.
void rotate_to_shared(std::vector<Index>& meridian, std::vector<Index>& longitude)
{
  std::vector<Index> sorted = longitude;
  std::sort(sorted.begin(), sorted.end());
  const auto shared = std::find_if(meridian.begin(), meridian.end(),
                                   [&](Index v) { return std::binary_search(sorted.begin(), sorted.end(), v); });
  if (shared == meridian.end()) { throw Internal_error("find_generators: a pair shares no vertex"); }
  const Index v = *shared;
  std::rotate(meridian.begin(), shared, meridian.end());
  std::rotate(longitude.begin(), std::find(longitude.begin(), longitude.end(), v), longitude.end());
}

// The stages of a search for generators. Of pair `i` the meridian is curve `2 i` and the longitude curve `2 i + 1`.
class Generator_search
{
public:
  Generator_search(const Triangle_surface& root, const Ordered_surface& m, const Generator_options& options,
                   const Stage_runner& run, Generators& g, const Filled_surface* filled)
    : m_root(root), m_ordered(m), m_options(options), m_run(run), m_result(g), m_filled(filled),
      m_curves(root, 2 * g.genus)
  {}

  void trace_contours() { m_meridians.loops = trace_saddle_loops(m_ordered); }

  void add_meridians()
  {
    find_meridians(whole(), m_ordered, genus(), m_options.preference, m_meridians, m_options.levels,
                   whole().number_of_vertices() - m_root.number_of_vertices());
    add_contours(
      m_filled ? project_from_filled(m_root, *m_filled, m_ordered, m_meridians.chosen(), m_result.arcs, m_result.loops)
               : project_crossings(m_root, m_ordered, m_meridians.chosen()),
      m_curves);
    m_result.pairs.resize(genus());
    for (int i = 0; i < genus(); ++i)
    {
      const std::size_t loop = m_meridians.choices[i].loop;
      Generator_curve& meridian = m_result.pairs[i].meridian;
      meridian.saddle = nearest_on_surface(m_root, m_filled, m_meridians.candidates[loop].saddle);
      meridian.method = Curve_method::CONTOUR;
      m_saddles.emplace_back(m_meridians.loops[loop].saddle, -1);
    }
  }

  void trace_flow()
  {
    m_complex = make_morse_complex(m_ordered);
    m_result.is_morse_smale = m_complex.is_morse_smale();
    m_result.saddle_connections = static_cast<int>(m_complex.connections.size());
    for (Index i = 0; i < static_cast<Index>(m_complex.lines.size()) && m_options.keep_complex; ++i)
    {
      auto& points = m_result.complex_lines.emplace_back();
      for (const Curve_point& p : whole_line(m_complex.lines, i)) { points.push_back(position(m_ordered.surface, p)); }
    }
  }

  void add_longitudes()
  {
    std::unique_ptr<Flow_longitudes> flow;
    // With more handles a field is solved on a patch for each, and hardly a loop found there outlives tightening.
    const bool is_worth_it = genus() <= Flow_longitudes::few || !m_options.tighten;
    if (m_options.flow && !m_filled && is_worth_it)
    {
      flow = std::make_unique<Flow_longitudes>(m_root, m_ordered, m_complex, m_curves, m_saddles,
                                               m_options.tighten ? 1.02 : 1.25, m_options.solvers);
    }
    add_shortest_longitudes(m_curves, genus(), m_run, [&](Index i, const Crossing_loop& arc) {
      return flow && flow->add(i, arc, m_result.pairs[i]);
    });
    check_contract(m_curves);
    const std::vector<Critical_point> critical = find_critical_points(m_ordered.surface, m_ordered.rank);
    for (int i = 0; i < genus(); ++i)
    {
      m_saddles[i].second = find_far_saddle(m_ordered, critical, m_curves, 2 * i + 1, m_saddles[i].first);
      Generator_curve& longitude = m_result.pairs[i].longitude;
      if (m_saddles[i].second >= 0 && longitude.saddle < 0)
      {
        longitude.saddle =
          nearest_on_surface(m_root, m_filled, root_vertex(whole(), m_ordered.surface, m_saddles[i].second));
      }
    }
  }

  void measure()
  {
    for (int i = 0; i < genus(); ++i)
    {
      m_result.pairs[i].meridian.length_found = length(m_curves, 2 * i);
      m_result.pairs[i].longitude.length_found = length(m_curves, 2 * i + 1);
    }
  }

  void tighten()
  {
    tighten_curves(m_curves, m_options.tightening, [&](double done) { m_run.progress(Stage::TIGHTEN, done); });
    check_contract(m_curves);
  }

  void insert()
  {
    const auto paths = insert_curves(m_root, m_result.surface, place_normal_curves(m_curves)).vertices;
    for (int i = 0; i < genus(); ++i)
    {
      std::vector<Index> meridian = paths[2 * i], longitude = paths[2 * i + 1];
      rotate_to_shared(meridian, longitude);
      auto& pair = m_result.pairs[i];
      pair.meridian.length = length(m_result.surface, meridian);
      pair.longitude.length = length(m_result.surface, longitude);
      pair.meridian.vertices = std::move(meridian);
      pair.longitude.vertices = std::move(longitude);
      Generator_curve& l = pair.longitude;
      if (l.method == Curve_method::FLOW && !is_monotone(m_result.surface, l.vertices, l.field))
      {
        l.method = Curve_method::ARC;
        l.field.clear();
      }
    }
  }

  std::vector<std::vector<Edge_place>> crossings() const
  {
    std::vector<std::vector<Edge_place>> all;
    for (Index c = 0; c < m_curves.number_of_curves(); ++c) { all.push_back(places_of(m_curves, c)); }
    return all;
  }

  const std::vector<std::pair<Index, Index>>& saddles() const { return m_saddles; }

private:
  int genus() const { return m_result.genus; }
  // The surface that is ordered.
  const Triangle_surface& whole() const { return m_filled ? m_filled->surface : m_root; }

  const Triangle_surface& m_root;
  const Ordered_surface& m_ordered;
  const Generator_options& m_options;
  const Stage_runner& m_run;
  Generators& m_result;
  const Filled_surface* m_filled;
  Normal_curves m_curves;
  Meridian_search m_meridians;
  Morse_complex m_complex;
  std::vector<std::pair<Index, Index>> m_saddles; // of each pair
};

} // namespace

std::vector<std::pair<Index, Index>> find_generators(const Triangle_surface& root, const Ordered_surface& m,
                                                     const Generator_options& options, const Stage_runner& run,
                                                     Generators& g, std::vector<std::vector<Edge_place>>* crossings,
                                                     const Filled_surface* filled)
{
  static_cast<Field_summary&>(g) = summarize_field(root, m);
  Generator_search search(root, m, options, run, g, filled);
  run(Stage::CONTOURS, [&] { search.trace_contours(); });
  run(Stage::MERIDIANS, [&] { search.add_meridians(); });
  run(Stage::FLOW, [&] { search.trace_flow(); });
  run(Stage::LONGITUDES, [&] { search.add_longitudes(); });
  search.measure();
  if (options.tighten)
  {
    run(Stage::TIGHTEN, [&] { search.tighten(); });
  }
  if (crossings)
  {
    for (auto& c : search.crossings()) { crossings->push_back(std::move(c)); }
    return search.saddles();
  }
  run(Stage::INSERT, [&] { search.insert(); });
  return search.saddles();
}

} // namespace internal

Generators find_generators(const Triangle_surface& root, const Generator_options& options)
{
  check_surface(root);
  check(root, options);
  Generators g;
  const Stage_runner run{options.observer, g.seconds};
  g.boundary_loops = static_cast<int>(boundary_loops(root).size());
  g.genus = genus(root);
  g.smallest_angle_before = smallest_angle(root);
  g.surface = Refined_surface(root);
  if (g.genus > 0)
  {
    if (options.is_open && g.boundary_loops > 0)
    {
      const Filled_surface filled = fill_boundary(root);
      Ordered_surface m = order_with_free_boundary(root, filled, options, options.solvers, run);
      m.placement = options.placement;
      internal::find_generators(root, m, options, run, g, nullptr, &filled);
    }
    else
    {
      Ordered_surface m = order_surface(root, {options, false, options.solvers}, run);
      m.placement = options.placement;
      internal::find_generators(root, m, options, run, g);
    }
  }
  g.smallest_angle_after = smallest_angle(g.surface);
  return g;
}

} // namespace meridian
