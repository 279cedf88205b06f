// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/handles/find_generators.h>

#include <meridian/base/Progress_observer.h>
#include <meridian/base/exceptions.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/curves/add_contours.h>
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
#include <meridian/surface/insert_curves.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/root_edges.h>

#include <algorithm>
#include <map>
#include <memory>

namespace meridian {

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
Index find_far_saddle(const Ordered_surface& m, const Normal_curves& curves, Index longitude, Index saddle)
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
Index nearest_on_surface(const Triangle_surface& root, const Filled_surface* filled, Index v)
{
  return v < root.number_of_vertices() ? v : filled->surface.target(filled->surface.outgoing[v]);
}

} // namespace

namespace internal {

std::vector<std::pair<Index, Index>> find_generators(const Triangle_surface& root, const Ordered_surface& m,
                                                     const Generator_options& options, const Stage_runner& run,
                                                     Generators& g, std::vector<std::vector<Passing>>* crossings,
                                                     const Filled_surface* filled)
{
  std::vector<std::pair<Index, Index>> saddles;
  static_cast<Field_summary&>(g) = summarize_field(root, m, options);
  Meridian_search search;
  run(Stage::CONTOURS, [&] { search.loops = trace_saddle_loops(m); });
  Normal_curves curves(root, 2 * g.genus);
  run(Stage::MERIDIANS, [&] {
    find_meridians(filled ? filled->surface : root, m, g.genus, options.preference, search, options.levels);
    add_contours(filled ? project_from_filled(root, *filled, m, search.chosen(), g.arcs, g.loops)
                        : project_crossings(root, m, search.chosen()),
                 curves);
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
    std::unique_ptr<Flow_longitudes> flow;
    if (options.flow && !filled)
    {
      flow = std::make_unique<Flow_longitudes>(root, m, complex, curves, saddles, options.tighten ? 1.02 : 1.25,
                                               options.solvers);
    }
    add_shortest_longitudes(curves, g.genus, run,
                            [&](Index i, const Crossing_loop& arc) { return flow && flow->add(i, arc, g.pairs[i]); });
    check_contract(curves);
    for (int i = 0; i < g.genus; ++i)
    {
      saddles[i].second = find_far_saddle(m, curves, 2 * i + 1, saddles[i].first);
      if (saddles[i].second >= 0 && g.pairs[i].longitude.saddle < 0)
      {
        g.pairs[i].longitude.saddle =
          nearest_on_surface(root, filled, root_vertex(filled ? filled->surface : root, m.surface, saddles[i].second));
      }
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
      const auto shared = std::find_if(meridian.begin(), meridian.end(),
                                       [&](Index v) { return std::binary_search(sorted.begin(), sorted.end(), v); });
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

Generators find_generators(const Triangle_surface& root, const Generator_options& options)
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
      const Ordered_surface m = order_with_free_boundary(filled, options, run);
      internal::find_generators(root, m, options, run, g, nullptr, &filled);
    }
    else
    {
      const Ordered_surface m = order_surface(root, options, run);
      internal::find_generators(root, m, options, run, g);
    }
  }
  g.smallest_angle_after = smallest_angle(g.surface);
  return g;
}

} // namespace meridian
