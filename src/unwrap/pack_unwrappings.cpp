// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/pack_unwrappings.h>

#include <meridian/map/distortion.h>
#include <meridian/map/minimize_distortion.h>
#include <meridian/map/open_slits.h>
#include <meridian/map/planar_map.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/pieces.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace meridian {

namespace {

double square_of_stretch(const Triangle_surface& disc, const std::vector<Plane_point>& at)
{
  const double stretch =
    measure_distortion(disc.points, disc.triangles, at, measure_faces(disc.points, disc.triangles, at)).stretch_l2;
  return stretch * stretch;
}

// A chart whose slits were opened.
struct Opened_chart
{
  std::size_t number;
  std::vector<Plane_point> at;
  double more; // the square of its L2 stretch, times its area, than it was
};

// Opens slits of the charts of a surface, of so many as leave its L2 stretch at what it may be, if it is. `texels`: how
// long each chart is when it is packed, in texels, of 1.
void open_slits_of(const std::vector<Surface_piece>& pieces, Chart* charts, const std::vector<double>& texels,
                   double padding, double most_stretch)
{
  std::vector<Opened_chart> all;
  double left = 0; // of the square of the stretch, times the area
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    const Triangle_surface& disc = pieces[i].surface;
    constexpr double more = 1.05; // what was opened may be packed a little smaller
    const double gap = more * padding / texels[i],
                 was = most_stretch > 0 ? charts[i].area * square_of_stretch(disc, charts[i].at) : 0;
    left += charts[i].area * most_stretch * most_stretch - was;
    Opened_chart opened{i, charts[i].at, 0};
    if (!(gap > 0) || open_slits(disc, opened.at, gap).before == 0) { continue; }
    constexpr int steps = 3; // the rest of the chart gives way
    minimize_distortion(disc, opened.at, {Distortion_energy::SYMMETRIC_DIRICHLET, steps, 1e-3, false});
    opened.more = most_stretch > 0 ? charts[i].area * square_of_stretch(disc, opened.at) - was : 0;
    all.push_back(std::move(opened));
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.more < b.more; });
  const bool has_limit = most_stretch > 0 && left >= 0;
  for (Opened_chart& opened : all)
  {
    if (has_limit && opened.more > left) { break; }
    left -= opened.more;
    charts[opened.number].at = std::move(opened.at);
  }
}

// The same of all surfaces, in texels of the size that they are about to have.
void open_slits_of_all(std::vector<Chart>& charts, const std::vector<std::vector<Surface_piece>>& pieces,
                       const Pack_options& options, double most_stretch)
{
  std::vector<Chart> packed = charts;
  Pack_options once = options;
  once.tries = 1;
  pack_charts(packed, once);
  const double all = static_cast<double>(options.resolution[0]) * options.resolution[1];
  std::size_t first = 0;
  for (std::size_t k = 0; k < pieces.size(); ++k)
  {
    std::vector<double> texels;
    for (std::size_t i = first; i < first + pieces[k].size(); ++i)
    {
      texels.push_back(std::sqrt(all * covered_area(packed[i]) / covered_area(charts[i])));
    }
    open_slits_of(pieces[k], &charts[first], texels, options.padding, most_stretch);
    first += pieces[k].size();
  }
}

} // namespace

double pack_unwrappings(std::vector<Unwrapping>& unwrapped, const std::vector<double>& units,
                        const Pack_options& options, double most_stretch)
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
  if (options.padding > 0) { open_slits_of_all(charts, pieces, scaled, most_stretch); }
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
