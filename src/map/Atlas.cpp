// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/internal/Atlas.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

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

} // namespace

Chart_cells cells_of(const std::vector<std::array<Index, 3>>& triangles, const std::vector<Plane_point>& at)
{
  constexpr double rounding = 1e-6; // of what is placed later
  const auto cell = [](double x) { return static_cast<int>(std::floor(x)); };
  std::vector<std::vector<std::array<int, 2>>> spans;
  Chart_cells cells;
  for (const auto& corners : triangles)
  {
    const std::array<Plane_point, 3> t{at[corners[0]], at[corners[1]], at[corners[2]]};
    const auto [low, high] = std::minmax({t[0][1], t[1][1], t[2][1]});
    const int last = cell(high + rounding);
    if (last >= static_cast<int>(spans.size())) { spans.resize(last + 1); }
    for (int y = std::max(cell(low - rounding), 0); y <= last; ++y)
    {
      const auto [left, right] = span_in_band(t, y);
      if (!(left <= right)) { continue; }
      const std::array<int, 2> span{std::max(cell(left - rounding), 0), cell(right + rounding) + 1};
      auto& of_row = spans[y];
      if (!of_row.empty() && span[0] <= of_row.back()[1] && span[1] >= of_row.back()[0]) // faces come side by side
      {
        of_row.back() = {std::min(span[0], of_row.back()[0]), std::max(span[1], of_row.back()[1])};
      }
      else { of_row.push_back(span); }
    }
  }
  for (int y = 0; y < static_cast<int>(spans.size()); ++y)
  {
    std::sort(spans[y].begin(), spans[y].end());
    for (const auto& [begin, end] : spans[y]) { add_run(cells, {y, begin, end}); }
  }
  return cells;
}

Chart_cells coarsened(const Chart_cells& cells, const Atlas::Place& place, int margin, int factor)
{
  std::vector<Chart_cells::Run> runs;
  for (const auto& run : cells.runs)
  {
    const int low = std::max(place.y + run.row - margin, 0) / factor, high = (place.y + run.row + margin) / factor;
    const int begin = std::max(place.x + run.begin - margin, 0) / factor,
              end = (place.x + run.end - 1 + margin) / factor + 1;
    for (int row = low; row <= high; ++row) { runs.push_back({row, begin, end}); }
  }
  std::sort(runs.begin(), runs.end(), [](const auto& a, const auto& b) {
    return std::tie(a.row, a.begin, a.end) < std::tie(b.row, b.begin, b.end);
  });
  Chart_cells coarse;
  for (const auto& run : runs) { add_run(coarse, run); }
  return coarse;
}

Atlas::Atlas(int size, int gap)
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

void Atlas::take(const Chart_cells& cells, const Place& place)
{
  for (const auto& run : cells.runs)
  {
    const int begin = std::max(place.x + run.begin - m_gap, 0), end = std::min(place.x + run.end + m_gap, m_size);
    for (int y = std::max(place.y + run.row - m_gap, 0); y <= std::min(place.y + run.row + m_gap, m_size - 1); ++y)
    {
      take_row(row(0, y), begin, end);
    }
  }
  for (int y = std::max(place.y - m_gap, 0); y < std::min(place.y + cells.height + m_gap, m_size); ++y)
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
