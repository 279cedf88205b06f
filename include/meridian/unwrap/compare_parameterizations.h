// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_COMPARE_PARAMETERIZATIONS_H
#define MERIDIAN_UNWRAP_COMPARE_PARAMETERIZATIONS_H

#include <meridian/map/distortion.h>
#include <meridian/map/map_into_polygon.h>
#include <meridian/result/discs_of.h>
#include <meridian/surface/measures.h>
#include <meridian/unwrap/internal/bound_spectral_norm.h>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// the linear maps into a circle that can be compared.
enum class Map_weights
{
  UNIFORM,  ///< all weights are 1 (Tutte 1963)
  POSITIVE, ///< `Weights::POSITIVE`: mean-value weights made symmetric (Floater 2003)
  COTANGENT ///< `Weights::COTANGENT`: discrete harmonic maps (Eck et al. 1995). Faces may be turned over
};

/// \ingroup PkgMeridianParameterization
/// \returns the name of the weights of a map as it stands in reports
inline const char* name_of(Map_weights weights)
{
  switch (weights)
  {
  case Map_weights::UNIFORM: return "uniform";
  case Map_weights::POSITIVE: return "positive";
  case Map_weights::COTANGENT: return "cotangent";
  }
  return "";
}

/// \ingroup PkgMeridianParameterization
/// \returns the weight of each halfedge of a surface, equal on twins
inline std::vector<double> map_weights(const Triangle_surface& s, Map_weights kind)
{
  if (kind == Map_weights::UNIFORM) { return std::vector<double>(s.number_of_halfedges(), 1.); }
  return edge_weights(s, kind == Map_weights::POSITIVE ? Weights::POSITIVE : Weights::COTANGENT);
}

/// \ingroup PkgMeridianParameterization
/// two maps of one surface, each of a disc that it was cut into. `J` is `untouched`; the maps are in one gauge, and
/// norms are Frobenius norms of both coordinates, rows `J`. All is 0 if `J` is empty.
struct Map_comparison
{
  std::vector<Index> untouched;               ///< the vertices of the root that count
  std::array<std::vector<Plane_point>, 2> at; ///< the images of each disc's vertices, in the common gauge
  double variation = 0;                       ///< \f$ \| x_J - y_J \| \f$
  double bound = 0;                           ///< the lower bound of the variation; see `compare_maps()`
  double discrepancy = 0;                     ///< \f$ \| b_x - b_y \| \f$
  /// an upper bound of \f$ \| L_{JJ} \|_2 \f$, as a rule less than a thousandth too large
  double norm = 0;
  /// of each map: \f$ \| L_{JJ} x_J - b_x \| / (\| L_{JJ} \|_2 \| x \|) \f$, with x at `J` and all its neighbours
  std::array<double, 2> residual{0, 0};
  double diameter = 0;                  ///< of a circle with the area of the images
  double relative_variation = 0;        ///< root mean square of the distances over `J`, in diameters
  double relative_bound = 0;            ///< the bound in the same measure
  std::array<Distortion, 2> distortion; ///< of each map, over its whole disc
  std::array<Index, 2> flipped{0, 0};   ///< faces that are not counterclockwise, counted exactly
};

namespace internal {

// The rows J of a surface's Laplacian: the columns J as a matrix, the others as a list.
class Untouched_rows
{
public:
  using Columns = Eigen::Matrix<double, Eigen::Dynamic, 2>;

  Untouched_rows(const Triangle_surface& root, const std::vector<double>& weights, const std::vector<Index>& untouched)
    : m_untouched(untouched), m_inside(untouched.size(), untouched.size())
  {
    std::vector<Index> row(root.number_of_vertices(), -1);
    for (std::size_t i = 0; i < untouched.size(); ++i) { row[untouched[i]] = static_cast<Index>(i); }
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < untouched.size(); ++i)
    {
      double diagonal = 0;
      root.for_each_outgoing(untouched[i], [&](Index h) {
        const Index w = root.target(h);
        diagonal += weights[h];
        if (row[w] >= 0) { entries.emplace_back(static_cast<Index>(i), row[w], -weights[h]); }
        else { m_outside.push_back({static_cast<Index>(i), w, -weights[h]}); }
      });
      entries.emplace_back(static_cast<Index>(i), static_cast<Index>(i), diagonal);
    }
    m_inside.setFromTriplets(entries.begin(), entries.end());
  }
  const Eigen::SparseMatrix<double>& inside() const { return m_inside; }

  Columns values(const std::vector<Plane_point>& at) const // x_J
  {
    Columns x(m_untouched.size(), 2);
    for (std::size_t i = 0; i < m_untouched.size(); ++i)
      for (int k = 0; k < 2; ++k) { x(i, k) = at[m_untouched[i]][k]; }
    return x;
  }
  Columns right_side(const std::vector<Plane_point>& at) const // b
  {
    Columns b = Columns::Zero(m_untouched.size(), 2);
    for (const Entry& e : m_outside)
      for (int k = 0; k < 2; ++k) { b(e.row, k) -= e.weight * at[e.vertex][k]; }
    return b;
  }

private:
  struct Entry
  {
    Index row, vertex;
    double weight;
  };
  const std::vector<Index>& m_untouched;
  Eigen::SparseMatrix<double> m_inside;
  std::vector<Entry> m_outside;
};

// Throws unless the faces at the untouched vertices are faces of a disc, with the same vertices in the same places.
inline void check_stars(const Triangle_surface& root, const Triangle_surface& disc, const std::vector<Index>& untouched)
{
  for (Index v : untouched)
    root.for_each_outgoing(v, [&](Index h) {
      const Index g = disc.outgoing[v] < 0 ? -1 : disc.find_halfedge(v, root.target(h));
      if (g < 0 || disc.opposite[g] < 0 || disc.apex(g) != root.apex(h)
          || disc.points[disc.target(g)] != root.points[root.target(h)])
        throw Invalid_input_error("compare_maps: a face at vertex " + std::to_string(v)
                                  + " is not a face of the disc; was the disc made of another surface?");
    });
}

// The weights of a disc, with those of the root at the untouched vertices.
inline std::vector<double> weights_on_disc(const Triangle_surface& root, const Triangle_surface& disc,
                                           const std::vector<Index>& untouched, const std::vector<double>& on_root,
                                           std::vector<double> on_disc)
{
  for (Index v : untouched)
    root.for_each_outgoing(v, [&](Index h) {
      const Index g = disc.find_halfedge(v, root.target(h));
      on_disc[g] = on_root[h];
      on_disc[disc.opposite[g]] = on_root[root.opposite[h]];
    });
  return on_disc;
}

// Scales a map to an area and brings the centroid of the given vertices to the origin.
inline void scale_and_center(const Triangle_surface& disc, double area, const std::vector<Index>& vertices,
                             std::vector<Plane_point>& at)
{
  const double image = area_of(disc.triangles, at);
  if (!(image > 0)) { throw Invalid_input_error("compare_maps: the image of a map has no positive area"); }
  const double factor = std::sqrt(area / image);
  for (Plane_point& p : at) { p = factor * p; }
  Plane_point centroid{0, 0};
  for (Index v : vertices) { centroid = centroid + (1. / static_cast<double>(vertices.size())) * at[v]; }
  for (Plane_point& p : at) { p = p - centroid; }
}

// Turns the second map about the origin so that the sum of the squared distances at the given vertices is least.
inline void turn_onto(const std::vector<Plane_point>& first, const std::vector<Index>& vertices,
                      std::vector<Plane_point>& second)
{
  double c = 0, s = 0;
  for (Index v : vertices)
  {
    c += dot(second[v], first[v]);
    s += cross(second[v], first[v]);
  }
  const double length = std::hypot(c, s);
  if (!(length > 0)) { return; }
  c /= length;
  s /= length;
  for (Plane_point& p : second) { p = {c * p[0] - s * p[1], s * p[0] + c * p[1]}; }
}

} // namespace internal

/*!
 * \ingroup PkgMeridianParameterization
 *
 * \returns the vertices that two cuts leave alone, ascending: neither cut touches a vertex within two edges, and
 *          neither the vertex nor a neighbour lies on the boundary of the root.
 *
 * So the faces at these vertices and at their neighbours are the same in both discs, their neighbours are inner
 * vertices of both, and the right-hand sides come from the maps and not from the circle.
 *
 * \param root the surface
 * \param first, second two discs of it
 * \throws Invalid_input_error if a disc has flags for another number of vertices
 * \par Complexity
 * Linear.
 */
inline std::vector<Index> find_untouched_vertices(const Triangle_surface& root, const Cut_disc& first,
                                                  const Cut_disc& second)
{
  const Index n = root.number_of_vertices();
  for (const Cut_disc* d : {&first, &second})
    if (d->is_touched.size() != root.points.size() || d->disc.number_of_vertices() < n)
      throw Invalid_input_error("find_untouched_vertices: a disc does not have the vertices of the surface");
  std::vector<char> is_near(n, 0), is_excluded(n, 0); // within one edge, within two
  const auto spread = [&](const std::vector<char>& from, std::vector<char>& to) {
    for (const auto& t : root.triangles)
    {
      if (from[t[0]] || from[t[1]] || from[t[2]]) { to[t[0]] = to[t[1]] = to[t[2]] = 1; }
    }
  };
  std::vector<char> is_start(n, 0);
  for (Index v = 0; v < n; ++v) { is_start[v] = first.is_touched[v] || second.is_touched[v]; }
  spread(is_start, is_near);
  for (Index v = 0; v < n; ++v)
  {
    if (root.outgoing[v] < 0 || root.is_boundary_vertex(v)) { is_near[v] = 1; }
  }
  spread(is_near, is_excluded);
  std::vector<Index> untouched;
  for (Index v = 0; v < n; ++v)
  {
    if (!is_excluded[v] && root.outgoing[v] >= 0) { untouched.push_back(v); }
  }
  return untouched;
}

/*!
 * \ingroup PkgMeridianParameterization
 *
 * \returns the norm of \f$ \sum_w \omega_{vw} (x_v - x_w) \f$ over the rows `v` in `untouched`, both coordinates: how
 *          far a map is from obeying its equations. Recounted from stars of the surface, with no matrix.
 * \param root the surface
 * \param weights one for each halfedge
 * \param untouched inner vertices
 * \param at the image of each vertex
 */
inline double laplacian_residual(const Triangle_surface& root, const std::vector<double>& weights,
                                 const std::vector<Index>& untouched, const std::vector<Plane_point>& at)
{
  double square = 0;
  for (Index v : untouched)
  {
    Plane_point sum{0, 0};
    root.for_each_outgoing(v, [&](Index h) { sum = sum + weights[h] * (at[v] - at[root.target(h)]); });
    square += dot(sum, sum);
  }
  return std::sqrt(square);
}

/*!
 * \ingroup PkgMeridianParameterization
 *
 * compares two maps of one surface, each of a disc that it was cut into, and bounds from below how far they differ
 * (Patane 2007, section 5).
 *
 * Let `J` be the vertices that neither cut touches, see `find_untouched_vertices()`, and `L` the Laplacian of the
 * surface. Its rows `J` are rows of the Laplacians of both discs, because weights depend on the faces at an edge. A
 * linear method, which asks for
 * \f$ L x = 0 \f$ at inner vertices, gives \f$ L_{JJ} x_J = b_x := -L_{J,N(J) \setminus J} x \f$, for the second map
 * likewise, and so
 * \f[ \| x_J - y_J \|_F \ge \| b_x - b_y \|_F / \| L_{JJ} \|_2 . \f]
 * Both coordinates are the columns of one matrix; the 2-norm is right for them, since \f$ \| A X \|_F \le \| A \|_2 \|
 * X \|_F \f$ column by column. Twice the residuals of both maps, and what rounding may add, are taken off the
 * numerator: so the bound holds in floating point too, and it holds, though it may be 0, for maps that do not obey the
 * equations.
 *
 * The gauge: both maps are scaled to the area of the surface, the centroid of `J` comes to the origin in both, and the
 * second is turned as brings it nearest to the first at `J`. It is the best rigid motion in the least squares sense;
 * nothing is scaled or mirrored to fit. Applied to a whole map, an affine map keeps \f$ L x = 0 \f$, because the rows
 * of `L` add up to zero, so that both equations still hold.
 *
 * \param root the surface
 * \param first, second two discs of it
 * \param weights one for each halfedge of the surface, equal on twins; their matrix is positive semidefinite
 * \param at the image of each vertex of each disc. Least squares conformal maps (Levy et al. 2002) obey the equations
 *   of cotangent weights at all vertices but the boundary and those that are pinned
 *
 * \throws Invalid_input_error if a disc is not one of this surface, or the surface or an image has no area
 * \par Complexity
 * One factorization, \f$ O(n^{1.5}) \f$, and some hundred products of a matrix and a vector.
 */
inline Map_comparison compare_maps(const Triangle_surface& root, const Cut_disc& first, const Cut_disc& second,
                                   const std::vector<double>& weights, std::array<std::vector<Plane_point>, 2> at)
{
  Map_comparison c;
  c.untouched = find_untouched_vertices(root, first, second);
  const double surface = area(root);
  if (!(surface > 0)) { throw Invalid_input_error("compare_maps: the surface has no area"); }
  c.diameter = 2 * std::sqrt(surface / std::acos(-1.));
  c.at = std::move(at);
  const std::array<const Triangle_surface*, 2> discs{&first.disc, &second.disc};
  for (int i = 0; i < 2; ++i)
  {
    if (c.at[i].size() != discs[i]->points.size())
    {
      throw Invalid_input_error("compare_maps: a map does not have one image for each vertex of its disc");
    }
    internal::check_stars(root, *discs[i], c.untouched);
    internal::scale_and_center(*discs[i], surface, c.untouched, c.at[i]);
  }
  internal::turn_onto(c.at[0], c.untouched, c.at[1]);
  for (int i = 0; i < 2; ++i)
  {
    c.distortion[i] = measure_distortion(discs[i]->points, discs[i]->triangles, c.at[i],
                                         measure_faces(discs[i]->points, discs[i]->triangles, c.at[i]));
    c.flipped[i] = static_cast<Index>(find_flipped_faces(discs[i]->triangles, c.at[i]).size());
  }
  if (c.untouched.empty()) { return c; }

  const internal::Untouched_rows rows(root, weights, c.untouched);
  c.norm = internal::bound_spectral_norm(rows.inside());
  c.variation = (rows.values(c.at[0]) - rows.values(c.at[1])).norm();
  c.discrepancy = (rows.right_side(c.at[0]) - rows.right_side(c.at[1])).norm();
  std::vector<char> is_counted(root.number_of_vertices(), 0);
  for (Index v : c.untouched)
  {
    root.for_each_outgoing(v, [&](Index h) { is_counted[v] = is_counted[root.target(h)] = 1; });
  }
  double allowance = 0;
  for (int i = 0; i < 2; ++i)
  {
    double square = 0;
    for (Index v = 0; v < root.number_of_vertices(); ++v)
    {
      if (is_counted[v]) { square += dot(c.at[i][v], c.at[i][v]); }
    }
    const double scale = c.norm * std::sqrt(square), residual = laplacian_residual(root, weights, c.untouched, c.at[i]);
    if (scale > 0) { c.residual[i] = residual / scale; }
    allowance += 2 * residual + 8 * std::numeric_limits<double>::epsilon() * scale;
  }
  if (c.norm > 0) { c.bound = std::max(c.discrepancy - allowance, 0.) / c.norm; }
  const double unit = std::sqrt(static_cast<double>(c.untouched.size())) * c.diameter;
  c.relative_variation = c.variation / unit;
  c.relative_bound = c.bound / unit;
  return c;
}

/*!
 * \ingroup PkgMeridianParameterization
 *
 * maps two discs of one surface into circles, by the same linear method, and compares the maps. See `compare_maps()`.
 *
 * An edge at `J` takes the weight that it has on the surface. Both discs would give it the same one, bit for bit, but
 * at faces that are all but without area, where weights are bounded relative to the mean length of a surface's edges.
 *
 * \param root the surface, connected
 * \param first, second two discs of it
 * \param kind the method
 *
 * \returns the comparison
 * \throws Invalid_input_error if a disc has not one boundary loop, is not one of this surface, or the surface has no
 *   area; Solver_error if a system cannot be factorized
 * \par Complexity
 * Three factorizations.
 */
inline Map_comparison compare_parameterizations(const Triangle_surface& root, const Cut_disc& first, const Cut_disc& second,
                                         Map_weights kind = Map_weights::POSITIVE)
{
  const std::vector<Index> untouched = find_untouched_vertices(root, first, second);
  const std::vector<double> weights = map_weights(root, kind);
  const auto map = [&](const Triangle_surface& disc) {
    internal::check_stars(root, disc, untouched);
    const auto loops = boundary_loops(disc);
    if (loops.size() != 1)
      throw Invalid_input_error("compare_parameterizations: a disc has one boundary loop, not "
                                + std::to_string(loops.size()));
    const std::vector<double> on_disc =
      internal::weights_on_disc(root, disc, untouched, weights, map_weights(disc, kind));
    return map_into_polygon(disc, on_disc, loops.front(),
                                             place_on_circle(places_along(disc, loops.front())));
  };
  return compare_maps(root, first, second, weights, {map(first.disc), map(second.disc)});
}

} // namespace meridian

#endif // MERIDIAN_UNWRAP_COMPARE_PARAMETERIZATIONS_H
