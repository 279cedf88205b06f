// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_MINIMIZE_DISTORTION_H
#define MERIDIAN_MAP_MINIMIZE_DISTORTION_H

#include <meridian/base/Progress_observer.h>
#include <meridian/base/vectors.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/map/Distortion_energy.h>
#include <meridian/map/internal/distortion_energy.h>
#include <meridian/map/internal/distortion_hessian.h>
#include <meridian/surface/Triangle_surface.h>

#include <array>
#include <memory>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// a vertex, and where a map shall have it.
struct Map_pin
{
  Index vertex;   ///< the vertex
  Plane_point at; ///< where it shall be
};

/// \ingroup PkgMeridianParameterization
/// what `minimize_distortion()` lowers, and when it ends.
struct Distortion_options
{
  Distortion_energy energy = Distortion_energy::SYMMETRIC_DIRICHLET; ///< what is lowered
  int iterations = 100;                                              ///< at most
  /// it ends when no more than this part of the energy can be gained by a step
  double least_gain = 1e-3;
  bool has_free_border = true;                     ///< whether the border may move
  Make_solver make_solver = make_symmetric_solver; ///< makes the solver of each step
  std::vector<Map_pin> pins = {};                  ///< vertices that springs draw to where they shall be
  /// of the springs: their energy is so many times the square of their length, where that of the image is its area
  double stiffness = 0;
};

namespace internal {

// The shape that a face should have in the plane: its own, if it has one. A face that is all but degenerate is made a
// little higher, and its longest side at least `least` long.
Rest_triangle rest_triangle(const Triangle_surface& s, const std::array<Index, 3>& t, double least);
// Those of all faces.
std::vector<Rest_triangle> rest_triangles(const Triangle_surface& s);

// Newton's method on the map of a disc. Its border stays where it is, or moves and is kept a simple polygon.
class Distortion_minimizer
{
public:
  // `options`: all but its limits. `is_near`: whether the map has the shape that it will have, but for small parts.
  // Then what is outside resists less to begin with, and squeezed vertices are moved one by one before a step, if they
  // were in the way of the last. From far away that would only crumple the border.
  Distortion_minimizer(const Triangle_surface& disc, std::vector<Plane_point>& at, const Distortion_options& options,
                       bool is_near = false);

  // Moves the points. Returns the part of the energy that the step could have gained, if nothing had been in its way.
  double step();
  // Makes springs so many times as stiff.
  void stiffen(double factor) { m_stiffness *= factor; }
  // The part of the energy that the last step gained.
  double gained() const { return m_gained; }

private:
  // Moves squeezed vertices.
  void relax(std::vector<Plane_point>& with_box);

  // Triangulates what is outside, which resists being squeezed. Its triangles are made anew for each step, so that they
  // can give way. The corners of a box around it all are appended to the points.
  void surround(std::vector<Plane_point>& with_box);

  double energy(const std::vector<Plane_point>& at) const;
  void add_springs(const std::vector<Plane_point>& at);

  // Newton's direction, and the slope along it.
  double find_direction(const std::vector<Plane_point>& at, std::vector<Plane_point>& move);

  std::vector<Plane_point>& m_at;
  std::unique_ptr<Sparse_solver> m_solver; // one for all steps
  const Distortion_energy m_energy;
  const bool m_has_free_border;
  std::vector<Rest_triangle> m_faces, m_outside;
  Distortion_hessian m_hessian;
  std::vector<double> m_solution;
  std::vector<Index> m_loop;
  double m_area = 0;
  const std::vector<Map_pin> m_pins;
  double m_stiffness; // of a spring, in the unit of the energy
  const bool m_is_near;
  double m_resistance;          // of what is outside, as a part of that of the disc
  std::vector<char> m_may_move; // of each vertex, and of the box
  double m_gained = 0;
  bool m_was_short = true; // whether something was in the way of the last step
  bool m_is_roomy = false; // whether the border has room between its sides, as it then keeps
  bool m_is_first = true;  // whether no step was made yet
};

} // namespace internal

/*!
 * \ingroup PkgMeridianParameterization
 *
 * lowers the distortion of a map.
 *
 * An energy, by itself the symmetric Dirichlet energy (\cite smith2015), is minimized by Newton's method with the
 * Hessian's negative part left out (\cite smith2019). If the border may move, the plane outside of the image is
 * triangulated and resists too, so that it does not run into itself (\cite jiang2017). A step is taken only if no face
 * is turned over and the border is a simple polygon, both decided exactly: then the map is one-to-one. The surface is
 * thought scaled to the area that the image has at the beginning.
 *
 * \param disc the surface
 * \param at the image of each vertex
 * \param options see there
 * \param progress told how much is done
 *
 * \pre `disc` is a disc; in `at` no face is turned over or without area, and the border is a simple polygon
 * \throws Solver_error if a step cannot be solved; `at` is then the map after the step before
 * \par Complexity
 * One factorization of twice as many equations as vertices for each step.
 */
void minimize_distortion(const Triangle_surface& disc, std::vector<Plane_point>& at,
                         const Distortion_options& options = Distortion_options(), const Progress& progress = {});

} // namespace meridian

#endif // MERIDIAN_MAP_MINIMIZE_DISTORTION_H
