// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/pack_unwrappings.h>

#include <meridian/base/exceptions.h>
#include <meridian/map/distortion.h>
#include <meridian/map/minimize_distortion.h>
#include <meridian/map/open_slits.h>
#include <meridian/map/pin_map.h>
#include <meridian/map/planar_map.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/pieces.h>

#include <algorithm>
#include <cmath>
#include <limits>
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

// Opens slits of a chart as wide as it can for a tenth of its distortion, or so. `was`: the square of its L2 stretch.
// Returns whether there are any.
bool open_slits_of(const Triangle_surface& disc, const Chart& chart, double was, double gap, Opened_chart& opened)
{
  constexpr double part = 0.1, little = 1e-3; // of the excess of the square of the stretch, and besides
  constexpr int steps = 3;                    // the rest of the chart gives way
  const double most = was + part * (was - 1) + little;
  for (double narrower = 1; narrower > 0.2;)
  {
    opened.at = chart.at;
    if (open_slits(disc, opened.at, narrower * gap).before == 0) { return false; }
    try
    {
      minimize_distortion(disc, opened.at, {Distortion_energy::SYMMETRIC_DIRICHLET, steps, 1e-3, false});
    }
    catch (const Solver_error&)
    {} // then nothing gives way
    const double is = square_of_stretch(disc, opened.at);
    opened.more = chart.area * (is - was);
    if (is <= most) { return true; }
    narrower /= is - was > 4 * (most - was) ? 4 : 2;
  }
  return false;
}

// Opens slits of the charts of a surface, of so many as leave its L2 stretch at what it may be, if it is. `texels`: how
// long each chart is when it is packed, in texels, of 1.
void open_slits_of(const std::vector<Surface_piece>& pieces, Chart* charts, const std::vector<double>& texels,
                   double padding, double most_stretch)
{
  constexpr double more = 1.05; // what was opened may be packed a little smaller
  std::vector<Opened_chart> all;
  double left = 0; // of the square of the stretch, times the area
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    const Triangle_surface& disc = pieces[i].surface;
    const double was = square_of_stretch(disc, charts[i].at);
    left += charts[i].area * (most_stretch * most_stretch - was);
    const double gap = more * padding / texels[i];
    Opened_chart opened{i, {}, 0};
    if (gap > 0 && !charts[i].is_fixed && open_slits_of(disc, charts[i], was, gap, opened))
    {
      all.push_back(std::move(opened));
    }
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

// Charts as they are packed in the first way that is tried.
std::vector<Chart> packed_once(std::vector<Chart> charts, Pack_options options)
{
  options.tries = 1;
  pack_charts(charts, options);
  return charts;
}

// The same of all surfaces, in texels of the size that they are about to have. Charts that are fixed stay, and so do
// those that are mirror images, or not one-to-one.
void open_slits_of_all(std::vector<Chart>& charts, const std::vector<std::vector<Surface_piece>>& pieces,
                       const std::vector<Unwrapping>& unwrapped, const Pack_options& options, double most_stretch)
{
  const std::vector<Chart> packed = packed_once(charts, options);
  const double all = static_cast<double>(options.resolution[0]) * options.resolution[1];
  std::size_t first = 0;
  for (std::size_t k = 0; k < pieces.size(); ++k)
  {
    std::vector<double> texels;
    for (std::size_t i = first; i < first + pieces[k].size(); ++i)
    {
      texels.push_back(std::sqrt(all * covered_area(packed[i]) / covered_area(charts[i])));
    }
    const bool may_open = unwrapped[k].map.is_one_to_one && !unwrapped[k].is_symmetric;
    if (may_open) { open_slits_of(pieces[k], &charts[first], texels, options.padding, most_stretch); }
    first += pieces[k].size();
  }
}

// Puts charts to where their pins are.
class Chart_pinner
{
public:
  Chart_pinner(std::vector<Chart>& charts, const std::vector<std::vector<Surface_piece>>& pieces,
               const Pack_options& options)
    : m_charts(charts), m_options(options), m_pins(charts.size())
  {
    for (const auto& of_surface : pieces)
    {
      m_first.push_back(m_pieces.size());
      for (const Surface_piece& piece : of_surface) { m_pieces.push_back(&piece); }
    }
  }

  void add(const Texture_pin& pin)
  {
    const std::size_t last = pin.surface + 1 < m_first.size() ? m_first[pin.surface + 1] : m_pieces.size();
    for (std::size_t i = m_first[pin.surface]; i < last; ++i)
    {
      const std::vector<Index>& vertices = m_pieces[i]->vertices;
      const auto v = std::find(vertices.begin(), vertices.end(), pin.vertex);
      if (v != vertices.end()) { m_pins[i].push_back({static_cast<Index>(v - vertices.begin()), pin.at}); }
    }
  }

  void run()
  {
    for (std::size_t i = 0; i < m_charts.size(); ++i)
    {
      if (m_pins[i].size() > 1) { put(i); }
    }
    const auto has_one = [](const std::vector<Map_pin>& pins) { return pins.size() == 1; };
    if (std::none_of(m_pins.begin(), m_pins.end(), has_one)) { return; }
    const double size = size_of_unit();
    for (std::size_t i = 0; i < m_charts.size(); ++i)
    {
      if (!has_one(m_pins[i])) { continue; }
      if (!(size > 0))
      {
        throw Invalid_input_error("a pin on a side of the texture leaves the chart around it no room");
      }
      const double image = covered_area(m_charts[i]), scale = size * std::sqrt(m_charts[i].area / image);
      for (Plane_point& p : m_charts[i].at) { p = scale * p; }
      put(i);
    }
  }

private:
  // The sides of the texture where texels are squares.
  Plane_point sides() const { return in_proportion({1, 1}, m_options.resolution); }

  void put(std::size_t i)
  {
    Chart& chart = m_charts[i];
    const double width = sides()[0], height = sides()[1];
    std::vector<Map_pin> pins = m_pins[i];
    for (Map_pin& p : pins) { p.at = {p.at[0] * width, p.at[1] * height}; }
    const bool is_there = !(pin_map(m_pieces[i]->surface, chart.at, pins) > 0);
    bool is_inside = true;
    for (Plane_point& p : chart.at)
    {
      p = {p[0] / width, p[1] / height};
      is_inside = is_inside && p[0] >= 0 && p[0] <= 1 && p[1] >= 0 && p[1] <= 1;
    }
    for (const Map_pin& p : m_pins[i])
    {
      if (is_there) { chart.at[p.vertex] = p.at; }
    }
    if (!is_inside)
    {
      throw Invalid_input_error(
        "a chart that is pinned reaches out of the texture; pins that are nearer to each other, or "
        "nearer to its middle, would help");
    }
    chart.is_fixed = true;
  }

  // How long a unit of length is, where the texture's longer side is 1: as charts have it that are fixed, or else
  // as small as leaves room around them.
  double size_of_unit() const
  {
    double image = 0, area = 0;
    for (const Chart& c : m_charts)
    {
      image += c.is_fixed ? sides()[0] * sides()[1] * covered_area(c) : 0;
      area += c.is_fixed ? c.area : 0;
    }
    if (area > 0) { return std::sqrt(image / area); }
    for (const Chart& c : packed_once(m_charts, m_options))
    {
      image += sides()[0] * sides()[1] * covered_area(c);
      area += c.area;
    }
    constexpr double smaller = 0.7;
    double size = smaller * std::sqrt(image / area);
    for (std::size_t i = 0; i < m_charts.size(); ++i)
    {
      if (m_pins[i].size() == 1) { size = std::min(size, largest_inside(i)); }
    }
    return size;
  }

  // How long a unit of length may be, so that a chart with one pin is inside of the texture.
  double largest_inside(std::size_t i) const
  {
    constexpr double almost = 0.99;
    const Chart& chart = m_charts[i];
    const Map_pin& pin = m_pins[i].front();
    double factor = std::numeric_limits<double>::infinity(); // of the chart as it is
    for (const Plane_point& p : chart.at)
      for (std::size_t k = 0; k < 2; ++k)
      {
        const double away = p[k] - chart.at[pin.vertex][k], room = sides()[k] * (away > 0 ? 1 - pin.at[k] : pin.at[k]);
        if (std::abs(away) > 0) { factor = std::min(factor, room / std::abs(away)); }
      }
    return almost * factor * std::sqrt(covered_area(chart) / chart.area);
  }

  std::vector<Chart>& m_charts;
  const Pack_options& m_options;
  std::vector<const Surface_piece*> m_pieces; // of each chart
  std::vector<std::size_t> m_first;           // of each surface, its first chart
  std::vector<std::vector<Map_pin>> m_pins;   // of each chart
};

} // namespace

double pack_unwrappings(std::vector<Unwrapping>& unwrapped, const std::vector<double>& units,
                        const Pack_options& options, double most_stretch, const std::vector<Texture_pin>& pins)
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
  Chart_pinner pinner(charts, pieces, scaled);
  for (const Texture_pin& pin : pins)
  {
    if (unwrapped[pin.surface].map.is_one_to_one) { pinner.add(pin); }
  }
  pinner.run();
  if (options.padding > 0) { open_slits_of_all(charts, pieces, unwrapped, scaled, most_stretch); }
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
