// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_CHECK_SURFACE_H
#define MERIDIAN_SURFACE_CHECK_SURFACE_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianSurface
/// checks that a surface has faces, and that they are connected.
/// \param s the surface
/// \throws Invalid_input_error otherwise; it counts the pieces and names a face of each of the first
/// \par Complexity
/// Linear.
void check_surface(const Triangle_surface& s);

/// \ingroup PkgMeridianSurface
/// checks that each vertex has faces, and that they form one fan.
/// \param s the surface
/// \throws Invalid_input_error otherwise
/// \par Complexity
/// Linear.
void check_fans(const Triangle_surface& s);

/// \ingroup PkgMeridianSurface
/// checks that a surface is a disc: connected, with one boundary loop and no handle.
/// \param s the surface
/// \throws Invalid_input_error otherwise
/// \par Complexity
/// Linear.
void check_is_disc(const Triangle_surface& s);

/// \ingroup PkgMeridianSurface
/// checks that a surface has some vertices.
/// \param s the surface
/// \param vertices their numbers
/// \param what what they were given as, for the message
/// \throws Invalid_input_error if there is none of one of these numbers
void check_vertices(const Triangle_surface& s, const std::vector<Index>& vertices, const char* what);

/// \ingroup PkgMeridianSurface
/// checks that there is one finite value for each vertex.
/// \param s the surface
/// \param values the values
/// \param what what they are, for the message
/// \throws Invalid_input_error otherwise
void check_values(const Triangle_surface& s, const std::vector<double>& values, const char* what);

} // namespace meridian

#endif // MERIDIAN_SURFACE_CHECK_SURFACE_H
