// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/compare_parameterizations.h>

#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/field/edge_weights.h>
#include <meridian/map/map_into_polygon.h>
#include <meridian/map/planar_map.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/measures.h>
#include <meridian/unwrap/internal/untouched_stars.h>

#include <string>
#include <vector>

namespace meridian {

std::vector<double> map_weights(const Triangle_surface& s, Map_weights kind)
{
  if (kind == Map_weights::UNIFORM) { return std::vector<double>(s.number_of_halfedges(), 1.); }
  return edge_weights(s, kind == Map_weights::POSITIVE ? Weights::POSITIVE : Weights::COTANGENT);
}

Map_comparison compare_parameterizations(const Triangle_surface& root, const Cut_disc& first, const Cut_disc& second,
                                         Map_weights kind)
{
  const std::vector<Index> untouched = find_untouched_vertices(root, first, second);
  const std::vector<double> weights = map_weights(root, kind);
  const auto map = [&](const Triangle_surface& disc) {
    internal::check_stars(root, disc, untouched);
    const auto loops = boundary_loops(disc);
    if (loops.size() != 1)
      throw Invalid_input_error("compare_parameterizations: a disc has one boundary loop, not "
                                + std::to_string(loops.size()));
    const std::vector<double> on_disc =
      internal::weights_on_disc(root, disc, untouched, weights, map_weights(disc, kind));
    return map_into_polygon(disc, on_disc, loops.front(), place_on_circle(places_along(disc, loops.front())));
  };
  return compare_maps(root, first, second, weights, {map(first.disc), map(second.disc)});
}

} // namespace meridian
