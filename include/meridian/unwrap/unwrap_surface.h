// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_UNWRAP_SURFACE_H
#define MERIDIAN_UNWRAP_UNWRAP_SURFACE_H

#include <meridian/surface/Triangle_surface.h>
#include <meridian/unwrap/Unwrapping.h>

namespace meridian {

/*!
 * \ingroup PkgMeridianParameterization
 *
 * cuts a connected surface into a disc and maps it into the plane.
 *
 * The cut is the best of a family for the paper's functional, (1 - w) length + w stretch (\cite patane2007, section
 * 3.3); then its links are varied as long as that gains. It is extended, by `plan_extensions()` or for maps into a
 * polygon to the regions of highest stretch (\cite gu2002), until the stretch is as small as is wanted or that gains
 * too little; and, whether wanted or not, while faces are turned over. Every cut is recounted.
 *
 * Where more charts than one are asked for, the disc is unfolded as if it could pass through itself, and divided along
 * short arcs by what that shows (`unfold_disc()`, `find_arc()`).
 *
 * \param root the surface
 * \param options see there
 *
 * \returns the cut and its map, which may have flipped faces if no extension helped
 * \pre `root` is connected
 * \throws Invalid_input_error, Solver_error, Cancelled, Internal_error as `cut_to_disc()`; Invalid_input_error too if
 *   several charts are asked for with a geometry image, a family, a weight of stretch or a polygon for the border
 * \par Complexity
 * That of `cut_to_disc()` and `parameterize_disc()`, for every cut that is tried.
 */
Unwrapping unwrap_surface(const Triangle_surface& root, const Unwrap_options& options = Unwrap_options());

} // namespace meridian

#endif // MERIDIAN_UNWRAP_UNWRAP_SURFACE_H
