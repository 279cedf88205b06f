// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/embed_in_plane.h>

#include <meridian/base/vectors.h>
#include <meridian/field/edge_weights.h>
#include <meridian/map/map_into_polygon.h>
#include <meridian/map/planar_map.h>

namespace meridian {

Planar_embedding embed_in_plane(const Triangle_surface& s, Make_solver make_solver)
{
  const auto loops = boundary_loops(s);
  const auto length_of = [&](const std::vector<Index>& loop) {
    double sum = 0;
    for (Index h : loop) { sum += s.length(h); }
    return sum;
  };
  std::size_t outer = 0;
  for (std::size_t i = 1; i < loops.size(); ++i)
  {
    if (length_of(loops[i]) > length_of(loops[outer])) { outer = i; }
  }

  Triangle_surface filled;
  filled.points = s.points;
  filled.triangles = s.triangles;
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    if (i == outer) { continue; }
    const Index center = filled.number_of_vertices();
    Point middle{0, 0, 0};
    for (Index h : loops[i])
    {
      middle = middle + (1. / static_cast<double>(loops[i].size())) * s.points[s.source(h)];
      filled.triangles.push_back({s.target(h), s.source(h), center});
    }
    filled.points.push_back(middle);
  }
  connect(filled);

  auto at = map_into_polygon(filled, edge_weights(filled, Weights::POSITIVE), loops[outer],
                             place_on_circle(places_along(s, loops[outer])), make_solver);
  Planar_embedding embedding;
  embedding.is_valid = find_flipped_faces(filled.triangles, at).empty();
  embedding.points = std::move(at);
  embedding.points.resize(s.number_of_vertices());
  return embedding;
}

} // namespace meridian
