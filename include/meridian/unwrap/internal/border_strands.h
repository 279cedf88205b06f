// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_INTERNAL_BORDER_STRANDS_H
#define MERIDIAN_UNWRAP_INTERNAL_BORDER_STRANDS_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/open_along.h>

#include <array>
#include <utility>
#include <vector>

namespace meridian {
namespace internal {

// A part of the cut graph, or of the boundary, between two vertices where seams meet or end.
struct Strand
{
  std::vector<Index> vertices; // of the surface; the last is the first again on a boundary without seams
  std::vector<double> along;   // where each vertex lies, from 0 to `steps`
  double length = 0;
  int least = 1, steps = 0; // of the grid
};

// One side of a strand on the border of the disc.
struct Border_side
{
  Index strand = -1;
  bool is_reversed = false;
  Index mate = -1;             // the other side; -1 on the boundary of the surface
  std::vector<Index> vertices; // of the disc, in the order of the strand
  int start = 0;               // its first grid point
};

struct Border_strands
{
  std::vector<Strand> strands;
  std::vector<Border_side> sides; // counterclockwise
  bool is_whole = false;          // a boundary without seams
};

// A grid point inside a strand.
struct Strand_stop
{
  Index strand;
  int step;
};

// Spaces the vertices of a strand by length. An edge counts at least a ten-thousandth of the mean, so that no two
// vertices coincide.
void space_strand(const Triangle_surface& s, Strand& strand);

// The least numbers of steps for which an image's border becomes a graph without loops and double edges.
void find_least_steps(Border_strands& border);

// Takes the border of a disc apart.
Border_strands gather_border(const Refined_surface& s, const Opened_surface& opened, const Triangle_surface& disc);

// Shares `total` out by length: as many as its part, rounded so that the largest remainders go up, and never fewer than
// the least.
void share_out(std::vector<Strand*> strands, int total);

std::array<std::vector<Strand*>, 2> boundary_and_seams(Border_strands& border);

// The least size of an image: seams count twice, and the boundary takes an even number of steps.
int least_size(Border_strands& border);

// Gives every strand its steps, `total` in all, and spaces its vertices over them.
void distribute_steps(const Triangle_surface& s, Border_strands& border, int total);

// The vertex inside a strand that lies on a grid point, or may be moved there; -1 if there is none.
Index vertex_near(const std::vector<double>& along, double step);

// The side that holds a grid point, and the step within it, from its start.
std::pair<Index, int> side_at(const Border_strands& border, int point);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_UNWRAP_INTERNAL_BORDER_STRANDS_H
