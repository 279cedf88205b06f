// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/internal/Chart_divider.h>

#include <meridian/base/Stage_runner.h>
#include <meridian/base/Verification.h>
#include <meridian/base/exceptions.h>
#include <meridian/cut/find_arc.h>
#include <meridian/cut/keep_out.h>
#include <meridian/cut/open_cut.h>
#include <meridian/map/find_overlaps.h>
#include <meridian/map/is_one_to_one.h>
#include <meridian/map/pack_charts.h>
#include <meridian/map/parameterize_disc.h>
#include <meridian/map/planar_map.h>
#include <meridian/map/unfold_disc.h>
#include <meridian/result/recount.h>
#include <meridian/surface/insert_curves.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/seams.h>
#include <meridian/unwrap/carry_map.h>
#include <meridian/unwrap/extend_cut.h>
#include <meridian/unwrap/internal/first_cut.h>
#include <meridian/unwrap/plan_extensions.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace meridian {

namespace internal {

namespace {

// Overlap that a map finds its way out of, as a part of the area of a chart, and of all.
constexpr double harmless_overlap = 0.02, least_overlap = 1e-5;

double wanted_excess(const Unwrap_options& options)
{
  constexpr double fair_stretch = 2;
  const double by_itself = options.charts == 0 ? default_max_stretch_of_charts : default_max_stretch;
  const double wanted = options.max_stretch.value_or(by_itself);
  return wanted > 0 ? wanted * wanted - 1 : fair_stretch * fair_stretch - 1;
}

// The mean square of the L2 stretch of faces less 1, where none counts for more than a face that is badly stretched:
// some may be turned over.
double bounded_excess(const Triangle_surface& disc, const std::vector<Plane_point>& at)
{
  constexpr double badly = 2;
  const auto faces = measure_faces(disc.points, disc.triangles, at);
  double sum = 0, whole = 0;
  for (Index f = 0; f < disc.number_of_faces(); ++f)
  {
    const auto& t = disc.triangles[f];
    const double area = norm(cross(disc.points[t[1]] - disc.points[t[0]], disc.points[t[2]] - disc.points[t[0]])) / 2;
    const double stretch = std::min(faces[f].stretch_l2, badly);
    sum += area * (stretch * stretch - 1);
    whole += area;
  }
  return whole > 0 ? sum / whole : 0;
}

// Whether a map can go on from here: it is one-to-one, and its border has room between its sides.
bool is_good_start(const Triangle_surface& disc, const std::vector<Plane_point>& at)
{
  const auto loops = boundary_loops(disc);
  std::vector<Index> border;
  for (Index h : loops.front()) { border.push_back(disc.source(h)); }
  return is_roomy(border, at) && is_one_to_one(disc, at);
}

} // namespace

Chart_divider::Chart_divider(const Triangle_surface& root, const Unwrap_options& options)
  : m_root(root), m_options(options), m_kept_out(kept_out_of(root, options)), m_wanted(wanted_excess(options)),
    m_extends(options.seams.empty() || options.charts == 0 || options.max_stretch)
{
  const auto forbid = [](bool is_wrong, const char* message) {
    if (is_wrong) { throw Invalid_input_error(message); }
  };
  forbid(options.charts < 0,
         "a surface is divided into one chart or more, or, if 0 is asked for, as many as are needed");
  forbid(options.image_size > 0, "a geometry image is one chart; charts = 1, and no seams");
  forbid(options.family != 1 || options.stretch_weight > 0,
         "cuts are compared, and links varied, for one chart; charts = 1, and no seams");
  forbid(!options.map.polygon.empty(), "a polygon for the border is for one chart; charts = 1, and no seams");
  if (!m_options.cut.tightening) { m_options.cut.tightening = Tightening::CURVES; }
}

Unwrapping Chart_divider::run()
{
  cut();
  Stage_times seconds;
  const Stage_runner run{m_options.cut.observer, seconds};
  m_progress = [&](double done) { run.progress(Stage::PARAMETERIZE, done); };
  run(Stage::PARAMETERIZE, [&] {
    update_charts();
    // limbs first: where much is stretched, faces overlap that will not
    constexpr double much = 0.15;
    while (m_extends && excess() > much && extend(std::max(much, m_wanted))) {}
    do {
      divide();
    } while (m_extends && extend(m_wanted));
    map_charts();
    note("divided into " + std::to_string(m_charts.size()) + " charts");
    extend_further();
    divide_further();
    divide_wasteful();
    join_maps();
  });
  m_progress = {};
  m_result.cut.seconds.insert(m_result.cut.seconds.end(), seconds.begin(), seconds.end());
  check_cut("into charts");
  return std::move(m_result);
}

void Chart_divider::cut()
{
  m_result.cut = first_cut(m_root, m_options.seams, m_options);
  if (!is_automatic() || !m_options.seams.empty() || !completes_seams(m_options.cut)) { return; }
  // seams along sharp edges cost little where they are not longer than arcs would make it: what is between is all but
  // flat
  constexpr double sharp = 30 / 180. * 3.14159265358979, longer = 1.55;
  const double most = longer * m_result.cut.length;
  const std::vector<Index> edges = sharp_edges(sharp);
  if (edges.empty() || length_of_edges(m_root, edges) > most) { return; }
  Cut other = first_cut(m_root, edges, m_options);
  if (other.length <= most) { m_result.cut = std::move(other); }
}

std::vector<Index> Chart_divider::sharp_edges(double angle) const
{
  const auto is_kept_out = [&](Index h) { return !m_kept_out.empty() && m_kept_out[m_root.face(h)]; };
  std::vector<Index> edges;
  for (Index h = 0; h < m_root.number_of_halfedges(); ++h)
  {
    const Index o = m_root.opposite[h];
    if (o > h && !(is_kept_out(h) && is_kept_out(o)) && exterior_dihedral_angle(m_root, h) > angle)
    {
      edges.push_back(h);
    }
  }
  return edges;
}

std::vector<Plane_point> Chart_divider::joined_maps() const
{
  std::vector<Plane_point> at(m_result.disc.number_of_vertices(), {0, 0});
  for (const Chart& c : m_charts)
    for (std::size_t v = 0; v < c.piece.vertices.size(); ++v) { at[c.piece.vertices[v]] = c.map.at[v]; }
  return at;
}

void Chart_divider::update_charts(const std::vector<Plane_point>& drawn)
{
  m_result.disc = surface_of(m_result.cut.surface, m_result.cut.opened);
  std::map<Index, Chart> known; // by the first face
  for (Chart& c : m_charts)
  {
    const Index first = c.piece.faces.front();
    known.emplace(first, std::move(c));
  }
  m_charts.clear();
  for (Surface_piece& piece : pieces_of(m_result.disc))
  {
    const auto before = known.find(piece.faces.front());
    // the same faces have the same vertices, in the same order
    const bool is_known = before != known.end() && before->second.piece.faces == piece.faces
                          && before->second.piece.surface.triangles == piece.surface.triangles;
    if (is_known)
    {
      m_charts.push_back(std::move(before->second));
      m_charts.back().piece = std::move(piece);
      continue;
    }
    m_charts.emplace_back();
    m_charts.back().piece = std::move(piece);
    m_charts.back().area = area(m_charts.back().piece.surface);
    Chart& chart = m_charts.back();
    if (drawn.empty()) { unfold(chart); }
    else
    {
      for (Index v : chart.piece.vertices) { chart.unfolded.push_back(drawn[v]); }
      chart.excess = bounded_excess(chart.piece.surface, chart.unfolded);
    }
    m_progress(m_done); // for who wants to end the run
  }
}

void Chart_divider::unfold(Chart& chart) const
{
  const Triangle_surface& disc = chart.piece.surface;
  try
  {
    chart.unfolded = unfold_disc(disc, m_options.map.make_solver);
  }
  catch (const Solver_error&)
  {
    return; // then nothing is known before it is mapped
  }
  Overlaps overlaps = find_overlaps(disc, chart.unfolded, std::min(16384., 8. * disc.number_of_faces()));
  chart.apart = std::move(overlaps.faces);
  chart.overlap = overlaps.part;
  constexpr double more = 1.4; // times the excess of a map
  chart.excess = bounded_excess(disc, chart.unfolded) / more;
}

double Chart_divider::excess() const
{
  double sum = 0, whole = 0;
  for (const Chart& c : m_charts)
  {
    sum += c.area * c.excess;
    whole += c.area;
  }
  return whole > 0 ? sum / whole : 0;
}

bool Chart_divider::extend(double wanted)
{
  constexpr std::array<double, 3> boldness{1, 2, 4};
  return excess() > wanted
         && std::any_of(boldness.begin(), boldness.end(), [&](double b) { return extend(wanted, b); });
}

bool Chart_divider::extend(double wanted, double boldness)
{
  constexpr double farthest = 0.1; // at once
  const double now = excess();
  const auto goal = [&](double expected) {
    return std::sqrt(1 + (expected * expected - 1) * std::max(wanted / now, farthest) / boldness);
  };
  Extension_plan plan;
  try
  {
    plan = plan_extensions(m_result.disc, goal, m_options.extensions - m_result.extended, m_options.cut.solvers.laplace,
                           carry_kept_out(m_result.cut.surface, m_kept_out));
  }
  catch (const Solver_error&)
  {} // then it is divided
  if (plan.vertices.empty()) { return false; }
  State before = state();
  extend_cut(m_root, m_result.cut, plan.vertices, m_options.cut.on_edges, m_kept_out);
  update_charts();
  const double least = (now - wanted) / (m_kept_out.empty() ? 3 : 20); // around what is kept out of, there is no better
  if (now - excess() < least)                                          // it does not pay
  {
    return_to(std::move(before));
    return false;
  }
  m_result.extended += plan.vertices.size();
  return true;
}

void Chart_divider::extend_further()
{
  constexpr double nearly = 1.5; // times what is wanted
  const double now = excess();
  const bool is_near = now > m_wanted && now <= nearly * m_wanted;
  if (!m_extends || !is_automatic() || m_charts.size() > 1 || !is_near) { return; }
  State before = state();
  if (!extend(m_wanted)) { return; }
  map_charts();
  if (now - excess() < (now - m_wanted) / 3) { return_to(std::move(before)); }
  else { note("extended further"); }
}

void Chart_divider::return_to(State&& before)
{
  m_result.cut = std::move(before.cut);
  m_result.disc = surface_of(m_result.cut.surface, m_result.cut.opened);
  m_result.extended = before.extended;
  m_charts = std::move(before.charts);
}

std::vector<std::size_t> Chart_divider::most_needful() const
{
  std::vector<std::size_t> which;
  const double whole =
    std::accumulate(m_charts.begin(), m_charts.end(), 0., [](double sum, const Chart& c) { return sum + c.area; });
  for (std::size_t i = 0; i < m_charts.size(); ++i)
  {
    const Chart& c = m_charts[i];
    const bool overlaps = c.overlap > harmless_overlap && c.overlap * c.area > least_overlap * whole;
    if (!c.is_whole && (!is_automatic() || overlaps)) { which.push_back(i); }
  }
  if (is_automatic()) { return which; }
  const auto need = [&](std::size_t i) { return m_charts[i].area * (0.1 + m_charts[i].overlap + m_charts[i].excess); };
  std::stable_sort(which.begin(), which.end(), [&](std::size_t a, std::size_t b) { return need(a) > need(b); });
  const std::size_t missing = static_cast<std::size_t>(m_options.charts) - m_charts.size();
  // all at once would be of one size, whatever they need
  which.resize(std::min({which.size(), missing, std::max<std::size_t>(m_charts.size() / 4, 1)}));
  return which;
}

void Chart_divider::divide()
{
  while (is_automatic() || m_charts.size() < static_cast<std::size_t>(m_options.charts))
  {
    if (!divide(most_needful())) { return; }
  }
}

namespace {

// Whether an arc is an edge of the border: of discs of two or three faces that may be the shortest one.
bool is_on_border(const Triangle_surface& disc, const Surface_curve& arc)
{
  if (arc.points.size() != 2 || !arc.points[0].is_vertex() || !arc.points[1].is_vertex()) { return false; }
  const Index v = arc.points[0].vertex, w = arc.points[1].vertex, h = disc.find_halfedge(v, w);
  return h < 0 || disc.opposite[h] < 0;
}

} // namespace

bool Chart_divider::divide(const std::vector<std::size_t>& which)
{
  std::vector<Surface_curve> arcs;
  for (std::size_t i : which)
  {
    Chart& chart = m_charts[i];
    const auto carry_over = [&](Surface_curve a) {
      return carry_to_whole(chart.piece, m_result.cut.surface, m_result.cut.opened, std::move(a));
    };
    const auto is_good = [&](const Surface_curve& a) { return has_room(carry_over(a)); };
    const std::vector<char> kept_out = carry_kept_out(chart.piece, m_result.cut.surface, m_kept_out);
    const auto find = [&] {
      return find_arc(chart.piece.surface, chart.apart, m_options.cut.on_edges, is_good, kept_out);
    };
    Surface_curve arc = find();
    if (arc.points.empty() && !chart.apart.empty()) // what overlaps is too small to be parted
    {
      chart.apart.clear();
      arc = find();
    }
    chart.is_whole = arc.points.empty() || is_on_border(chart.piece.surface, arc);
    if (!chart.is_whole) { arcs.push_back(carry_over(std::move(arc))); }
  }
  if (arcs.empty()) { return false; }
  const bool has_maps = !m_charts.front().map.at.empty(); // all or none
  const Cut before = has_maps ? m_result.cut : Cut();
  const std::vector<Plane_point> at = has_maps ? joined_maps() : std::vector<Plane_point>();
  Insertion done = insert_curves(m_root, m_result.cut.surface, arcs);
  add_curves(m_result.cut, Curve_kind::ARC, std::move(done.vertices));
  open_cut(m_result.cut);
  const std::size_t charts = m_charts.size();
  update_charts(has_maps ? draw_curves(before, at, m_result.cut, done.parent) : std::vector<Plane_point>());
  return m_charts.size() > charts;
}

bool Chart_divider::has_room(const Surface_curve& arc) const
{
  const Refined_surface& s = m_result.cut.surface;
  return std::all_of(arc.points.begin(), arc.points.end(), [&](const Curve_point& p) {
    if (p.is_vertex()) { return true; }
    const Origin at = origin_on(m_root, s, p.halfedge, p.t);
    const Index face = s.face_of[s.face(p.halfedge)];
    const Point place = barycentric_in(m_root, face, at);
    const auto is_apart = [&](Index v) {
      constexpr double room = 1e-8; // of a face: enough for a few points more to be told apart
      const Point other = barycentric_in(m_root, face, s.origin(v));
      return norm(place - other) > room;
    };
    return is_apart(s.source(p.halfedge)) && is_apart(s.target(p.halfedge));
  });
}

void Chart_divider::map_charts()
{
  const bool is_free = improves_maps(m_options.map.method) && m_options.map.border == Map_border::FREE;
  double whole = 0, mapped = 0;
  for (const Chart& chart : m_charts) { whole += chart.area; }
  for (Chart& chart : m_charts)
  {
    mapped += chart.area;
    if (!chart.map.at.empty()) { continue; }
    const Triangle_surface& disc = chart.piece.surface;
    if (is_free && !chart.unfolded.empty() && is_good_start(disc, chart.unfolded))
    {
      chart.map = improve_map(disc, chart.unfolded, m_options.map);
    }
    if (!chart.map.is_one_to_one) { chart.map = parameterize_disc(disc, m_options.map); }
    chart.unfolded.clear();
    if (chart.overlap <= harmless_overlap) { chart.apart.clear(); } // what is short and even is better then
    const double stretch = chart.map.distortion.stretch_l2;
    chart.excess = chart.map.is_one_to_one ? stretch * stretch - 1 : bounded_excess(disc, chart.map.at);
    if (whole > 0) { m_done = std::max(m_done, std::min(mapped / whole, 1.)); }
    m_progress(m_done);
  }
}

void Chart_divider::divide_further()
{
  constexpr int rounds = 12;
  constexpr std::size_t many_faces = 35; // of the surface, for each chart
  constexpr double least_gain = 0.05;
  double part = 0.5; // of the excess of a chart that is lost when it is divided
  bool was_in_vain = false;
  for (int i = 0; i < rounds && is_automatic() && excess() > m_wanted; ++i)
  {
    const double before = excess();
    double at_stake = 0;
    const std::vector<std::size_t> which = most_stretched((before - m_wanted) / part, at_stake);
    if (!divide(which)) { return; }
    map_charts();
    note("divided into " + std::to_string(m_charts.size()) + " charts");
    // slivers may never be flat enough; but to halve a large chart once may gain nothing, and twice much
    const bool is_in_vain = before - excess() < least_gain * (before - m_wanted);
    if (is_in_vain && (was_in_vain || many_faces * m_charts.size() > m_root.triangles.size())) { return; }
    was_in_vain = is_in_vain;
    part = std::clamp((before - excess()) / at_stake, 0.1, 0.5);
  }
}

double Chart_divider::filled() const
{
  std::vector<meridian::Chart> packed;
  for (const Chart& c : m_charts) { packed.push_back({&c.piece.surface.triangles, c.map.at, c.area}); }
  Pack_options options;
  options.tries = 1; // about is enough
  return pack_charts(packed, options);
}

void Chart_divider::divide_wasteful()
{
  constexpr double longer = 1.25, worth = 0.08; // that seams may become; that e times as many charts must bring
  constexpr int patience = 4;
  constexpr std::size_t many = 100; // what is between so many is mostly padding
  if (!is_automatic() || !(m_options.filled > 0) || m_charts.size() >= many) { return; }
  const double length = m_result.cut.length;
  double best = filled();
  if (best >= m_options.filled) { return; }
  State best_state = state();
  int in_vain = 0;
  for (double now = best;
       now < m_options.filled && in_vain < patience && m_charts.size() < many && divide(most_wasteful()); ++in_vain)
  {
    if (m_result.cut.length > longer * length) { break; }
    map_charts();
    now = filled();
    const double more = static_cast<double>(m_charts.size()) / static_cast<double>(best_state.charts.size());
    if (now - best < worth * std::log(more)) { continue; }
    in_vain = -1;
    best = now;
    best_state = state();
  }
  return_to(std::move(best_state));
  note("divided into " + std::to_string(m_charts.size()) + " charts to fill the square");
}

std::vector<std::size_t> Chart_divider::most_wasteful() const
{
  std::vector<std::size_t> which;
  std::vector<double> waste; // of each chart
  for (std::size_t i = 0; i < m_charts.size(); ++i)
  {
    const Chart& c = m_charts[i];
    const double image = area_of(c.piece.surface.triangles, c.map.at);
    const auto [length, width] = sides_of_smallest_rectangle(c.map.at);
    // a long chart takes more than its rectangle
    waste.push_back(image > 0 ? c.area * (length * std::max(width, length / 4) / image - 1) : 0);
    if (!c.is_whole) { which.push_back(i); }
  }
  std::stable_sort(which.begin(), which.end(), [&](std::size_t a, std::size_t b) { return waste[a] > waste[b]; });
  which.resize(std::min(which.size(), std::max<std::size_t>(m_charts.size() / 4, 1)));
  return which;
}

std::vector<std::size_t> Chart_divider::most_stretched(double enough, double& sum) const
{
  std::vector<std::size_t> which;
  double whole = 0;
  for (std::size_t i = 0; i < m_charts.size(); ++i)
  {
    whole += m_charts[i].area;
    if (!m_charts[i].is_whole) { which.push_back(i); }
  }
  const auto share = [&](std::size_t i) { return m_charts[i].area * m_charts[i].excess / whole; };
  std::stable_sort(which.begin(), which.end(), [&](std::size_t a, std::size_t b) { return share(a) > share(b); });
  std::size_t count = 0;
  for (sum = 0; count < which.size() && sum < enough; ++count) { sum += share(which[count]); }
  which.resize(count);
  return which;
}

void Chart_divider::join_maps()
{
  Parameterization& all = m_result.map;
  all.at.assign(m_result.disc.points.size(), {0, 0});
  all.is_one_to_one = true;
  m_result.charts = m_charts.size();
  m_result.chart_of.assign(m_result.disc.number_of_faces(), 0);
  std::vector<double> scale;
  for (const Chart& c : m_charts)
  {
    const double image = area_of(c.piece.surface.triangles, c.map.at);
    scale.push_back(image > 0 && c.area > 0 ? std::sqrt(c.area / image) : 0);
  }
  const double largest = *std::max_element(scale.begin(), scale.end());
  const std::size_t side = static_cast<std::size_t>(std::ceil(std::sqrt(m_charts.size()))); // of a chessboard
  for (std::size_t i = 0; i < m_charts.size(); ++i)
  {
    const Chart& c = m_charts[i];
    all.is_one_to_one = all.is_one_to_one && c.map.is_one_to_one;
    if (all.attempts.size() < c.map.attempts.size()) // one that had to be mapped another way speaks for all
    {
      all.method = c.map.method;
      all.border = c.map.border;
      all.attempts = c.map.attempts;
    }
    for (Index f : c.piece.faces) { m_result.chart_of[f] = static_cast<Index>(i); }
    const std::size_t row = i / side;
    const Plane_point low{static_cast<double>(i % side), static_cast<double>(row)};
    const double field = static_cast<double>(side);
    const auto placed = [&](double size) {
      std::vector<Plane_point> at;
      for (const Plane_point& p : c.map.at) { at.push_back((1 / field) * (low + size * p)); }
      return at;
    };
    std::vector<Plane_point> at = placed(largest > 0 ? scale[i] / largest : 1);
    // so small that rounding would turn faces over
    if (find_flipped_faces(c.piece.surface.triangles, at).size() > c.map.flipped.size()) { at = placed(1); }
    for (std::size_t v = 0; v < at.size(); ++v) { all.at[c.piece.vertices[v]] = at[v]; }
  }
  const Triangle_surface& disc = m_result.disc;
  all.flipped = find_flipped_faces(disc.triangles, all.at);
  all.faces = measure_faces(disc.points, disc.triangles, all.at);
  all.distortion = measure_distortion(disc.points, disc.triangles, all.at, all.faces);
}

void Chart_divider::note(const std::string& name)
{
  const auto flipped = std::accumulate(m_charts.begin(), m_charts.end(), std::size_t(0),
                                       [](std::size_t sum, const Chart& c) { return sum + c.map.flipped.size(); });
  m_result.extensions.push_back({name, m_result.cut.length, std::sqrt(1 + excess()), m_charts.front().map.method,
                                 static_cast<Index>(flipped), true});
}

void Chart_divider::check_cut(const std::string& name) const
{
  const Verification recount = verify_charts(m_root, m_result.cut);
  if (!recount)
  {
    throw Internal_error("unwrap_surface: the recount of a cut " + name + " found " + recount.failures.front());
  }
}

} // namespace internal

} // namespace meridian
