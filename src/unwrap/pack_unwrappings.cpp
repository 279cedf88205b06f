// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/pack_unwrappings.h>

#include <meridian/map/planar_map.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/pieces.h>

#include <algorithm>
#include <utility>

namespace meridian {

double pack_unwrappings(std::vector<Unwrapping>& unwrapped, const std::vector<double>& units,
                        const Pack_options& options)
{
  const double largest = *std::max_element(units.begin(), units.end());
  std::vector<std::vector<Surface_piece>> pieces;
  std::vector<Chart> charts;
  for (std::size_t i = 0; i < unwrapped.size(); ++i)
  {
    const double unit = units[i] / largest; // squares of units may leave the range of double
    pieces.push_back(pieces_of(unwrapped[i].disc));
    for (const Surface_piece& piece : pieces.back())
    {
      charts.push_back({&piece.surface.triangles, {}, unit * unit * area(piece.surface)});
      for (Index v : piece.vertices) { charts.back().at.push_back(unwrapped[i].map.at[v]); }
    }
  }
  Pack_options scaled = options;
  scaled.density *= largest;
  const double filled = pack_charts(charts, scaled);
  auto packed = charts.begin();
  for (std::size_t i = 0; i < unwrapped.size(); ++i)
  {
    const Triangle_surface& disc = unwrapped[i].disc;
    Parameterization& map = unwrapped[i].map;
    for (const Surface_piece& piece : pieces[i])
    {
      for (std::size_t v = 0; v < piece.vertices.size(); ++v) { map.at[piece.vertices[v]] = packed->at[v]; }
      ++packed;
    }
    map.flipped = find_flipped_faces(disc.triangles, map.at);
    std::vector<Plane_point> at; // where texels are squares
    for (const Plane_point& p : map.at) { at.push_back(in_proportion(p, options.resolution)); }
    map.faces = measure_faces(disc.points, disc.triangles, at);
    map.distortion = measure_distortion(disc.points, disc.triangles, at, map.faces);
  }
  return filled;
}

} // namespace meridian
