// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/cut_family.h>

#include <meridian/base/Verification.h>
#include <meridian/base/exceptions.h>
#include <meridian/cut/cut_to_disc.h>
#include <meridian/field/eigenfunctions.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/measures.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace meridian {

Cut_family::Cut_family(const Triangle_surface& root, int size, const Cut_options& options)
  : m_root(root), m_size(size), m_options(options)
{
  const Closed_model g = make_closed_model(root);
  const auto [a, b] = find_distant_nodes(root, g);
  m_spread = {a, b};
  m_distance = edge_distances(g, edge_lengths(root, g), a);
  spread_to(g, b);
  m_graph = std::make_unique<Closed_model>(g);
}

std::optional<Family_member> Cut_family::next()
{
  constexpr int patience = 24; // choices in a row that give nothing new
  for (int vain = 0; m_found < m_size && vain < patience; ++vain)
  {
    Family_member member;
    member.options = m_options;
    const int choice = m_choice++;
    try
    {
      member.name = choose(choice, member.options);
      member.cut = cut_to_disc(m_root, member.options);
    }
    catch (const Invalid_input_error&)
    {
      if (choice == 0) { throw; }
      continue; // a choice that does not suit this surface
    }
    if (!m_known.insert(seam_points(member.cut)).second) { continue; }
    const Verification recount = verify_cut(m_root, member.cut);
    if (!recount)
    {
      throw Internal_error("Cut_family: the recount of " + member.name + " found " + recount.failures.front());
    }
    ++m_found;
    return member;
  }
  return {};
}

namespace {

std::string name_contours(Cut_options& o, const std::string& name)
{
  o = with_method(std::move(o), Cut_method::CONTOURS);
  return name;
}

// Contours of an eigenfunction.
std::string choose_eigenfunction(const Triangle_surface& root, int k, Cut_options& o)
{
  o.values = eigenfunction_field(root, k);
  o.values_name = "eigenfunction " + std::to_string(k);
  o.minima.clear();
  o.maxima.clear();
  return name_contours(o, o.values_name);
}

void choose_short_and_tight(Cut_options& o)
{
  o.preference = preference::short_length;
  o.levels = Levels::TIGHT;
}

// Contours of a harmonic field between two vertices.
void choose_ends(Index minimum, Index maximum, Cut_options& o)
{
  o.minima = {minimum};
  o.maxima = {maximum};
  o.values.clear();
  choose_short_and_tight(o);
}

int genus_of(const Triangle_surface& root)
{
  return (2 - (root.number_of_vertices() - root.number_of_edges() + root.number_of_faces())
          - static_cast<int>(boundary_loops(root).size()))
         / 2;
}

} // namespace

std::string Cut_family::choose(int i, Cut_options& o)
{
  switch (i)
  {
  case 0: return "as chosen";
  case 1: choose_short_and_tight(o); return name_contours(o, "harmonic, short and tight");
  case 2: o = with_method(std::move(o), Cut_method::TREE_COTREE); return "tree-cotree";
  case 3: o = with_method(std::move(o), Cut_method::GEODESIC); return "geodesic";
  case 4: o = with_method(std::move(o), Cut_method::GEOMETRY_IMAGE); return "geometry-image";
  case 5: return choose_eigenfunction(m_root, genus_of(m_root) + 1, o);
  case 6: o = with_method(std::move(o), Cut_method::GENERATORS); return "generators";
  case 7: o = with_method(std::move(o), Cut_method::MORSE); return "morse";
  case 8:
  {
    const auto [a, b] = find_curved_vertices(m_root);
    choose_ends(a, b, o);
    return name_contours(o, "harmonic between curved vertices");
  }
  case 9: o.preference = preference::mean_curvature; return name_contours(o, "harmonic, mean curvature");
  case 10: choose_short_and_tight(o); return choose_eigenfunction(m_root, 1, o);
  case 11:
    o.links.bifurcations = true;
    choose_short_and_tight(o);
    return name_contours(o, "harmonic, with bifurcations");
  default: break;
  }
  const auto [v, w] = spread_pair(i - 12);
  choose_ends(v, w, o);
  return name_contours(o, "harmonic between vertices " + std::to_string(v) + " and " + std::to_string(w));
}

std::pair<Index, Index> Cut_family::spread_pair(int k)
{
  int last = 2;
  while (k >= last) { k -= last++; }
  while (static_cast<int>(m_spread.size()) <= last)
  {
    const Index a = static_cast<Index>(std::max_element(m_distance.begin(), m_distance.end()) - m_distance.begin());
    if (!(m_distance[a] > 0)) { throw Invalid_input_error("there are no more vertices to choose"); }
    m_spread.push_back(a);
    spread_to(*m_graph, a);
  }
  return {m_graph->representative[m_spread[k]], m_graph->representative[m_spread[last]]};
}

void Cut_family::spread_to(const Closed_model& g, Index a)
{
  const auto d = edge_distances(g, edge_lengths(m_root, g), a);
  for (std::size_t i = 0; i < d.size(); ++i) { m_distance[i] = std::min(m_distance[i], d[i]); }
}

std::vector<std::array<Point, 2>> Cut_family::seam_points(const Cut& cut)
{
  std::vector<std::array<Point, 2>> seams;
  for (const auto& seam : cut.opened.seams)
  {
    std::array<Point, 2> ends{cut.surface.points[cut.surface.source(seam[0])],
                              cut.surface.points[cut.surface.target(seam[0])]};
    std::sort(ends.begin(), ends.end());
    seams.push_back(ends);
  }
  std::sort(seams.begin(), seams.end());
  return seams;
}

std::vector<char> find_best_cuts(const std::vector<std::array<double, 3>>& costs)
{
  std::vector<char> is_best(costs.size(), 1);
  for (std::size_t i = 0; i < costs.size(); ++i)
    for (const auto& other : costs)
    {
      bool as_good = true, better = false;
      for (int k = 0; k < 3; ++k)
      {
        as_good = as_good && other[k] <= costs[i][k];
        better = better || other[k] < costs[i][k];
      }
      if (as_good && better) { is_best[i] = 0; }
    }
  return is_best;
}

} // namespace meridian
