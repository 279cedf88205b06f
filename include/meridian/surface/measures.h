// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_MEASURES_H
#define MERIDIAN_SURFACE_MEASURES_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Triangle_surface.h>

#include <utility>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianSurface
/// \returns the angle of a face at the source of `h`, in radians; 0 where the face has a side of length 0
/// \param s the surface
/// \param h a halfedge
double corner_angle(const Triangle_surface& s, Index h);

/// \ingroup PkgMeridianSurface
/// \returns the angle between the normals of the two faces at an edge, in radians: 0 where they are in one plane, or
///          one of them has no area
/// \param s the surface
/// \param h a halfedge inside
double exterior_dihedral_angle(const Triangle_surface& s, Index h);

/// \ingroup PkgMeridianSurface
/// \returns the area of the faces
/// \param s the surface
double area(const Triangle_surface& s);

/// \ingroup PkgMeridianSurface
/// \returns the smallest angle of all faces, in radians; 0 if a face has no area
/// \param s the surface
double smallest_angle(const Triangle_surface& s);

/// \ingroup PkgMeridianSurface
/// discrete curvatures of a vertex, per unit of area (a third of the faces around).
struct Curvature
{
  double gaussian = 0; ///< angle defect over area
  double mean = 0;     ///< signed dihedral angles times edge lengths, over four times the area
};

/// \ingroup PkgMeridianSurface
/// \returns the curvatures at an interior vertex; zero on the boundary and where the area is zero
/// \param s the surface
/// \param v the vertex
/// \par Complexity
/// Linear in the degree. See \cite meyer2003 and \cite cohensteiner2003.
Curvature curvature(const Triangle_surface& s, Index v);

/// \ingroup PkgMeridianSurface
/// \returns the genus of a surface, whose boundary loops do not count
/// \param s the surface
/// \pre `s` is connected
/// \par Complexity
/// Linear.
int genus(const Triangle_surface& s);

/// \ingroup PkgMeridianSurface
/// \returns the length of each edge of a closed model, in the order of its edges
/// \param s the surface
/// \param g its closed model
std::vector<double> edge_lengths(const Triangle_surface& s, const Closed_model& g);

/// \ingroup PkgMeridianSurface
/// \returns for each node its distance from `source` along edges of the mesh, infinite where it cannot be reached.
///          Going along a boundary loop costs nothing, as in the closed model.
/// \param g the closed model
/// \param lengths one an edge of `g`, as made by `edge_lengths()`
/// \param source a node
/// \par Complexity
/// Linear where lengths of edges are alike (\cite meyer2003delta). They are Dijkstra's distances to the last bit.
std::vector<double> edge_distances(const Closed_model& g, const std::vector<double>& lengths, Index source);

/// \ingroup PkgMeridianSurface
/// \returns two nodes that are far apart: from the node farthest from the centroid of the vertices, to the node
///          farthest from that along edges, and on as long as the distance grows, at most `sweeps` times. The
///          distance found is at least half of the largest.
/// \param s the surface
/// \param g its closed model
/// \param sweeps at least 1
/// \pre the graph is connected and has at least two nodes
std::pair<Index, Index> find_distant_nodes(const Triangle_surface& s, const Closed_model& g, int sweeps = 2);

namespace internal {

double length(const Triangle_surface& s, const std::vector<Index>& loop);

} // namespace internal

/// \ingroup PkgMeridianOrder
/// \returns the area of each node of a closed model: a third of the faces at its vertices (the lumped mass matrix).
///          None is less than a hundred-millionth of the mean, so that the areas can be divided by; all are 1 if no
///          face has any.
/// \param s the surface
/// \param g its closed model
/// \par Complexity
/// Linear.
std::vector<double> node_areas(const Triangle_surface& s, const Closed_model& g);

} // namespace meridian

#endif // MERIDIAN_SURFACE_MEASURES_H
