// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_INTERNAL_NAME_PATHS_H
#define MERIDIAN_CUT_INTERNAL_NAME_PATHS_H

#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>

#include <utility>
#include <vector>

namespace meridian {

namespace internal {

// How closed curves run along a cut graph. What is left beside the graph is a disc, so a curve in the surface can be
// pushed onto the disc's rim, and how often it then runs along each path, signs counted, depends on its homology class
// alone: of a closed surface the chains of a cut graph's cycles are the classes (the disc's own rim runs along every
// path there and back). With a boundary this holds up to multiples of the boundary loops, each taken as one.
class Graph_chains
{
public:
  // `s` refines `root`, its seam is the cut graph, and `paths` are the seam's `seam_paths()`.
  Graph_chains(const Triangle_surface& root, const Refined_surface& s, const std::vector<std::vector<Index>>& paths);

  // The number for each path of a closed walk; 0 everywhere as well if it runs along parts of boundary loops.
  // `walk` are vertices of the root, of which any two in a row are equal or joined by an edge.
  std::vector<Index> chain_of(const std::vector<Index>& walk) const;

private:
  // Appends what a walk along an edge of the root adds to the number of each place on the rim.
  void add_edge(Index from, Index to, std::vector<std::pair<Index, Index>>& changes) const;
  void add_halfedge(Index h, std::vector<std::pair<Index, Index>>& changes) const;
  // The first place on the rim after the source of a halfedge, in the corner where it leaves.
  Index place(Index h) const;

  const Triangle_surface& m_root;
  const Refined_surface& m_surface;
  std::vector<Index> m_place;                       // on the rim, of each halfedge; -1 inside the disc
  std::vector<char> m_is_on_rim;                    // of each vertex
  std::vector<std::pair<Index, Index>> m_questions; // places, in order, and what number is asked for there
  std::vector<std::vector<Index>> m_loops;          // the numbers of the sides of each boundary loop
  Index m_paths = 0;
};

// A meridian, without the refined surface that it lies on: a closed walk over vertices of the root that is homotopic to
// it, and its saddle.
struct Meridian_walk
{
  std::vector<Index> vertices;
  Index saddle;
};

std::vector<Meridian_walk> walks_of_meridians(const Triangle_surface& root, const Cut& cut);

// Names the paths of a cut graph, the seam of `s`. A meridian keeps its name if it is homologous to a simple cycle of
// paths, which takes its place. Of two such cycles that meet, the one of more paths loses its name. If all keep theirs,
// the other paths are links: what is left beside the meridians is a sphere with holes, and they join these.
std::vector<Named_curve> name_paths(const Triangle_surface& root, const Refined_surface& s,
                                    std::vector<std::vector<Index>> paths, const std::vector<Meridian_walk>& meridians);

} // namespace internal

} // namespace meridian

#endif // MERIDIAN_CUT_INTERNAL_NAME_PATHS_H
