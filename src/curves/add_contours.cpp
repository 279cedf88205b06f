// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/add_contours.h>

#include <meridian/base/vectors.h>

#include <algorithm>

namespace meridian {

namespace internal {

void add_contours(const std::vector<std::vector<Piece_crossing>>& all, Normal_curves& curves, std::size_t stride)
{
  struct Place
  {
    std::size_t curve, position;
  };
  std::vector<Place> places;
  for (std::size_t c = 0; c < all.size(); ++c)
    for (std::size_t i = 0; i < all[c].size(); ++i) { places.push_back({c, i}); }
  const auto at = [&](const Place& p) -> const Piece_crossing& { return all[p.curve][p.position]; };
  std::sort(places.begin(), places.end(), [&](const Place& p, const Place& q) { return is_before(at(p), at(q)); });
  std::vector<std::vector<double>> rank(all.size());
  for (std::size_t c = 0; c < all.size(); ++c) { rank[c].resize(all[c].size()); }
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    rank[places[i].curve][places[i].position] = static_cast<double>(i);
  }
  for (std::size_t c = 0; c < all.size(); ++c)
  {
    std::vector<Crossing> steps;
    for (std::size_t i = 0; i < all[c].size(); ++i)
    {
      Index place = 0;
      for (Index x : curves.on(all[c][i].edge)) { place += curves[x].t < rank[c][i]; }
      steps.push_back({all[c][i].halfedge, place, rank[c][i]});
    }
    curves.add(static_cast<Index>(stride * c), steps);
  }
  for (std::size_t c = 0; c < all.size(); ++c)
  {
    const auto crossings = curves.crossings(static_cast<Index>(stride * c));
    for (std::size_t i = 0; i < crossings.size(); ++i) { curves.move(crossings[i], all[c][i].t); }
  }
}

} // namespace internal

} // namespace meridian
