// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/internal/Unwrapper.h>

#include <meridian/base/Progress_observer.h>
#include <meridian/base/Stage_runner.h>
#include <meridian/cut/cut_to_disc.h>
#include <meridian/map/Parameterization.h>
#include <meridian/map/parameterize_disc.h>
#include <meridian/unwrap/carry_map.h>
#include <meridian/unwrap/cut_family.h>
#include <meridian/unwrap/square_border.h>

#include <cmath>

namespace meridian {

namespace internal {

Unwrapping Unwrapper::run()
{
  if (m_options.family == 1)
  {
    Unwrapping first;
    first.cut = cut_to_disc(m_root, m_options.cut);
    m_chosen = m_options.cut;
    map(first);
    m_best = std::move(first);
  }
  else { search_family(); }
  if (m_options.stretch_weight > 0) { vary_links(); }
  extend();
  return std::move(m_best);
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

Unwrap_step Unwrapper::describe(const std::string& name, const Unwrapping& u, bool is_taken)
{
  return {name,    u.cut.length, u.map.distortion.stretch_l2, u.map.method, static_cast<Index>(u.map.flipped.size()),
          is_taken};
}

void Unwrapper::take(Unwrapping&& u)
{
  u.members = std::move(m_best.members);
  u.variations = std::move(m_best.variations);
  u.extensions = std::move(m_best.extensions);
  m_best = std::move(u);
}

void Unwrapper::search_family()
{
  Cut_family family(m_root, m_options.family, m_options.cut);
  while (auto member = family.next())
  {
    Unwrapping u;
    u.cut = std::move(member->cut);
    const std::string failure = try_to_map(u);
    if (!failure.empty())
    {
      m_best.members.push_back({member->name, u.cut.length, 0, m_options.map.method, -1, false, failure});
      continue;
    }
    const bool is_first = m_best.map.at.empty(), is_taken = is_first || is_better(u, m_best);
    m_best.members.push_back(describe(member->name, u, is_taken));
    if (!is_taken) { continue; }
    m_chosen = member->options;
    take(std::move(u));
  }
  if (m_best.map.at.empty()) { throw Solver_error("no cut of the family has a map: " + m_best.members.back().reason); }
}

void Unwrapper::vary_links()
{
  const bool has_links = !cuts_edges(m_chosen.method) && m_chosen.tightening != Tightening::GRAPH;
  for (bool goes_on = true; goes_on && static_cast<int>(m_best.variations.size()) < m_options.extensions;)
  {
    goes_on = false;
    std::vector<std::pair<std::string, Cut_options>> choices;
    if (has_links && !m_chosen.on_edges)
    {
      choices.emplace_back(m_chosen.links.bifurcations ? "without bifurcations" : "with bifurcations", m_chosen);
      choices.back().second.links.bifurcations = !m_chosen.links.bifurcations;
    }
    const auto peaks = find_stretched_vertices(m_best.disc, m_best.map, 3);
    for (Index v : peaks)
      if (has_links && v < m_root.number_of_vertices())
      {
        choices.emplace_back("through vertex " + std::to_string(v), m_chosen);
        choices.back().second.links.source = v;
      }
    for (const auto& [name, options] : choices)
    {
      Unwrapping u;
      try
      {
        u.cut = cut_to_disc(m_root, options);
      }
      catch (const Invalid_input_error&)
      {
        continue;
      } // these links do not suit the surface
      goes_on =
        judge(name, std::move(u), m_best.variations, [&](const Unwrapping& tried) { return is_better(tried, m_best); });
      if (!goes_on) { continue; }
      m_chosen = options;
      break;
    }
    for (std::size_t i = 0; i < peaks.size() && !goes_on; ++i)
      goes_on = extend_to(
        {peaks[i]}, m_best.variations, [&](const Unwrapping& tried) { return is_better(tried, m_best); }, false);
  }
}

bool Unwrapper::could_unfold() const
{
  return m_best.map.method == Map_method::SYMMETRIC_DIRICHLET && m_best.map.border == Map_border::FREE;
}

bool Unwrapper::is_useless() const
{
  return !m_best.map.flipped.empty() || (could_unfold() && m_best.map.distortion.stretch_l2 > useless_stretch);
}

bool Unwrapper::go_on_from_best(Unwrapping& u, const std::vector<Index>& parents)
{
  if (!could_unfold() || !m_best.map.is_one_to_one || m_options.image_size > 0) { return false; }
  const Stage_runner run{m_options.cut.observer, u.cut.seconds};
  run(Stage::PARAMETERIZE, [&] {
    u.disc = surface_of(u.cut.surface, u.cut.opened);
    std::vector<Plane_point> at = carry_map(m_best.cut, m_best.map.at, u.cut, u.disc, parents);
    if (at.empty()) { return; }
    u.map =
      improve_map(u.disc, std::move(at), m_options.map, [&](double done) { run.progress(Stage::PARAMETERIZE, done); });
  });
  return u.map.is_one_to_one;
}

void Unwrapper::extend()
{
  const auto is_progress = [&](const Unwrapping& u) {
    return std::make_pair(u.map.flipped.size(), u.map.distortion.stretch_l2)
           < std::make_pair(m_best.map.flipped.size(), m_best.map.distortion.stretch_l2);
  };
  const auto may_go_on = [&] { return static_cast<int>(m_best.extensions.size()) < m_options.extensions; };
  for (bool goes_on = true; goes_on && may_go_on() && is_useless();) { goes_on = extend_to_useless(is_progress); }
  constexpr int rounds = 8;
  constexpr std::size_t at_once = 4;
  for (int i = 0; i < rounds && could_unfold() && may_go_on() && m_best.map.distortion.stretch_l2 > fair_stretch; ++i)
  {
    const auto peaks = find_stretched_vertices(m_best.disc, m_best.map, at_once);
    if (!extend_to(peaks, m_best.extensions, is_progress, true)) { break; }
  }
  for (bool goes_on = true;
       goes_on && may_go_on() && m_options.max_stretch > 0 && m_best.map.distortion.stretch_l2 > m_options.max_stretch;)
  {
    goes_on = false;
    const auto peaks = find_stretched_vertices(m_best.disc, m_best.map, 4);
    for (std::size_t i = 0; i < peaks.size() && !goes_on; ++i)
    {
      goes_on = extend_to({peaks[i]}, m_best.extensions, is_progress, false);
    }
  }
}

} // namespace internal

} // namespace meridian
