// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_INTERNAL_UNWRAPPER_H
#define MERIDIAN_UNWRAP_INTERNAL_UNWRAPPER_H

#include <meridian/base/Verification.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/field/geodesic_distance.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/open_along.h>
#include <meridian/unwrap/Unwrapping.h>
#include <meridian/unwrap/extend_cut.h>

#include <string>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

class Unwrapper
{
public:
  Unwrapper(const Triangle_surface& root, const Unwrap_options& options)
    : m_root(root), m_options(options), m_area(area(root))
  {
    // shorter seams stretch the map of a lattice by up to a tenth more
    if (!m_options.cut.tightening) { m_options.cut.tightening = Tightening::CURVES; }
  }

  Unwrapping run();

private:
  void map(Unwrapping& u);

  // The same for one of several. Returns why it has no map, or nothing.
  std::string try_to_map(Unwrapping& u);

  double cost(const Unwrapping& u) const;
  // Fewer flipped faces first, then the lower cost.
  bool is_better(const Unwrapping& a, const Unwrapping& b) const
  {
    return std::make_pair(a.map.flipped.size(), cost(a)) < std::make_pair(b.map.flipped.size(), cost(b));
  }

  static Unwrap_step describe(const std::string& name, const Unwrapping& u, bool is_taken);

  // Takes over an unwrapping, but keeps the record of the search.
  void take(Unwrapping&& u);

  void search_family();

  // Other links between the same meridians, as long as one of them is better.
  void vary_links();

  // Whether the best map is of the kind that unfolds what a cut lets unfold.
  bool could_unfold() const;

  // Whether it is of no use: faces are flipped, or a part of the surface shrank to almost nothing in a map that could
  // unfold.
  bool is_useless() const;

  // Goes on from the best map, whose cut was extended to that of `u`. Returns whether there is a map then.
  bool go_on_from_best(Unwrapping& u, const std::vector<Index>& parents);

  // To such parts as long as there are some, then to the regions of highest stretch (Gu, Gortler, Hoppe 2002): to
  // several at once while it is not fair, and one by one while it is more than was asked for.
  void extend();

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
  bool extend_to(const std::vector<Index>& vertices, std::vector<Unwrap_step>& record, const Is_progress& is_progress,
                 bool goes_on)
  {
    Unwrapping u;
    u.cut = m_best.cut;
    std::vector<Index> parents;
    std::string name;
    for (Index v : vertices)
    {
      bool is_reached = false; // by the path to one before it
      u.cut.surface.for_each_outgoing(v, [&](Index h) { is_reached = is_reached || u.cut.surface.seam[h]; });
      if (is_reached) { continue; }
      const auto more = extend_cut(m_root, u.cut, v, m_chosen.on_edges);
      parents.insert(parents.end(), more.begin(), more.end());
      name += (name.empty() ? "extended to vertex " : ", ") + std::to_string(v);
    }
    if (u.cut.curves.size() == m_best.cut.curves.size()) { return false; }
    const bool has_map = goes_on && go_on_from_best(u, parents);
    return judge(name, std::move(u), record, is_progress, has_map);
  }

  // Recounts a cut, maps it, and takes it if it is better. The record is part of the best.
  template <class Is_progress>
  bool judge(const std::string& name, Unwrapping&& u, std::vector<Unwrap_step>& record, const Is_progress& is_progress,
             bool has_map = false)
  {
    const Verification recount = verify_cut(m_root, u.cut);
    if (!recount)
    {
      throw Internal_error("unwrap_surface: the recount of a cut " + name + " found " + recount.failures.front());
    }
    const std::string failure = has_map ? "" : try_to_map(u);
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

  static constexpr double useless_stretch = 100, fair_stretch = 2;
  const Triangle_surface& m_root;
  Unwrap_options m_options;
  const double m_area;
  Cut_options m_chosen;
  Unwrapping m_best;
};

} // namespace internal

} // namespace meridian

#endif // MERIDIAN_UNWRAP_INTERNAL_UNWRAPPER_H
