// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/internal/Atlas.h>

#include <meridian/map/planar_map.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace meridian {

namespace internal {

namespace {

// What a triangle covers of the band of height 1 above `y`: from the lowest to the highest x.
std::array<double, 2> span_in_band(const std::array<Plane_point, 3>& t, double y)
{
  std::array<double, 2> span{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const auto add = [&](double x) { span = {std::min(span[0], x), std::max(span[1], x)}; };
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Plane_point &a = t[k], &b = t[(k + 1) % 3];
    if (a[1] >= y && a[1] <= y + 1) { add(a[0]); }
    for (const double level : {y, y + 1})
    {
      if ((a[1] < level) != (b[1] < level)) { add(a[0] + (level - a[1]) / (b[1] - a[1]) * (b[0] - a[0])); }
    }
  }
  return span;
}

// Adds a run after all that begin before it.
void add_run(Chart_cells& cells, const Chart_cells::Run& run)
{
  cells.height = run.row + 1;
  cells.width = std::max(cells.width, run.end);
  const bool goes_on = !cells.runs.empty() && cells.runs.back().row == run.row && run.begin <= cells.runs.back().end;
  if (goes_on) { cells.runs.back().end = std::max(cells.runs.back().end, run.end); }
  else { cells.runs.push_back(run); }
}

// The cells that a chart touches, as they become known.
class Touched_cells
{
public:
  // Those of a triangle.
  void touch(const std::array<Plane_point, 3>& t)
  {
    constexpr double rounding = 1e-6; // of what is placed later
    const auto [low, high] = std::minmax({t[0][1], t[1][1], t[2][1]});
    const int last = cell(high + rounding);
    if (last >= static_cast<int>(m_spans.size())) { m_spans.resize(last + 1); }
    for (int y = std::max(cell(low - rounding), 0); y <= last; ++y)
    {
      const auto [left, right] = span_in_band(t, y);
      if (left <= right) { add(y, std::max(cell(left - rounding), 0), cell(right + rounding) + 1); }
    }
  }

  // Those of a row from the cell of one point to that of another.
  void fill(int y, double left, double right) { add(y, std::max(cell(left), 0), cell(right) + 1); }

  Chart_cells find()
  {
    Chart_cells cells;
    for (int y = 0; y < static_cast<int>(m_spans.size()); ++y)
    {
      std::sort(m_spans[y].begin(), m_spans[y].end());
      for (const auto& [begin, end] : m_spans[y]) { add_run(cells, {y, begin, end}); }
    }
    return cells;
  }

  int rows() const { return static_cast<int>(m_spans.size()); }

private:
  static int cell(double x) { return static_cast<int>(std::floor(x)); }

  void add(int y, int begin, int end)
  {
    auto& of_row = m_spans[y];
    if (!of_row.empty() && begin <= of_row.back()[1] && end >= of_row.back()[0]) // faces come side by side
    {
      of_row.back() = {std::min(begin, of_row.back()[0]), std::max(end, of_row.back()[1])};
    }
    else { of_row.push_back({begin, end}); }
  }

  std::vector<std::vector<std::array<int, 2>>> m_spans; // of each row
};

} // namespace

Chart_cells cells_of(const std::vector<std::array<Index, 3>>& triangles, const std::vector<Plane_point>& at)
{
  Touched_cells cells;
  for (const auto& t : triangles) { cells.touch({at[t[0]], at[t[1]], at[t[2]]}); }
  return cells.find();
}

std::vector<std::array<Index, 2>> border_of(const std::vector<std::array<Index, 3>>& triangles,
                                            const std::vector<Plane_point>& at)
{
  bool turns_left = false, turns_right = false;
  std::vector<std::array<Index, 3>> sides; // the lower end, the higher end, and whether it goes down
  for (const auto& t : triangles)
  {
    const int turn = orientation_of(at[t[0]], at[t[1]], at[t[2]]);
    turns_left = turns_left || turn > 0;
    turns_right = turns_right || turn < 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Index a = t[k], b = t[(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), a > b});
    }
  }
  std::vector<std::array<Index, 2>> border;
  if (turns_left && turns_right) { return border; }
  std::sort(sides.begin(), sides.end());
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last)
  {
    int up = 0; // how many more go up
    for (; last < sides.size() && sides[last][0] == sides[first][0] && sides[last][1] == sides[first][1]; ++last)
    {
      up += sides[last][2] == 0 ? 1 : -1;
    }
    const std::array<Index, 2> upwards{sides[first][0], sides[first][1]}, downwards{upwards[1], upwards[0]};
    border.insert(border.end(), static_cast<std::size_t>(std::abs(up)), up > 0 ? upwards : downwards);
  }
  return border;
}

Chart_cells cells_within(const std::vector<std::array<Index, 2>>& border, const std::vector<Plane_point>& at)
{
  Touched_cells cells;
  for (const auto& [a, b] : border) { cells.touch({at[a], at[b], at[b]}); }
  // cells that the border does not touch are inside if their middles are
  std::vector<std::vector<std::pair<double, int>>> crossings(cells.rows()); // where the border goes up, or down
  for (const auto& [v, w] : border)
  {
    const Plane_point &a = at[v], &b = at[w], &low = a[1] < b[1] ? a : b, &high = a[1] < b[1] ? b : a;
    for (int y = std::max(static_cast<int>(std::ceil(low[1] - 0.5)), 0); y + 0.5 < high[1]; ++y)
    {
      const double x = a[0] + (y + 0.5 - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
      crossings[y].emplace_back(x, a[1] < b[1] ? 1 : -1);
    }
  }
  for (int y = 0; y < cells.rows(); ++y)
  {
    std::sort(crossings[y].begin(), crossings[y].end());
    int around = 0;
    for (std::size_t i = 0; i + 1 < crossings[y].size(); ++i)
    {
      around += crossings[y][i].second;
      if (around != 0) { cells.fill(y, crossings[y][i].first, crossings[y][i + 1].first); }
    }
  }
  return cells.find();
}

Chart_cells coarsened(const Chart_cells& cells, const Atlas::Place& place, const Cell_gap& margin, int factor)
{
  std::vector<Chart_cells::Run> runs;
  for (const auto& run : cells.runs)
  {
    const int low = std::max(place.y + run.row - margin.up, 0) / factor,
              high = (place.y + run.row + margin.up) / factor;
    const int begin = std::max(place.x + run.begin - margin.right, 0) / factor,
              end = (place.x + run.end - 1 + margin.right) / factor + 1;
    for (int row = low; row <= high; ++row) { runs.push_back({row, begin, end}); }
  }
  std::sort(runs.begin(), runs.end(), [](const auto& a, const auto& b) {
    return std::tie(a.row, a.begin, a.end) < std::tie(b.row, b.begin, b.end);
  });
  Chart_cells coarse;
  for (const auto& run : runs) { add_run(coarse, run); }
  return coarse;
}

Atlas::Atlas(int size, const Cell_gap& gap)
  : m_size(size), m_gap(gap), m_words((size + bits - 1) / bits + 1), m_levels(1), m_rows(static_cast<std::size_t>(size))
{
  while ((2 << (m_levels - 1)) <= size) { ++m_levels; }
  m_taken.assign(static_cast<std::size_t>(m_levels) * m_rows * m_words, 0);
}

std::optional<Atlas::Place> Atlas::find_place(const Chart_cells& cells, const std::optional<Place>& best,
                                              const Chart_cells& best_cells) const
{
  std::vector<Span> spans;
  for (const auto& run : cells.runs)
  {
    int level = 0;
    while ((2 << level) <= run.end - run.begin) { ++level; }
    spans.push_back({run.row, run.begin, run.end, level});
  }
  // what is wide is in the way first
  std::stable_sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) { return a.level > b.level; });
  const int none = std::numeric_limits<int>::max();
  int extent = none, sum = none; // of the best: the square, and how far its far corner is from the near one
  if (best)
  {
    extent = best->extent;
    sum = best->x + best_cells.width + best->y + best_cells.height;
  }
  std::optional<Place> found;
  for (int y = 0; y + cells.height <= m_size; ++y)
  {
    const int so_far = std::max(m_extent, y + cells.height);
    if (so_far > extent) { break; }
    int last = m_size - cells.width; // the last cell of the row that would be better
    if (extent < none)
    {
      last = std::min(extent - cells.width, sum - 1 - cells.width - y - cells.height);
      if (so_far < extent) { last = std::max(last, extent - 1 - cells.width); }
      last = std::min(last, m_size - cells.width);
    }
    const int x = first_free(spans, y, last);
    if (x < 0) { continue; }
    found = Place{x, y, std::max(so_far, x + cells.width)};
    extent = found->extent;
    sum = x + cells.width + y + cells.height;
  }
  return found;
}

Atlas::Word Atlas::word_at(int level, int y, int x) const
{
  const int word = x / bits, shift = x % bits;
  if (word >= m_words) { return 0; }
  const Word* r = row(level, y);
  if (shift == 0) { return r[word]; }
  return r[word] >> shift | (word + 1 < m_words ? r[word + 1] << (bits - shift) : 0);
}

int Atlas::first_free(const std::vector<Span>& spans, int y, int last) const
{
  for (int x = 0; x <= last; x += bits)
  {
    Word taken = 0;
    for (const Span& span : spans)
    {
      taken |= word_at(span.level, y + span.row, x + span.begin);
      taken |= word_at(span.level, y + span.row, x + span.end - (1 << span.level));
      if (taken == ~Word(0)) { break; }
    }
    for (int k = 0; k < bits && x + k <= last && taken != ~Word(0); ++k)
    {
      if ((taken >> k & 1) == 0) { return x + k; }
    }
  }
  return -1;
}

void Atlas::take_row(Word* of_row, int begin, int end)
{
  const auto below = [](int x) { return (Word(1) << x % bits) - 1; }; // the bits before that of a cell
  if (begin >= end) { return; }
  const int first = begin / bits, last = end / bits;
  if (first == last)
  {
    of_row[first] |= below(end) & ~below(begin);
    return;
  }
  of_row[first] |= ~below(begin);
  for (int w = first + 1; w < last; ++w) { of_row[w] = ~Word(0); }
  of_row[last] |= below(end);
}

bool Atlas::is_free(const Chart_cells& cells) const
{
  return std::all_of(cells.runs.begin(), cells.runs.end(), [&](const Chart_cells::Run& run) {
    for (int x = run.begin; x < run.end; ++x)
    {
      if ((word_at(0, run.row, x) & 1) != 0) { return false; }
    }
    return true;
  });
}

void Atlas::take(const Chart_cells& cells, const Place& place)
{
  for (const auto& run : cells.runs)
  {
    const int begin = std::max(place.x + run.begin - m_gap.right, 0),
              end = std::min(place.x + run.end + m_gap.right, m_size);
    for (int y = std::max(place.y + run.row - m_gap.up, 0); y <= std::min(place.y + run.row + m_gap.up, m_size - 1);
         ++y)
    {
      take_row(row(0, y), begin, end);
    }
  }
  for (int y = std::max(place.y - m_gap.up, 0); y < std::min(place.y + cells.height + m_gap.up, m_size); ++y)
  {
    update_levels(y);
  }
  m_extent = place.extent;
}

void Atlas::update_levels(int y)
{
  for (int level = 1; level < m_levels; ++level)
  {
    const int half = 1 << (level - 1);
    Word* r = row(level, y);
    for (int w = 0; w < m_words; ++w) { r[w] = row(level - 1, y)[w] | word_at(level - 1, y, w * bits + half); }
  }
}

} // namespace internal

} // namespace meridian
