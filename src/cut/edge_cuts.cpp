// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/edge_cuts.h>

#include <meridian/base/exceptions.h>
#include <meridian/cut/internal/edge_exchange.h>
#include <meridian/cut/internal/edge_trees.h>
#include <meridian/cut/internal/straighten_paths.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Face_tree.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/seams.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

namespace {

// The tree of shortest ways along edges from `base`; the boundary costs nothing.
Edge_tree seam_tree(const Triangle_surface& s, Index base, const std::vector<double>& lengths)
{
  return grow_edge_tree(s, {{0., base}}, [&](Index h) { return s.opposite[h] < 0 ? 0. : lengths[h]; });
}

std::vector<Index> close_tree_to_cut(const Triangle_surface& s, const Edge_tree& tree,
                                     const std::vector<double>& lengths)
{
  std::vector<char> is_in_tree(s.number_of_halfedges(), 0);
  for (Index h : tree.by)
  {
    if (h >= 0) { is_in_tree[s.edge(h)] = 1; }
  }
  // The loops, the longest first; then the tree, from far out: of two ways to one boundary loop that are equally long,
  // one must be crossed.
  std::vector<std::tuple<bool, double, Index>> loops;
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
    if (s.opposite[h] > h)
    {
      loops.emplace_back(is_in_tree[h], -(tree.distance[s.source(h)] + tree.distance[s.target(h)] + lengths[h]), h);
    }
  std::sort(loops.begin(), loops.end());
  std::vector<Index> order;
  for (const auto& loop : loops) { order.push_back(std::get<Index>(loop)); }
  std::vector<char> is_cut = edges_beside_face_tree(s, order);
  prune(s, is_cut);
  return flagged_edges(s, is_cut);
}

void check_index(const char* function, const char* what, Index i, Index size)
{
  if (i < 0 || i >= size)
    throw Invalid_input_error(std::string(function) + ": there is no " + what + " " + std::to_string(i)
                              + "; the surface has " + std::to_string(size));
}

} // namespace

} // namespace internal

std::vector<Index> cut_by_tree_cotree(const Triangle_surface& s, Index base, const Edge_metric& metric)
{
  internal::check_index("cut_by_tree_cotree", "vertex", base, s.number_of_vertices());
  const std::vector<double> lengths = measure_edges(s, metric);
  if (internal::is_sphere(s)) { return internal::cut_sphere(s, base, lengths); }
  return internal::close_tree_to_cut(s, internal::seam_tree(s, base, lengths), lengths);
}

std::vector<Index> find_short_tree_cotree_cut(const Triangle_surface& s, int bases, const Progress& progress,
                                              const Edge_metric& metric, const std::function<bool(Index)>& may_be_base)
{
  if (bases < 1)
  {
    throw Invalid_input_error("find_short_tree_cotree_cut: " + std::to_string(bases)
                              + " base points were asked for; one is the least");
  }
  const std::vector<double> lengths = measure_edges(s, metric);
  if (internal::is_sphere(s)) { return internal::cut_sphere(s, -1, lengths); }
  const Index n = s.number_of_vertices();
  const bool takes_all = bases >= n;
  const Closed_model g = make_closed_model(s);
  std::vector<double> far(n, std::numeric_limits<double>::infinity());
  Index base = takes_all || g.number_of_nodes < 2 ? 0 : g.representative[find_distant_nodes(s, g).first];
  if (may_be_base && !takes_all)
  {
    for (Index v = 0; v < n; ++v)
    {
      if (!may_be_base(v)) { far[v] = -1; }
    }
    if (far[base] < 0) { base = static_cast<Index>(std::max_element(far.begin(), far.end()) - far.begin()); }
  }
  std::vector<Index> shortest;
  double least = std::numeric_limits<double>::infinity();
  const Index wanted = takes_all ? n : static_cast<Index>(bases);
  for (Index i = 0; i < wanted; ++i)
  {
    const internal::Edge_tree tree = internal::seam_tree(s, base, lengths);
    std::vector<Index> cut = internal::close_tree_to_cut(s, tree, lengths);
    const double length =
      std::accumulate(cut.begin(), cut.end(), 0., [&](double sum, Index h) { return sum + lengths[h]; });
    if (length < least || i == 0)
    {
      least = length;
      shortest = std::move(cut);
    }
    for (Index v = 0; v < n; ++v)
    {
      if (far[v] >= 0) { far[v] = std::min(far[v], tree.distance[v]); }
    }
    far[base] = -1; // not again, also where all distances are 0
    base = takes_all ? i + 1 : static_cast<Index>(std::max_element(far.begin(), far.end()) - far.begin());
    if (progress) { progress(static_cast<double>(i + 1) / wanted); }
  }
  return shortest;
}

std::vector<Index> straighten_edge_cut(const Triangle_surface& s, const std::vector<Index>& cut, Path_ends ends,
                                       int rounds, const std::function<bool(Index)>& may_pass)
{
  std::vector<char> is_cut(s.number_of_halfedges(), 0);
  for (Index h : cut) { is_cut[h] = is_cut[s.opposite[h]] = 1; }
  internal::Path_straightener straightener(s, is_cut, ends == Path_ends::SLIDE, may_pass);
  while (rounds-- > 0 && straightener.straighten_all()) {}
  return internal::flagged_edges(s, is_cut);
}

std::vector<Index> exchange_in_edge_cut(const Triangle_surface& s, const std::vector<Index>& cut, int rounds)
{
  std::vector<char> is_cut(s.number_of_halfedges(), 0);
  for (Index h : cut) { is_cut[h] = is_cut[s.opposite[h]] = 1; }
  internal::Edge_exchange exchange(s, is_cut);
  double last = exchange.length();
  while (rounds-- > 0 && exchange.run() > 0)
  {
    constexpr double least_gain = 5e-3;
    const double now = exchange.length();
    if (!(now < (1 - least_gain) * last)) { break; }
    last = now;
  }
  return internal::flagged_edges(s, is_cut);
}

std::vector<Index> cut_by_removing_faces(const Triangle_surface& s, Index seed_face, Path_ends ends, int rounds)
{
  if (seed_face != -1) { internal::check_index("cut_by_removing_faces", "face", seed_face, s.number_of_faces()); }
  if (internal::is_sphere(s)) { return internal::cut_sphere(s, -1, measure_edges(s, {})); }
  if (seed_face < 0)
  {
    const Closed_model g = make_closed_model(s);
    seed_face = g.number_of_nodes < 2 ? 0 : s.face(s.outgoing[g.representative[find_distant_nodes(s, g).first]]);
  }
  std::vector<Index> crossed = internal::grow_face_tree(s, seed_face).by;
  crossed.erase(std::remove(crossed.begin(), crossed.end(), -1), crossed.end());
  std::vector<char> is_cut = internal::edges_beside_face_tree(s, crossed);
  internal::prune(s, is_cut);
  return straighten_edge_cut(s, internal::flagged_edges(s, is_cut), ends, rounds);
}

} // namespace meridian
