// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/cut_family.h>

#include <meridian/base/Verification.h>
#include <meridian/base/exceptions.h>
#include <meridian/cut/cut_to_disc.h>
#include <meridian/field/Field.h>
#include <meridian/field/curved_vertices.h>
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
#include <variant>
#include <vector>

namespace meridian {

Cut_family::Cut_family(const Triangle_surface& root, int size, const Cut_options& options)
  : m_root(root), m_size(size), m_options(options)
{
  if (!m_options.tightening) { m_options.tightening = Tightening::CURVES; } // or all members would end alike
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

// The options' method becomes contours, with the field and choices it had as far as they go with that.
By_contours& take_contours(Cut_options& o)
{
  o = with_method(std::move(o), By_contours());
  return std::get<By_contours>(o.method);
}

// Contours of an eigenfunction.
std::string choose_eigenfunction(int k, By_contours& contours)
{
  static_cast<Field_options&>(contours) = {{}, Eigenfunction_field{k}};
  return "eigenfunction " + std::to_string(k);
}

void choose_short_and_tight(By_contours& contours)
{
  contours.preference = preference::short_length;
  contours.levels = Levels::TIGHT;
}

// Short and tight contours of a harmonic field between two vertices.
void choose_ends(Index minimum, Index maximum, By_contours& contours)
{
  contours.field = Harmonic_field{weights_of(contours.field)};
  contours.minima = {minimum};
  contours.maxima = {maximum};
  choose_short_and_tight(contours);
}

} // namespace

std::string Cut_family::choose(int i, Cut_options& o)
{
  switch (i)
  {
  case 0: return "as chosen";
  case 1: choose_short_and_tight(take_contours(o)); return "harmonic, short and tight";
  case 2: o = with_method(std::move(o), By_tree_cotree()); return name_of(o.method);
  case 3: o = with_method(std::move(o), By_distance()); return name_of(o.method);
  case 4: o = with_method(std::move(o), By_removing_faces()); return name_of(o.method);
  case 5: return choose_eigenfunction(genus(m_root) + 1, take_contours(o));
  case 6: o = with_method(std::move(o), By_generators()); return name_of(o.method);
  case 7: o = with_method(std::move(o), By_flow_lines()); return name_of(o.method);
  case 8:
  {
    const auto [a, b] = find_curved_vertices(m_root);
    choose_ends(a, b, take_contours(o));
    return "harmonic between curved vertices";
  }
  case 9: take_contours(o).preference = preference::mean_curvature; return "harmonic, mean curvature";
  case 10: choose_short_and_tight(take_contours(o)); return choose_eigenfunction(1, take_contours(o));
  case 11:
    choose_short_and_tight(take_contours(o));
    o.links.bifurcations = true;
    return "harmonic, with bifurcations";
  default: break;
  }
  const auto [v, w] = spread_pair(i - 12);
  choose_ends(v, w, take_contours(o));
  return "harmonic between vertices " + std::to_string(v) + " and " + std::to_string(w);
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
