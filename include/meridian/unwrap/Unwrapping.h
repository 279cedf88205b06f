// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_UNWRAPPING_H
#define MERIDIAN_UNWRAP_UNWRAPPING_H

#include <meridian/base/vectors.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/curves/contours.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/map/Parameterization.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/measures.h>
#include <meridian/unwrap/square_border.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// the L2 stretch that cuts are extended for, if nothing is asked for.
constexpr double default_max_stretch = 1.1;
/// \ingroup PkgMeridianParameterization
/// the same where charts are divided until it is reached.
constexpr double default_max_stretch_of_charts = 1.02;

/// \ingroup PkgMeridianParameterization
/// what one may choose about an unwrapping.
struct Unwrap_options
{
  Cut_options cut; ///< how it is cut; by itself, curves are tightened: shorter seams may stretch the map more
  Map_options map; ///< how the disc is mapped
  int family = 1;  ///< how many cuts are compared
  /// w, 0 to 1: the cut with the least (1 - w) length + w stretch is taken, the length divided by the root of the area;
  /// if it is not 0, links are varied too
  double stretch_weight = 0;
  /// the cut is extended until the L2 stretch is no larger, or no extension lowers it; 0: only what stretches to more
  /// than 2 is extended; by itself, until it is `default_max_stretch`, as long as that gains enough; but as with 0
  /// if `stretch_weight` is not 0
  std::optional<double> max_stretch;
  int extensions = 1000; ///< vertices that the cut is extended to, at most
  /// how many charts the surface is divided into; 0: as few as the stretch that is wanted needs, by itself
  /// `default_max_stretch_of_charts`
  int charts = 1;
  /// with `charts` 0: charts are divided, too, until they fill so much of a square, if that makes seams no longer than
  /// by a quarter
  double filled = 0.6;
  /// halfedges of the surface that shall be seams, and stay where they are: they are completed by `complete_cut()`, for
  /// which `cut` says whether on edges, with bifurcations, when curves are tight and how fields are solved. Then the
  /// cut is extended only if a stretch is asked for, and `charts` is how many there are at least
  std::vector<Index> seams;
  /// faces of the surface that no seam shall go over, if that can be: curves go around them, and `cut` says the same of
  /// them as with `seams`
  std::vector<Index> keep_out;
  /// whether seams and charts shall be mirror images of each other if the surface is: see `find_mirror()`. Then seams
  /// run along edges, and one chart is two where its halves cannot stay together
  bool is_symmetric = false;
  /// if not 0: the border becomes that of a geometry image with as many points along a side, which is a square
  int image_size = 0;
};

/// \ingroup PkgMeridianParameterization
/// a cut that was mapped, on the way to the one returned.
struct Unwrap_step
{
  std::string name;        ///< what was tried
  double length;           ///< of the seams, on the surface
  double stretch_l2;       ///< of the map
  Map_method method;       ///< that made the map
  Index flipped;           ///< faces turned over or without area; -1 if there was no map
  bool is_taken;           ///< whether it was better than those before
  std::string reason = {}; ///< why there was no map
};

/// \ingroup PkgMeridianParameterization
/// a surface, cut and mapped into the plane.
struct Unwrapping
{
  Cut cut;                             ///< the cut
  Triangle_surface disc;               ///< the cut surface, taken apart: a disc, or several
  Parameterization map;                ///< of `disc`
  Square_border border;                ///< with `Unwrap_options::image_size`
  std::vector<Unwrap_step> members;    ///< of the family
  std::vector<Unwrap_step> variations; ///< of the links
  std::vector<Unwrap_step> extensions; ///< of the cut
  std::size_t extended = 0;            ///< vertices that the cut was extended to
  std::size_t charts = 1;              ///< connected pieces of `disc`, each of them a disc, beside each other in `map`
  std::vector<Index> chart_of;         ///< the chart of each face; empty if there is one
  bool is_symmetric = false;           ///< whether seams and charts are mirror images, as `Unwrap_options` asked for
};

} // namespace meridian

#endif // MERIDIAN_UNWRAP_UNWRAPPING_H
