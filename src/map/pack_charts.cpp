// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/pack_charts.h>

#include <meridian/map/internal/Atlas.h>
#include <meridian/map/planar_map.h>

#include <meridian/base/Bounding_box.h>
#include <meridian/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

namespace {

// A chart in one direction, its lowest and leftmost points at 0.
struct Turned_chart
{
  std::vector<Plane_point> at;
  Plane_point extent;
};

// `scale`: to the right and upwards.
Turned_chart turn(const std::vector<Plane_point>& points, const Plane_point& direction, const Plane_point& scale)
{
  Turned_chart turned;
  turned.at.reserve(points.size());
  for (const Plane_point& p : points)
  {
    turned.at.push_back({scale[0] * dot(p, direction), scale[1] * cross(direction, p)});
  }
  Bounding_box<Plane_point> box(turned.at.front());
  for (const Plane_point& p : turned.at) { box.add(p); }
  for (Plane_point& p : turned.at) { p = p - box.low; }
  turned.extent = box.high - box.low;
  return turned;
}

class Chart_packer
{
public:
  Chart_packer(const std::vector<Chart>& charts, std::vector<char> may_turn, const Pack_options& options)
    : m_charts(charts), m_may_turn(std::move(may_turn)), m_options(options),
      m_upwards(static_cast<double>(options.resolution[0]) / options.resolution[1]), m_scale(charts.size(), 1),
      m_base(charts.size(), Plane_point{1, 0}), m_order(charts.size())
  {
    for (std::size_t i = 0; i < charts.size(); ++i)
    {
      const double image = covered_area(charts[i]);
      if (image > 0 && charts[i].area > 0) { m_scale[i] = std::sqrt(charts[i].area / image); }
      if (m_may_turn[i]) { m_base[i] = longer_side_of_smallest_rectangle(charts[i].at); }
      m_border.push_back(border_of(*charts[i].triangles, charts[i].at));
      m_area += m_upwards * m_scale[i] * m_scale[i] * image;
    }
    measure();
    vary(0);
  }

  // The points of all charts in the unit square.
  std::vector<std::vector<Plane_point>> pack()
  {
    if (m_options.density > 0 || has_fixed()) { return place_at_density(); }
    if (m_charts.size() == 1) { return place_one(); }
    std::vector<std::vector<Plane_point>> best, placed;
    double least = place_in_smallest_square(best);
    if (least < std::numeric_limits<double>::infinity())
    {
      for (Variation& v : find_best_variations())
      {
        vary(v.number);
        m_directions = std::move(v.directions);
        const double size = place_in_smallest_square(placed);
        if (!(size < least)) { continue; }
        least = size;
        best.swap(placed);
      }
      return best;
    }
    throw Invalid_input_error("the padding leaves no room for " + std::to_string(m_charts.size())
                              + " charts; a smaller padding or a higher resolution would help");
  }

private:
  static constexpr int fine = 1024;   // cells along a side that the charts are hoped to need
  static constexpr int coarser = 4;   // how many of them are one where directions and orders are compared
  static constexpr double small = 32; // cells; directions of charts that are less wide are compared as they are

  // Packs charts as they are sorted and turned now, into the unit square. Returns how long a unit is then, the longer
  // the worse; infinite if there is no room.
  double place_in_smallest_square(std::vector<std::vector<Plane_point>>& placed)
  {
    // the gap between charts is known once the square is
    const Cell_gap gap = least_gap();
    constexpr double least = 1e-9;
    constexpr int patience = 6;
    int tries = 0;
    for (double hoped_for = 0.6; hoped_for > least; ++tries)
    {
      find_unit(hoped_for);
      placed = place_all(gap);
      if (placed.empty()) // they are too large for the cells there are
      {
        hoped_for /= 4;
        continue;
      }
      double size = 0;
      for (const auto& points : placed)
        for (const Plane_point& p : points) { size = std::max({size, p[0], p[1]}); }
      const Cell_gap needed = gap_for(size);
      if (needed.right > gap.right || needed.up > gap.up)
      {
        hoped_for *= (tries < patience ? 0.98 : 0.8) * fine * fine / (size * size);
        continue;
      }
      scale_down(placed, size);
      return size / m_unit;
    }
    return std::numeric_limits<double>::infinity();
  }

  // A way to begin, and what it leads to on a grid of few cells.
  struct Variation
  {
    int extent;
    int number;
    std::vector<Plane_point> directions; // of each chart; empty: not known yet
  };

  // Those of several that lead to the smallest squares.
  std::vector<Variation> find_best_variations()
  {
    // what is placed there, and on the fine grid: how charts begin matters less the more there are
    constexpr std::size_t coarse_work = 640, fine_work = 40, most = 5;
    const std::size_t n = m_charts.size(), few = std::min(most, fine_work / n),
                      tries = few > 0 ? std::min(static_cast<std::size_t>(m_options.tries), coarse_work / n) : 0;
    std::vector<Variation> all;
    std::map<std::array<double, 3>, Chart_cells> known; // by the chart and the direction
    find_unit(0.6);
    for (int i = 1; i < static_cast<int>(tries); ++i)
    {
      vary(i);
      all.push_back({0, i, std::vector<Plane_point>(m_charts.size())});
      all.back().extent = extent_on_few_cells(known, all.back().directions);
    }
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.extent < b.extent; });
    all.resize(std::min(few, all.size()));
    return all;
  }

  int extent_on_few_cells(std::map<std::array<double, 3>, Chart_cells>& known, std::vector<Plane_point>& chosen) const
  {
    constexpr int few_cells = fine / coarser;
    Atlas atlas(2 * few_cells, {1, 1});
    for (std::size_t i : m_order)
    {
      std::optional<Atlas::Place> best;
      const Chart_cells none, *best_cells = &none;
      for (const Plane_point& d : directions(i))
      {
        const auto [at, is_new] = known.try_emplace({static_cast<double>(i), d[0], d[1]}); // all fit into it
        if (is_new) { at->second = cells(i, turn(m_charts[i].at, d, scales(m_unit / coarser * m_scale[i])).at); }
        const auto place = atlas.find_place(at->second, best, *best_cells);
        if (!place) { continue; }
        best = place;
        best_cells = &at->second;
        chosen[i] = d;
      }
      if (!best) { return std::numeric_limits<int>::max(); }
      atlas.take(*best_cells, *best);
    }
    return atlas.extent();
  }

  // Another direction of the first chart for each try, and for every other one another order; by itself for try 0.
  void vary(int tries)
  {
    std::mt19937 random(static_cast<unsigned>(tries));
    std::vector<double> size = m_size;
    if (tries % 2 == 1)
    {
      for (double& x : size) { x *= 0.5 + static_cast<double>(random() >> 8) / (1 << 24); }
    }
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    std::stable_sort(m_order.begin(), m_order.end(), [&](std::size_t a, std::size_t b) { return size[a] > size[b]; });
    m_turn = range_of_directions() * tries / m_options.tries;
  }

  // The gap in a square of so many cells.
  Cell_gap gap_for(double size) const
  {
    const auto cells = [&](int texels) { return static_cast<int>(std::ceil(m_options.padding * size / texels)); };
    return {cells(m_options.resolution[0]), cells(m_options.resolution[1])};
  }
  // In the cells that charts are hoped to need, a gap that rounding cannot close.
  Cell_gap least_gap() const
  {
    const Cell_gap gap = gap_for(fine);
    return {std::max(gap.right, 1), std::max(gap.up, 1)};
  }

  // What a unit is to the right and upwards, in a texture that is drawn as a square.
  Plane_point scales(double unit) const { return {unit, m_upwards * unit}; }

  // The angle after which a chart that is turned is as long to the right or upwards as before.
  double range_of_directions() const
  {
    const bool is_square = m_options.resolution[0] == m_options.resolution[1];
    return is_square ? std::acos(-1.) / 2 : std::acos(-1.);
  }

  // The cells that a chart touches whose points are somewhere.
  Chart_cells cells(std::size_t chart, const std::vector<Plane_point>& at) const
  {
    return m_border[chart].empty() ? cells_of(*m_charts[chart].triangles, at) : cells_within(m_border[chart], at);
  }

  // Finds how many cells a unit has if charts fill a part of the square.
  void find_unit(double filled)
  {
    const double wanted = std::max(std::sqrt(m_area / filled), m_longest);
    m_unit = wanted > 0 ? fine / wanted : 1;
  }

  void measure()
  {
    for (std::size_t i = 0; i < m_charts.size(); ++i)
    {
      const Plane_point extent = turn(m_charts[i].at, m_base[i], scales(m_scale[i])).extent;
      m_size.push_back(extent[0] * extent[1]);
      m_longest = std::max({m_longest, extent[0], extent[1]});
    }
  }

  // Directions that a chart is tried in: right angles, and for one that is large those between.
  std::vector<Plane_point> directions(std::size_t chart) const
  {
    constexpr double large = 0.02;
    if (!m_may_turn[chart]) { return {{1, 0}}; }
    const Plane_point& base = m_base[chart];
    if (!m_directions.empty()) { return {m_directions[chart]}; }
    if (chart == m_order.front() && m_turn > 0)
    {
      const double c = std::cos(m_turn), s = std::sin(m_turn);
      return {{base[0] * c - base[1] * s, base[0] * s + base[1] * c}};
    }
    const bool is_large = m_upwards * m_charts[chart].area > large * m_area;
    const int count = is_large ? 24 : 4;
    std::vector<Plane_point> all;
    for (int k = 0; k < count; ++k)
    {
      const double angle = 2 * std::acos(-1.) * k / count;
      const Plane_point &d = m_base[chart], turned{std::cos(angle), std::sin(angle)};
      // right angles without rounding
      const bool is_right = 4 * k % count == 0;
      const Plane_point t = is_right ? Plane_point{std::nearbyint(turned[0]), std::nearbyint(turned[1])} : turned;
      all.push_back({d[0] * t[0] - d[1] * t[1], d[0] * t[1] + d[1] * t[0]});
    }
    return all;
  }

  // A square that charts are put into, and the same on a coarser grid.
  struct Square
  {
    Square(int size, const Cell_gap& gap) : atlas(size, gap), coarse(size / coarser, {0, 0}) {}
    Atlas atlas, coarse;
  };

  // Puts a chart into a square, if it has a place for it.
  std::vector<Plane_point> place(std::size_t chart, const Cell_gap& gap, Square& square) const
  {
    const std::vector<Plane_point> all = directions(chart);
    const double unit = m_unit * m_scale[chart];
    const Plane_point first = turn(m_charts[chart].at, all.front(), scales(unit)).extent;
    const bool is_small = std::min(first[0], first[1]) < small;
    Found best;
    if (is_small || all.size() == 1) { best = find_best(square.atlas, chart, all, unit); }
    else
    {
      const Plane_point direction = find_best(square.coarse, chart, all, unit / coarser).direction;
      best = find_best(square.atlas, chart, {direction}, unit);
    }
    if (!best.place) { return {}; }
    take(best.cells, *best.place, gap, square);
    const Plane_point at{static_cast<double>(best.place->x), static_cast<double>(best.place->y)};
    for (Plane_point& p : best.at) { p = p + at; }
    return std::move(best.at);
  }

  static void take(const Chart_cells& cells, const Atlas::Place& place, const Cell_gap& gap, Square& square)
  {
    square.atlas.take(cells, place);
    square.coarse.take(coarsened(cells, place, gap, coarser), {0, 0, (square.atlas.extent() + coarser - 1) / coarser});
  }

  // Whether a chart is no larger than a square: that of others would have too many cells to be drawn.
  static bool fits(const Plane_point& extent, const Atlas& atlas)
  {
    return extent[0] < atlas.size() && extent[1] < atlas.size();
  }

  // Nothing if there is no place for one.
  std::vector<std::vector<Plane_point>> place_all(const Cell_gap& gap) const
  {
    Square square(2 * fine, gap);
    std::vector<std::vector<Plane_point>> placed(m_charts.size());
    for (std::size_t i : m_order)
    {
      placed[i] = place(i, gap, square);
      if (placed[i].empty()) { return {}; }
    }
    return placed;
  }

  bool has_fixed() const
  {
    return std::any_of(m_charts.begin(), m_charts.end(), [](const Chart& c) { return c.is_fixed; });
  }

  // In texels along a unit of length: what was chosen, or that of charts that are fixed.
  double density() const
  {
    if (!has_fixed()) { return m_options.density; }
    double image = 0, area = 0;
    for (const Chart& c : m_charts)
    {
      image += c.is_fixed ? covered_area(c) : 0;
      area += c.is_fixed ? c.area : 0;
    }
    return m_options.resolution[0] * std::sqrt(image / m_upwards / area);
  }

  // The cells that have some of a chart on either side.
  static Chart_cells shrunk(Chart_cells cells)
  {
    std::vector<Chart_cells::Run> inside;
    for (const Chart_cells::Run& run : cells.runs)
    {
      if (run.end - run.begin > 2) { inside.push_back({run.row, run.begin + 1, run.end - 1}); }
    }
    cells.runs = std::move(inside);
    return cells;
  }

  // Charts that stay where they are take their places in the first square.
  void take_fixed(const Cell_gap& gap, std::vector<Square>& squares,
                  std::vector<std::vector<Plane_point>>& placed) const
  {
    Atlas taken(fine, {0, 0});
    for (std::size_t i = 0; i < m_charts.size(); ++i)
    {
      if (!m_charts[i].is_fixed) { continue; }
      placed[i] = m_charts[i].at;
      std::vector<Plane_point> in_cells;
      constexpr double last = fine - 1e-3; // of the last cell
      for (const Plane_point& p : placed[i])
      {
        in_cells.push_back({std::min(fine * p[0], last), std::min(fine * p[1], last)});
      }
      if (squares.empty()) { squares.emplace_back(fine, gap); }
      const Chart_cells of_chart = shrunk(cells(i, in_cells));
      if (!taken.is_free(of_chart))
      {
        throw Invalid_input_error("charts that are pinned overlap each other; pins farther apart would help");
      }
      taken.take(of_chart, {0, 0, fine});
      take(cells(i, in_cells), {0, 0, fine}, gap, squares.front());
    }
  }

  // The same in as many squares as that takes, in the size that charts shall have.
  std::vector<std::vector<Plane_point>> place_at_density()
  {
    m_unit = density() * fine / m_options.resolution[0];
    const Cell_gap gap = least_gap();
    std::vector<Square> squares;
    std::vector<std::vector<Plane_point>> placed(m_charts.size());
    take_fixed(gap, squares, placed);
    for (std::size_t i : m_order)
    {
      if (m_charts[i].is_fixed) { continue; }
      std::size_t tile = 0;
      for (; placed[i].empty(); ++tile)
      {
        const bool is_new = tile == squares.size();
        if (is_new && tile == static_cast<std::size_t>(m_options.tiles)) { refuse_density(i); }
        if (is_new) { squares.emplace_back(fine, gap); }
        placed[i] = place(i, gap, squares[tile]);
        if (is_new && placed[i].empty()) { refuse_density(i); }
      }
      --tile;
      const std::size_t row = tile / 10, column = tile % 10;
      const Plane_point at{static_cast<double>(column), static_cast<double>(row)};
      for (Plane_point& p : placed[i]) { p = at + Plane_point{std::min(p[0] / fine, 1.), std::min(p[1] / fine, 1.)}; }
    }
    return placed;
  }

  [[noreturn]] void refuse_density(std::size_t chart) const
  {
    const double density = m_unit * m_options.resolution[0] / fine, scale = m_scale[chart] * density;
    const Plane_point extent = turn(m_charts[chart].at, m_base[chart], {scale, scale}).extent;
    const auto [width, height] = m_options.resolution;
    const int tiles = m_options.tiles;
    std::ostringstream message;
    message << "at " << density << " texels along a unit of length, " << tiles
            << (tiles == 1 ? " texture of " : " textures of ") << width << " x " << height
            << " texels cannot hold all charts: there is no room for one of " << std::ceil(extent[0]) << " x "
            << std::ceil(extent[1]) << ", and all of them cover " << std::setprecision(3)
            << m_area * density * density / width / width << " textures without what is between; "
            << (has_fixed() ? "pins nearer to each other, a higher resolution or more charts would help"
                            : "a lower density, a higher resolution, more tiles or more charts would help");
    throw Invalid_input_error(message.str());
  }

  // A chart in the direction and at the place that are best.
  struct Found
  {
    Plane_point direction{1, 0};
    std::optional<Atlas::Place> place{};
    Chart_cells cells{};
    std::vector<Plane_point> at{};
  };
  Found find_best(const Atlas& atlas, std::size_t chart, const std::vector<Plane_point>& all, double unit) const
  {
    Found best;
    for (const Plane_point& d : all)
    {
      Turned_chart turned = turn(m_charts[chart].at, d, scales(unit));
      if (!fits(turned.extent, atlas)) { continue; }
      Chart_cells of_chart = cells(chart, turned.at);
      const auto place = atlas.find_place(of_chart, best.place, best.cells);
      if (place) { best = {d, place, std::move(of_chart), std::move(turned.at)}; }
    }
    return best;
  }

  // A chart alone is turned so that the square around it is smallest.
  std::vector<std::vector<Plane_point>> place_one() const
  {
    constexpr int count = 90;
    Turned_chart best = turn(m_charts[0].at, m_base[0], scales(1));
    const auto size = [](const Turned_chart& t) { return std::max(t.extent[0], t.extent[1]); };
    for (int k = 1; k < count && m_may_turn[0]; ++k)
    {
      const double angle = range_of_directions() * k / count;
      Turned_chart turned = turn(m_charts[0].at, {std::cos(angle), std::sin(angle)}, scales(1));
      if (size(turned) < size(best)) { best = std::move(turned); }
    }
    std::vector<std::vector<Plane_point>> placed{std::move(best.at)};
    scale_down(placed, size(best));
    return placed;
  }

  static void scale_down(std::vector<std::vector<Plane_point>>& placed, double size)
  {
    for (auto& points : placed)
      for (Plane_point& p : points)
      {
        for (double& x : p) { x = size > 0 ? std::min(x / size, 1.) : 0; }
      }
  }

  const std::vector<Chart>& m_charts;
  const std::vector<char> m_may_turn;
  const Pack_options m_options;
  const double m_upwards;          // a unit upwards, in units to the right, where the texture is a square
  std::vector<double> m_scale;     // of each chart, to the area that it has
  std::vector<Plane_point> m_base; // the direction of the longer side of the smallest rectangle around it
  std::vector<std::vector<std::array<Index, 2>>> m_border; // of each chart; empty if it has none that says all
  std::vector<double> m_size;                              // of a rectangle around each chart
  std::vector<std::size_t> m_order;                        // from the largest to the smallest
  double m_turn = 0;                                       // of the first chart; 0: as is best
  std::vector<Plane_point> m_directions;                   // of all charts, where they are known
  double m_area = 0, m_longest = 0;                        // of all charts; the longest side of a rectangle
  double m_unit = 1;                                       // in cells
};

} // namespace

} // namespace internal

namespace {

// The charts of which packing has flipped faces: rounding has shrunk them to nothing.
std::vector<std::size_t> find_lost(const std::vector<Chart>& charts,
                                   const std::vector<std::vector<Plane_point>>& placed)
{
  std::vector<std::size_t> lost;
  for (std::size_t i = 0; i < charts.size(); ++i)
  {
    const auto flips = [&](const auto& at) { return find_flipped_faces(*charts[i].triangles, at).size(); };
    if (flips(placed[i]) > flips(charts[i].at)) { lost.push_back(i); }
  }
  return lost;
}

// Packs charts; those that would lose faces by it are not turned, and larger than in proportion if that is not enough.
std::vector<std::vector<Plane_point>> place_charts(std::vector<Chart> charts, const Pack_options& options)
{
  std::vector<char> may_turn(charts.size(), 1);
  auto placed = internal::Chart_packer(charts, may_turn, options).pack();
  std::vector<std::size_t> lost = find_lost(charts, placed);
  double largest = 0;
  for (const Chart& c : charts) { largest = std::max(largest, c.area); }
  for (double least : {0., 1e-8, 1e-4, 1.}) // parts of the largest area
  {
    if (lost.empty()) { break; }
    for (std::size_t i : lost)
    {
      may_turn[i] = 0;
      if (options.may_enlarge) { charts[i].area = std::max(charts[i].area, least * largest); }
    }
    placed = internal::Chart_packer(charts, may_turn, options).pack();
    lost = find_lost(charts, placed);
  }
  return placed;
}

} // namespace

double pack_charts(std::vector<Chart>& charts, const Pack_options& options)
{
  auto placed = place_charts(charts, options);
  double filled = 0;
  int tiles = 1;
  for (std::size_t i = 0; i < charts.size(); ++i)
  {
    charts[i].at = std::move(placed[i]);
    filled += covered_area(charts[i]);
    tiles = std::max(tiles, count_tiles(charts[i].at));
  }
  return filled / tiles;
}

double covered_area(const Chart& chart)
{
  double sum = 0;
  for (const auto& t : *chart.triangles)
  {
    sum += std::abs(cross(chart.at[t[1]] - chart.at[t[0]], chart.at[t[2]] - chart.at[t[0]])) / 2;
  }
  return sum;
}

Plane_point in_proportion(const Plane_point& p, const std::array<int, 2>& resolution)
{
  const auto [width, height] = resolution;
  const double longer = std::max(width, height);
  return {p[0] * (width / longer), p[1] * (height / longer)};
}

int count_tiles(const std::vector<Plane_point>& at)
{
  const auto number = [](double x) { return std::max(static_cast<int>(std::ceil(x)) - 1, 0); };
  int last = 0;
  for (const Plane_point& p : at) { last = std::max(last, number(p[0]) + 10 * number(p[1])); }
  return last + 1;
}

} // namespace meridian
