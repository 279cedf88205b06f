// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_INTERNAL_ATLAS_H
#define MERIDIAN_MAP_INTERNAL_ATLAS_H

#include <meridian/base/vectors.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace meridian {
namespace internal {

// The cells of a grid that a chart touches, row by row from below. Its lowest and leftmost point are at 0.
struct Chart_cells
{
  // Cells from `begin` to before `end`.
  struct Run
  {
    int row, begin, end;
  };
  int width = 0, height = 0;
  std::vector<Run> runs; // by rows
};

// The cells that triangles touch. `at`: the points, in cells, none below 0.
Chart_cells cells_of(const std::vector<std::array<Index, 3>>& triangles, const std::vector<Plane_point>& at);

// The sides of the border of a chart, each as often as more triangles are on its left than on its right. Empty if
// triangles are turned either way, so that those of one kind may hide those of the other.
std::vector<std::array<Index, 2>> border_of(const std::vector<std::array<Index, 3>>& triangles,
                                            const std::vector<Plane_point>& at);

// The same cells as those that triangles touch, from their border: those that it touches, and those inside.
Chart_cells cells_within(const std::vector<std::array<Index, 2>>& border, const std::vector<Plane_point>& at);

// How many cells stay empty between charts, to the right and upwards.
struct Cell_gap
{
  int right = 0, up = 0;
};

// The cells of a square that are taken, or nearer to a taken one than is allowed.
class Atlas
{
public:
  Atlas(int size, const Cell_gap& gap);

  struct Place
  {
    int x, y;
    int extent; // of the square from 0 that holds the chart and all before
  };

  // The best place for a chart: with the smallest square, and of these that nearest to its corner. Nothing if none is
  // better than `best`, which is for `best_cells`.
  std::optional<Place> find_place(const Chart_cells& cells, const std::optional<Place>& best,
                                  const Chart_cells& best_cells) const;
  // Whether none of some cells is taken.
  bool is_free(const Chart_cells& cells) const;
  void take(const Chart_cells& cells, const Place& place);
  int extent() const { return m_extent; }
  int size() const { return m_size; }

private:
  using Word = std::uint64_t;
  static constexpr int bits = 64;

  // A run of cells of a chart: two stretches of 2^level cells cover it.
  struct Span
  {
    int row, begin, end, level;
  };
  // The first cell of a row, up to the last that counts, where a chart fits whose lowest row is there, or -1.
  int first_free(const std::vector<Span>& spans, int y, int last) const;
  Word* row(int level, int y) { return &m_taken[(static_cast<std::size_t>(level) * m_rows + y) * m_words]; }
  const Word* row(int level, int y) const { return &m_taken[(static_cast<std::size_t>(level) * m_rows + y) * m_words]; }
  // The word whose first bit is that of cell `x`.
  Word word_at(int level, int y, int x) const;
  // Takes cells from `begin` to before `end`.
  static void take_row(Word* of_row, int begin, int end);
  void update_levels(int y);

  int m_size;
  Cell_gap m_gap;
  int m_words, m_levels, m_extent = 0;
  std::size_t m_rows;
  std::vector<Word> m_taken; // of level k: whether one of 2^k cells from here on is taken
};

// The cells of a coarser grid, `factor` times as large, that a chart at some place touches, or a margin around it.
Chart_cells coarsened(const Chart_cells& cells, const Atlas::Place& place, const Cell_gap& margin, int factor);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_MAP_INTERNAL_ATLAS_H
