// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_MATRICES_H
#define MERIDIAN_MESH_MATRICES_H

#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/map/Parameterization.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/check_surface.h>
#include <meridian/surface/open_along.h>

#include <Eigen/Core>

#include <string>

namespace meridian {

/*!
 * \ingroup PkgMeridianMatrices
 *
 * \returns a surface made of matrices, as libigl has them
 * \declared{meridian/matrices.h}
 *
 * \param V an n x 3 matrix of coordinates
 * \param F an m x 3 matrix of vertex numbers from 0, counterclockwise
 * \throws Invalid_input_error if a matrix has not three columns, a number is not that of a row of `V`, or a coordinate
 *   is not finite; if a vertex has no face, or faces that form several fans
 * \pre each edge has one or two faces, turned alike: see `examine_surface()` for input that may be anything
 * \par Complexity
 * \f$ O(n \log n) \f$
 */
template <class Vertices, class Faces>
Triangle_surface make_triangle_surface(const Eigen::MatrixBase<Vertices>& V, const Eigen::MatrixBase<Faces>& F)
{
  if (V.cols() != 3 || F.cols() != 3)
  {
    throw Invalid_input_error("V has " + std::to_string(V.cols()) + " columns and F has " + std::to_string(F.cols())
                              + "; three each are coordinates and corners");
  }
  Triangle_surface s;
  for (Eigen::Index i = 0; i < V.rows(); ++i)
  {
    s.points.push_back({static_cast<double>(V(i, 0)), static_cast<double>(V(i, 1)), static_cast<double>(V(i, 2))});
    if (!V.row(i).allFinite())
    {
      throw Invalid_input_error("row " + std::to_string(i) + " of V has a coordinate that is not a finite number");
    }
  }
  for (Eigen::Index f = 0; f < F.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (F(f, k) < 0 || static_cast<Eigen::Index>(F(f, k)) >= V.rows())
      {
        throw Invalid_input_error("row " + std::to_string(f) + " of F names vertex " + std::to_string(F(f, k)) + " of "
                                  + std::to_string(V.rows()));
      }
    }
    s.triangles.push_back({static_cast<Index>(F(f, 0)), static_cast<Index>(F(f, 1)), static_cast<Index>(F(f, 2))});
  }
  connect(s);
  check_fans(s);
  return s;
}

/// \ingroup PkgMeridianMatrices
/// \param s the surface
/// \returns its points, a row each
inline Eigen::MatrixX3d vertex_matrix(const Triangle_surface& s)
{
  Eigen::MatrixX3d V(s.number_of_vertices(), 3);
  for (Index v = 0; v < s.number_of_vertices(); ++v) { V.row(v) << s.points[v][0], s.points[v][1], s.points[v][2]; }
  return V;
}

/// \ingroup PkgMeridianMatrices
/// \param s the surface
/// \returns its faces, a row each
inline Eigen::MatrixX3i face_matrix(const Triangle_surface& s)
{
  Eigen::MatrixX3i F(s.number_of_faces(), 3);
  for (Index f = 0; f < s.number_of_faces(); ++f)
  {
    F.row(f) << s.triangles[f][0], s.triangles[f][1], s.triangles[f][2];
  }
  return F;
}

/// \ingroup PkgMeridianMatrices
/// \param s a refined surface
/// \returns its seams as libigl's `igl::cut_mesh()` takes them: row `f` has 1 in column `k` where
///          the edge from corner `k` of face `f` to the next is cut, and 0 elsewhere
inline Eigen::MatrixX3i cut_mask(const Refined_surface& s)
{
  Eigen::MatrixX3i mask(s.number_of_faces(), 3);
  for (Index h = 0; h < s.number_of_halfedges(); ++h) { mask(h / 3, h % 3) = s.seam[h] != 0; }
  return mask;
}

/// \ingroup PkgMeridianMatrices
/// \param map a map of a disc
/// \returns its coordinates, a row for each vertex of the disc, whose faces are the map's
inline Eigen::MatrixX2d uv_matrix(const Parameterization& map)
{
  Eigen::MatrixX2d UV(static_cast<Eigen::Index>(map.at.size()), 2);
  for (Eigen::Index v = 0; v < UV.rows(); ++v) { UV.row(v) << map.at[v][0], map.at[v][1]; }
  return UV;
}

} // namespace meridian

#endif // MERIDIAN_MESH_MATRICES_H
