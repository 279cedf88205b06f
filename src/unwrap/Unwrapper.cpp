// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/internal/Unwrapper.h>

#include <meridian/base/Progress_observer.h>
#include <meridian/base/Stage_runner.h>
#include <meridian/base/Verification.h>
#include <meridian/base/exceptions.h>
#include <meridian/cut/cut_to_disc.h>
#include <meridian/cut/keep_out.h>
#include <meridian/field/geodesic_distance.h>
#include <meridian/map/Parameterization.h>
#include <meridian/map/parameterize_disc.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/open_along.h>
#include <meridian/unwrap/carry_map.h>
#include <meridian/unwrap/cut_family.h>
#include <meridian/unwrap/extend_cut.h>
#include <meridian/unwrap/internal/first_cut.h>
#include <meridian/unwrap/plan_extensions.h>
#include <meridian/unwrap/square_border.h>

#include <algorithm>
#include <cmath>

namespace meridian {

namespace internal {

namespace {

// The same cut, without its map.
Unwrapping unmapped(const Unwrapping& u)
{
  Unwrapping other;
  other.cut = u.cut;
  other.extended = u.extended;
  return other;
}

} // namespace

Unwrapper::Unwrapper(const Triangle_surface& root, const Unwrap_options& options)
  : m_root(root), m_options(options), m_kept_out(kept_out_of(root, options)), m_area(area(root))
{
  // shorter seams stretch the map of a lattice by up to a tenth more
  if (!m_options.cut.tightening) { m_options.cut.tightening = Tightening::CURVES; }
  if (m_options.max_stretch && *m_options.max_stretch > 1)
  {
    constexpr double part = 0.02; // of what is wanted that a map may miss
    const double excess = *m_options.max_stretch * *m_options.max_stretch - 1;
    m_options.map.least_gain = std::min(m_options.map.least_gain, part * excess);
  }
}

Unwrapping Unwrapper::run()
{
  if (m_options.family == 1) { cut_and_map(); }
  else { search_family(); }
  if (m_options.stretch_weight > 0) { vary_links(); }
  extend();
  return std::move(m_best);
}

bool Unwrapper::may_unfold() const
{
  return improves_maps(m_options.map.method) && m_options.map.border == Map_border::FREE && m_options.image_size == 0;
}

bool Unwrapper::has_unfolded() const
{
  return improves_maps(m_best.map.method) && m_best.map.border == Map_border::FREE;
}

double Unwrapper::wanted_stretch() const
{
  // the functional of length and stretch has its own mind about longer cuts
  const double by_itself = m_options.stretch_weight > 0 ? 0 : default_max_stretch;
  const double wanted = m_options.max_stretch.value_or(by_itself);
  return wanted > 0 ? wanted : fair_stretch;
}

void Unwrapper::cut_and_map()
{
  m_chosen = m_options.cut;
  m_best.cut = first_cut(m_root, {}, m_options);
  std::vector<Index> vertices;
  if (may_unfold() && !(m_options.stretch_weight > 0))
  {
    const Stage_runner run{m_chosen.observer, m_best.cut.seconds};
    run(Stage::PARAMETERIZE, [&] {
      std::vector<Expectation> nothing;
      vertices = plan(surface_of(m_best.cut.surface, m_best.cut.opened), nothing, 1);
    });
  }
  if (vertices.empty())
  {
    map(m_best);
    return;
  }
  Unwrapping u;
  const std::vector<Index> parents = extend_best(vertices, u);
  map(u);
  if (!u.map.flipped.empty() || u.map.distortion.stretch_l2 > fair_stretch)
  {
    Unwrapping other = unmapped(u); // may be better if it goes on from the map of the cut that is not extended
    if (try_to_map(m_best).empty() && go_on_from_best(other, parents)
        && other.map.distortion.stretch_l2 < u.map.distortion.stretch_l2)
    {
      u = std::move(other);
    }
  }
  judge(name_of_extension(vertices), std::move(u), &Unwrapping::extensions, true);
}

std::vector<Index> Unwrapper::plan(const Triangle_surface& disc, std::vector<Expectation>& known, double boldness) const
{
  const auto excess = [](double stretch) { return stretch * stretch - 1; };
  // less than is needed, and more so if only a guess leads there; but no seam is wasted where the shortest are asked
  // for
  const double guess = m_options.max_stretch == 0. ? 1 : 0.7;
  const double wanted = excess(1 + (known.empty() ? guess : 0.95) * (wanted_stretch() - 1));
  const auto goal = [&](double expected) {
    double enough = wanted;
    if (!known.empty())
    {
      known.back().expected = excess(expected);
      const Expectation now = known.back();
      enough = now.expected * wanted / now.measured;
      if (known.size() > 1)
      {
        const Expectation last = known[known.size() - 2];
        const double slope = (last.measured - now.measured) / (last.expected - now.expected);
        if (slope > 0) { enough = std::min(enough, now.expected - (now.measured - wanted) / slope); }
      }
      enough =
        std::max(std::min(enough, now.expected / boldness), now.expected / (4 * boldness)); // not too far at once
    }
    return std::sqrt(1 + enough);
  };
  try
  {
    return plan_extensions(disc, goal, m_options.extensions - m_extended, m_chosen.solvers.laplace, kept_out_of_best())
      .vertices;
  }
  catch (const Solver_error&)
  {
    return {};
  }
}

void Unwrapper::map(Unwrapping& u)
{
  const Stage_runner run{m_options.cut.observer, u.cut.seconds};
  run(Stage::PARAMETERIZE, [&] {
    Map_options options = m_options.map;
    if (m_options.image_size > 0)
    {
      u.border = prepare_square_border(m_root, u.cut, m_options.image_size);
      options.border = Map_border::SQUARE;
      options.loop = u.border.loop;
      options.polygon = u.border.points;
    }
    else if (options.border == Map_border::SQUARE && !m_options.cut.on_edges) { divide_border_chords(m_root, u.cut); }
    u.disc = surface_of(u.cut.surface, u.cut.opened);
    u.map = parameterize_disc(u.disc, options, [&](double done) { run.progress(Stage::PARAMETERIZE, done); });
  });
}

std::string Unwrapper::try_to_map(Unwrapping& u)
{
  try
  {
    map(u);
  }
  catch (const Invalid_input_error& e)
  {
    return e.what();
  }
  catch (const Solver_error& e)
  {
    return e.what();
  }
  return "";
}

double Unwrapper::cost(const Unwrapping& u) const
{
  const double w = m_options.stretch_weight, length = m_area > 0 ? u.cut.length / std::sqrt(m_area) : u.cut.length;
  return w > 0 ? (1 - w) * length + w * u.map.distortion.stretch_l2 : length;
}

bool Unwrapper::is_worthwhile(const Unwrapping& u) const
{
  const std::size_t flips = u.map.flipped.size(), flips_before = m_best.map.flipped.size();
  if (flips != flips_before) { return flips < flips_before; }
  const double before = m_best.map.distortion.stretch_l2, gain = before - u.map.distortion.stretch_l2;
  constexpr double least = 1. / 20;
  return gain > least * (before - wanted_stretch());
}

void Unwrapper::take(Unwrapping&& u)
{
  u.members = std::move(m_best.members);
  u.variations = std::move(m_best.variations);
  u.extensions = std::move(m_best.extensions);
  m_best = std::move(u);
}

bool Unwrapper::judge(const std::string& name, Unwrapping&& u, Steps steps, bool is_good)
{
  (m_best.*steps)
    .push_back({name, u.cut.length, u.map.distortion.stretch_l2, u.map.method, static_cast<Index>(u.map.flipped.size()),
                is_good});
  if (is_good) { take(std::move(u)); }
  return is_good;
}

bool Unwrapper::note_failure(const std::string& name, const Unwrapping& u, Steps steps, const std::string& reason)
{
  (m_best.*steps).push_back({name, u.cut.length, 0, m_options.map.method, -1, false, reason});
  return false;
}

void Unwrapper::check_cut(const std::string& name, const Unwrapping& u) const
{
  const Verification recount = verify_cut(m_root, u.cut);
  if (recount) { return; }
  throw Internal_error("unwrap_surface: the recount of a cut " + name + " found " + recount.failures.front());
}

void Unwrapper::search_family()
{
  Cut_family family(m_root, m_options.family, m_options.cut);
  while (auto member = family.next())
  {
    Unwrapping u;
    u.cut = std::move(member->cut);
    const std::string failure = try_to_map(u);
    if (!failure.empty()) { note_failure(member->name, u, &Unwrapping::members, failure); }
    else
    {
      const bool is_good = m_best.map.at.empty() || is_better(u);
      if (judge(member->name, std::move(u), &Unwrapping::members, is_good)) { m_chosen = member->options; }
    }
  }
  if (m_best.map.at.empty()) { throw Solver_error("no cut of the family has a map: " + m_best.members.back().reason); }
}

void Unwrapper::vary_links()
{
  const bool has_links = !cuts_edges(m_chosen.method) && m_chosen.tightening != Tightening::GRAPH;
  for (bool goes_on = true; goes_on && static_cast<int>(m_best.variations.size()) < m_options.extensions;)
  {
    goes_on = false;
    if (has_links && !m_chosen.on_edges)
    {
      Cut_options other = m_chosen;
      other.links.bifurcations = !other.links.bifurcations;
      goes_on = try_links(other.links.bifurcations ? "with bifurcations" : "without bifurcations", other);
    }
    const auto peaks = find_stretched_vertices(m_best.disc, m_best.map, 3);
    for (std::size_t i = 0; i < peaks.size() && has_links && !goes_on; ++i)
    {
      if (peaks[i] >= m_root.number_of_vertices()) { continue; }
      Cut_options other = m_chosen;
      other.links.source = peaks[i];
      goes_on = try_links("through vertex " + std::to_string(peaks[i]), other);
    }
    for (std::size_t i = 0; i < peaks.size() && !goes_on; ++i) { goes_on = try_extension({peaks[i]}); }
  }
}

bool Unwrapper::try_links(const std::string& name, const Cut_options& options)
{
  Unwrapping u;
  try
  {
    u.cut = cut_to_disc(m_root, options);
  }
  catch (const Invalid_input_error&)
  {
    return false; // these links do not suit the surface
  }
  check_cut(name, u);
  if (!try_variation(name, std::move(u))) { return false; }
  m_chosen = options;
  return true;
}

bool Unwrapper::try_extension(const std::vector<Index>& vertices)
{
  Unwrapping u;
  extend_best(vertices, u);
  return try_variation(name_of_extension(vertices), std::move(u));
}

bool Unwrapper::try_variation(const std::string& name, Unwrapping&& u)
{
  const std::string failure = try_to_map(u);
  if (!failure.empty()) { return note_failure(name, u, &Unwrapping::variations, failure); }
  const bool is_good = is_better(u);
  return judge(name, std::move(u), &Unwrapping::variations, is_good);
}

bool Unwrapper::is_useless() const
{
  return !m_best.map.flipped.empty() || (has_unfolded() && m_best.map.distortion.stretch_l2 > useless_stretch);
}

void Unwrapper::extend()
{
  constexpr int rounds = 8;
  constexpr std::size_t at_once = 4;
  const auto may_go_on = [&] { return m_extended < static_cast<std::size_t>(m_options.extensions); };
  while (may_go_on() && is_useless() && extend_to_useless()) {}
  if (!may_unfold() && m_options.max_stretch)
  {
    extend_one_by_one();
    return;
  }
  std::vector<Expectation> known;
  double boldness = 1;
  for (int i = 0; i < rounds && may_go_on() && may_unfold() && has_unfolded(); ++i)
  {
    const double stretch = m_best.map.distortion.stretch_l2;
    if (!(stretch > wanted_stretch())) { break; }
    known.push_back({0, stretch * stretch - 1});
    if (extend_to(plan(m_best.disc, known, boldness))) { continue; }
    if (m_options.max_stretch && boldness < 4) // it was not enough to see a gain
    {
      known.pop_back();
      boldness *= 2;
      continue;
    }
    // otherwise to the regions of highest stretch
    const bool is_hopeless = stretch < fair_stretch && !m_options.max_stretch;
    if (is_hopeless || !extend_to(stretched_vertices(at_once))) { break; }
  }
}

std::vector<Index> Unwrapper::extend_best(const std::vector<Index>& vertices, Unwrapping& u)
{
  u.cut = m_best.cut;
  std::vector<Index> parents = extend_cut(m_root, u.cut, vertices, m_chosen.on_edges, m_kept_out);
  check_cut(name_of_extension(vertices), u);
  u.extended = m_best.extended + vertices.size();
  m_extended += vertices.size();
  return parents;
}

std::vector<char> Unwrapper::kept_out_of_best() const { return carry_kept_out(m_best.cut.surface, m_kept_out); }

std::vector<Index> Unwrapper::stretched_vertices(std::size_t most) const
{
  const std::vector<char> inside = vertices_inside(m_best.disc, kept_out_of_best());
  std::vector<Index> peaks = find_stretched_vertices(m_best.disc, m_best.map, inside.size());
  peaks.erase(std::remove_if(peaks.begin(), peaks.end(), [&](Index v) { return inside[v]; }), peaks.end());
  if (peaks.size() > most) { peaks.resize(most); }
  return peaks;
}

void Unwrapper::extend_one_by_one()
{
  const auto may_go_on = [&] {
    return m_extended < static_cast<std::size_t>(m_options.extensions)
           && m_best.map.distortion.stretch_l2 > wanted_stretch();
  };
  for (bool goes_on = true; goes_on && may_go_on();)
  {
    goes_on = false;
    const auto peaks = stretched_vertices(4);
    for (std::size_t i = 0; i < peaks.size() && !goes_on; ++i) { goes_on = extend_to({peaks[i]}); }
  }
}

bool Unwrapper::extend_to(const std::vector<Index>& vertices)
{
  if (vertices.empty()) { return false; }
  Unwrapping u;
  const std::vector<Index> parents = extend_best(vertices, u);
  const std::string name = name_of_extension(vertices);
  const bool goes_on = go_on_from_best(u, parents);
  // what is asked for below the default is worth both ways, unless one of them comes near it
  const double before = m_best.map.distortion.stretch_l2, wanted = wanted_stretch();
  const auto is_enough = [&] {
    const double after = u.map.distortion.stretch_l2;
    return after < fair_stretch && (wanted >= default_max_stretch || before - after > (before - wanted) / 2);
  };
  if (!goes_on || !is_worthwhile(u) || !is_enough())
  {
    Unwrapping other = unmapped(u); // may be better from the beginning
    const std::string failure = try_to_map(other);
    if (!goes_on && !failure.empty()) { return note_failure(name, u, &Unwrapping::extensions, failure); }
    const bool is_better =
      failure.empty() && other.map.flipped.empty() && other.map.distortion.stretch_l2 < u.map.distortion.stretch_l2;
    if (!goes_on || is_better) { u = std::move(other); }
  }
  const bool is_good = is_worthwhile(u);
  return judge(name, std::move(u), &Unwrapping::extensions, is_good);
}

bool Unwrapper::extend_to_useless()
{
  Unwrapping u;
  u.cut = m_best.cut;
  std::vector<char> is_marked(u.cut.surface.number_of_vertices(), 0);
  const std::vector<char> inside = vertices_inside(m_best.disc, kept_out_of_best());
  for (std::size_t f = 0; f < m_best.map.faces.size(); ++f)
    for (Index v : m_best.disc.triangles[f])
      if (!(m_best.map.faces[f].stretch_l2 < 10 * useless_stretch) && !m_best.disc.is_boundary_vertex(v) && !inside[v])
      {
        is_marked[v] = 1;
      }
  std::size_t extended = 0;
  for (double first = 0; extended < 16; ++extended)
  {
    const Triangle_surface disc = surface_of(u.cut.surface, u.cut.opened);
    const Closed_model g = make_closed_model(disc);
    const auto depth = edge_distances(g, edge_lengths(disc, g), g.first_loop_node);
    Index deepest = -1;
    for (Index v = 0; v < static_cast<Index>(is_marked.size()); ++v)
      if (is_marked[v] && !disc.is_boundary_vertex(v) && (deepest < 0 || depth[g.node[v]] > depth[g.node[deepest]]))
      {
        deepest = v;
      }
    if (deepest < 0 || depth[g.node[deepest]] < first / 4) { break; }
    if (extended == 0) { first = depth[g.node[deepest]]; }
    extend_cut(m_root, u.cut, {deepest}, m_chosen.on_edges, m_kept_out);
  }
  if (extended == 0) { return false; }
  u.extended = m_best.extended + extended;
  m_extended += extended;
  const std::string name =
    "extended to " + std::to_string(extended) + " vertices of faces that were flipped or all but vanished";
  check_cut(name, u);
  const std::string failure = try_to_map(u);
  if (!failure.empty()) { return note_failure(name, u, &Unwrapping::extensions, failure); }
  const bool is_good = is_worthwhile(u);
  return judge(name, std::move(u), &Unwrapping::extensions, is_good);
}

bool Unwrapper::go_on_from_best(Unwrapping& u, const std::vector<Index>& parents)
{
  if (!may_unfold() || !m_best.map.is_one_to_one) { return false; }
  const Stage_runner run{m_options.cut.observer, u.cut.seconds};
  bool is_done = false;
  run(Stage::PARAMETERIZE, [&] {
    Triangle_surface disc = surface_of(u.cut.surface, u.cut.opened);
    std::vector<Plane_point> at = carry_map(m_best.cut, m_best.map.at, u.cut, disc, parents);
    if (at.empty()) { return; }
    Parameterization map =
      improve_map(disc, std::move(at), m_options.map, [&](double done) { run.progress(Stage::PARAMETERIZE, done); });
    if (!map.is_one_to_one) { return; }
    u.disc = std::move(disc);
    u.map = std::move(map);
    is_done = true;
  });
  return is_done;
}

std::string Unwrapper::name_of_extension(const std::vector<Index>& vertices)
{
  constexpr std::size_t few = 8;
  std::string name = vertices.size() == 1 ? "extended to vertex" : "extended to vertices";
  for (std::size_t i = 0; i < vertices.size() && i < few; ++i)
  {
    name += (i > 0 ? ", " : " ") + std::to_string(vertices[i]);
  }
  return vertices.size() > few ? name + " and " + std::to_string(vertices.size() - few) + " more" : name;
}

} // namespace internal

} // namespace meridian
