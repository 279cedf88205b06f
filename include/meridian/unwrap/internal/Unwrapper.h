// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_INTERNAL_UNWRAPPER_H
#define MERIDIAN_UNWRAP_INTERNAL_UNWRAPPER_H

#include <meridian/base/Stage_runner.h>
#include <meridian/cut/cut_to_disc.h>
#include <meridian/map/parameterize_disc.h>
#include <meridian/result/recount.h>
#include <meridian/unwrap/Unwrapping.h>
#include <meridian/unwrap/cut_family.h>
#include <meridian/unwrap/extend_cut.h>

namespace meridian {

namespace internal {

class Unwrapper
{
public:
  Unwrapper(const Triangle_surface& root, const Unwrap_options& options)
    : m_root(root), m_options(options), m_area(area(root))
  {}

  Unwrapping run()
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

private:
  void map(Unwrapping& u)
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
      options.progress = [&](double done) { run.progress(Stage::PARAMETERIZE, done); };
      u.map = parameterize_disc(u.disc, options);
    });
  }

  // The same for one of several. Returns why it has no map, or nothing.
  std::string try_to_map(Unwrapping& u)
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

  double cost(const Unwrapping& u) const
  {
    const double w = m_options.stretch_weight, length = m_area > 0 ? u.cut.length / std::sqrt(m_area) : u.cut.length;
    return w > 0 ? (1 - w) * length + w * u.map.distortion.stretch_l2 : length;
  }
  // Fewer flipped faces first, then the lower cost.
  bool is_better(const Unwrapping& a, const Unwrapping& b) const
  {
    return std::make_pair(a.map.flipped.size(), cost(a)) < std::make_pair(b.map.flipped.size(), cost(b));
  }

  static Unwrap_step describe(const std::string& name, const Unwrapping& u, bool is_taken)
  {
    return {name,    u.cut.length, u.map.distortion.stretch_l2, u.map.method, static_cast<Index>(u.map.flipped.size()),
            is_taken};
  }

  // Takes over an unwrapping, but keeps the record of the search.
  void take(Unwrapping&& u)
  {
    u.members = std::move(m_best.members);
    u.variations = std::move(m_best.variations);
    u.extensions = std::move(m_best.extensions);
    m_best = std::move(u);
  }

  void search_family()
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
    if (m_best.map.at.empty())
    {
      throw Solver_error("no cut of the family has a map: " + m_best.members.back().reason);
    }
  }

  // Other links between the same meridians, as long as one of them is better.
  void vary_links()
  {
    const bool has_links = m_chosen.method != Cut_method::TREE_COTREE && m_chosen.method != Cut_method::GEOMETRY_IMAGE
                           && m_chosen.tightening != Tightening::GRAPH;
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
        goes_on = judge(name, std::move(u), m_best.variations,
                        [&](const Unwrapping& tried) { return is_better(tried, m_best); });
        if (!goes_on) { continue; }
        m_chosen = options;
        break;
      }
      for (std::size_t i = 0; i < peaks.size() && !goes_on; ++i)
        goes_on =
          extend_to(peaks[i], m_best.variations, [&](const Unwrapping& tried) { return is_better(tried, m_best); });
    }
  }

  // Whether a map is of no use: faces are flipped, or a part of the surface shrank to almost nothing in a map that
  // could have avoided it.
  bool is_useless() const
  {
    const bool could_unfold =
      m_best.map.method == Map_method::SYMMETRIC_DIRICHLET && m_best.map.border == Map_border::FREE;
    return !m_best.map.flipped.empty() || (could_unfold && m_best.map.distortion.stretch_l2 > useless_stretch);
  }

  // To such parts as long as there are some, then to the regions of highest stretch (Gu, Gortler, Hoppe 2002).
  void extend()
  {
    const auto is_progress = [&](const Unwrapping& u) {
      return std::make_pair(u.map.flipped.size(), u.map.distortion.stretch_l2)
             < std::make_pair(m_best.map.flipped.size(), m_best.map.distortion.stretch_l2);
    };
    const auto may_go_on = [&] { return static_cast<int>(m_best.extensions.size()) < m_options.extensions; };
    for (bool goes_on = true; goes_on && may_go_on() && is_useless();) { goes_on = extend_to_useless(is_progress); }
    for (bool goes_on = true; goes_on && may_go_on() && m_options.max_stretch > 0
                              && m_best.map.distortion.stretch_l2 > m_options.max_stretch;)
    {
      goes_on = false;
      const auto peaks = find_stretched_vertices(m_best.disc, m_best.map, 4);
      for (std::size_t i = 0; i < peaks.size() && !goes_on; ++i)
      {
        goes_on = extend_to(peaks[i], m_best.extensions, is_progress);
      }
    }
  }

  // To some vertices of faces that are flipped or all but vanish: each time to the one deepest inside the disc, until
  // none is a quarter as deep as the first.
  template <class Is_progress> bool extend_to_useless(const Is_progress& is_progress)
  {
    Unwrapping u;
    u.cut = m_best.cut;
    std::vector<char> is_marked(u.cut.surface.number_of_vertices(), 0);
    for (std::size_t f = 0; f < m_best.map.faces.size(); ++f)
      for (Index v : m_best.disc.triangles[f])
        if (!(m_best.map.faces[f].stretch_l2 < 10 * useless_stretch) && !m_best.disc.is_boundary_vertex(v))
        {
          is_marked[v] = 1;
        }
    int extended = 0;
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
      extend_cut(m_root, u.cut, deepest, m_chosen.on_edges);
    }
    return extended > 0
           && judge("extended to " + std::to_string(extended)
                      + " vertices of faces that were flipped or all but vanished",
                    std::move(u), m_best.extensions, is_progress);
  }

  template <class Is_progress>
  bool extend_to(Index vertex, std::vector<Unwrap_step>& record, const Is_progress& is_progress)
  {
    Unwrapping u;
    u.cut = m_best.cut;
    extend_cut(m_root, u.cut, vertex, m_chosen.on_edges);
    return judge("extended to vertex " + std::to_string(vertex), std::move(u), record, is_progress);
  }

  // Recounts a cut, maps it, and takes it if it is better. The record is part of the best.
  template <class Is_progress>
  bool judge(const std::string& name, Unwrapping&& u, std::vector<Unwrap_step>& record, const Is_progress& is_progress)
  {
    const Verification recount = verify_cut(m_root, u.cut);
    if (!recount)
    {
      throw Internal_error("unwrap_surface: the recount of a cut " + name + " found " + recount.failures.front());
    }
    const std::string failure = try_to_map(u);
    if (!failure.empty())
    {
      record.push_back({name, u.cut.length, 0, m_options.map.method, -1, false, failure});
      return false;
    }
    const bool is_taken = is_progress(u);
    record.push_back(describe(name, u, is_taken));
    if (is_taken) { take(std::move(u)); }
    return is_taken;
  }

  static constexpr double useless_stretch = 100;
  const Triangle_surface& m_root;
  const Unwrap_options& m_options;
  const double m_area;
  Cut_options m_chosen;
  Unwrapping m_best;
};

} // namespace internal

} // namespace meridian

#endif // MERIDIAN_UNWRAP_INTERNAL_UNWRAPPER_H
