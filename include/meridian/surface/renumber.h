// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_RENUMBER_H
#define MERIDIAN_SURFACE_RENUMBER_H

#include <meridian/base/vectors.h>
#include <meridian/surface/examine_surface.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianSurface
/// \param s a surface
/// \returns whether going through its faces in order jumps about among its vertices, so that algorithms wait for memory
///          most of the time: whether three corners in ten push others out of a small cache
/// \par Complexity
/// Linear, and negligible.
bool is_scattered(const Triangle_surface& s);

/*!
 * \ingroup PkgMeridianSurface
 *
 * numbers the vertices of a component along a Hilbert curve (by CGAL's `hilbert_sort()`), and its faces by their lowest
 * vertices. Whatever then goes through the surface finds in the cache what lies nearby.
 *
 * \param c the component, with the same faces and corners after as before; `vertex_of` and `triangle_of` lead to the
 *        soup, but do not ascend any more
 * \par Complexity
 * \f$ O(n \log n) \f$
 */
void renumber(Surface_component& c);

} // namespace meridian

#endif // MERIDIAN_SURFACE_RENUMBER_H
