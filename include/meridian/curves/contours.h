// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_CONTOURS_H
#define MERIDIAN_CURVES_CONTOURS_H

#include <meridian/base/names.h>
#include <meridian/base/vectors.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/surface/Surface_curve.h>

#include <array>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianContours
/// a closed contour: the halfedges that it crosses, each from its lower end to its higher end.
///
/// It leaves the face of each halfedge through it, so that the higher side is always on its left.
struct Contour
{
  Index level = -1;             ///< it runs between the nodes of rank `level` and `level + 1`
  Index saddle = -1;            ///< a vertex of the saddle it belongs to, or -1
  bool is_longer = false;       ///< whether the other loop of its saddle is shorter
  std::vector<Index> halfedges; ///< on the surface that was ordered
};

/// \ingroup PkgMeridianContours
/// \param m the ordered surface
/// \param h a halfedge
/// \param level between the nodes of rank `level` and `level + 1`
/// \returns whether `h` runs from below the level to above it
inline bool rises_through(const Ordered_surface& m, Index h, Index level)
{
  return m.rank[m.surface.source(h)] <= level && m.rank[m.surface.target(h)] > level;
}

/// \ingroup PkgMeridianContours
/// \param m the ordered surface
/// \param start a halfedge
/// \param level the level
/// \returns the contour at that level through `start`
/// \pre `rises_through(m, start, level)`
/// \par Complexity
/// Linear in the number of edges crossed. Every step is decided by comparing ranks, so the contour is closed and
/// simple.
Contour trace_contour(const Ordered_surface& m, Index start, Index level);

/// \ingroup PkgMeridianContours
/// \param m the ordered surface
/// \param level the level
/// \returns all contours at that level, each once
/// \par Complexity
/// Linear in the size of the surface.
std::vector<Contour> trace_level(const Ordered_surface& m, Index level);

/// \ingroup PkgMeridianContours
/// \param m the ordered surface
/// \param h a halfedge
/// \param level a level that it rises through
/// \returns where the contour crosses it, as a fraction from its source: by `m.placement`, or linear interpolation of
///          the field in the finest scale that the edge has; 1/2 where the order goes against the field
double crossing_fraction(const Ordered_surface& m, Index h, Index level);

/// \ingroup PkgMeridianContours
/// \param m the ordered surface
/// \param c a contour of it
/// \returns its length
double length(const Ordered_surface& m, const Contour& c);

/*!
 * \ingroup PkgMeridianContours
 *
 * \returns the loops of all saddles, two a saddle: the two contours that meet there, on the side where they are apart.
 *          A loop that two saddles share is given once, for the first of them where it is the shorter of the two, if
 *          there is one.
 *
 * \param m the ordered surface
 * \param away how far from the saddle the loops run, as a fraction of the way to the next critical level: 0 is at the
 *        saddle, where loops have a corner, and anything below 1/2 keeps the loops of different saddles apart
 * \pre all saddles are simple
 * \throws Internal_error if the contours of a saddle are not two
 * \par Complexity
 * Linear in the number of edges crossed.
 */
std::vector<Contour> trace_saddle_loops(const Ordered_surface& m, double away = 0.25);

/// \ingroup PkgMeridianContours
/// where on its arc of the Reeb graph the loop of a saddle is taken.
enum class Levels
{
  SADDLE, ///< near the saddle
  TIGHT   ///< where it is shortest between two critical levels
};

/// the names of `Levels`.
template <> struct Names<Levels>
{
  static constexpr std::array<Named_value<Levels>, 2> table{{
    {Levels::SADDLE, "saddle", "near their saddle"},
    {Levels::TIGHT, "tight", "where they are shortest between two critical levels"},
  }};
};

/*!
 * \ingroup PkgMeridianContours
 *
 * \returns the shortest of contours that a contour sweeps between the critical points above and below it. All of them
 *          are isotopic, and loops on different arcs of the Reeb graph stay disjoint.
 *
 * \param m the ordered surface
 * \param loop a contour
 * \param is_critical whether a node is a critical point, for each node
 * \param samples how many levels are tried in each direction
 * \par Complexity
 * \f$ O(k \log k) \f$ for the `k` nodes that are swept, and linear in the crossings of the contours tried
 */
Contour find_tightest_contour(const Ordered_surface& m, const Contour& loop, const std::vector<char>& is_critical,
                              int samples = 24);

} // namespace meridian

#endif // MERIDIAN_CURVES_CONTOURS_H
