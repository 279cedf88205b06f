// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_EXTEND_CUT_H
#define MERIDIAN_UNWRAP_EXTEND_CUT_H

#include <meridian/cut/Cut.h>
#include <meridian/cut/link_boundaries.h>
#include <meridian/cut/link_on_edges.h>
#include <meridian/cut/open_cut.h>
#include <meridian/map/Parameterization.h>
#include <meridian/surface/insert_curves.h>

namespace meridian {

/*!
 * \ingroup PkgMeridianParameterization
 *
 * joins a cut to a further vertex by a shortest path, so that what lies around it can unfold. The disc stays a disc.
 *
 * \param root the surface that was cut
 * \param cut its cut
 * \param vertex a vertex of `cut.surface` that lies on no seam and no boundary
 * \param on_edges whether the path runs along existing edges
 * \par Complexity
 * \f$ O(n \log n) \f$
 */
inline void extend_cut(const Triangle_surface& root, Cut& cut, Index vertex, bool on_edges)
{
  Link_options options;
  options.source = vertex;
  const auto links =
    on_edges ? link_boundaries_on_edges(cut.surface, vertex) : link_boundaries(root, cut.surface, options);
  cut.links.insert(cut.links.end(), links.begin(), links.end());
  open_cut(cut);
}

/*!
 * \ingroup PkgMeridianParameterization
 *
 * divides the edges inside the disc that join two vertices of its border, so that no face has all its corners there. In
 * a map into a polygon, faces along one side would have no area.
 *
 * \param root the surface that was cut
 * \param cut its cut
 * \par Complexity
 * Linear.
 */
inline void divide_border_chords(const Triangle_surface& root, Cut& cut)
{
  const Triangle_surface disc = surface_of(cut.surface, cut.opened); // its halfedges are those of the surface
  std::vector<Surface_curve> middles;
  for (Index h : chords_of_loops(disc, make_closed_model(disc)))
  {
    middles.push_back({{Curve_point::on_edge(h, 0.5)}, false});
  }
  insert_curves(root, cut.surface, middles);
  open_cut(cut);
}

/*!
 * \ingroup PkgMeridianParameterization
 *
 * \returns vertices in the middle of regions that a map stretches more than those around them, the most stretched
 *          first. Stretch is smoothed over a region that grows with the surface.
 * \param disc the surface
 * \param map its map
 * \param most how many at most
 * \par Complexity
 * \f$ O(n^{1.5}) \f$, for the smoothing
 */
inline std::vector<Index> find_stretched_vertices(const Triangle_surface& disc, const Parameterization& map,
                                                  std::size_t most)
{
  const Index n = disc.number_of_vertices();
  std::vector<double> sum(n, 0), area(n, 0);
  for (Index f = 0; f < disc.number_of_faces(); ++f)
  {
    const auto& t = disc.triangles[f];
    const double a = norm(cross(disc.points[t[1]] - disc.points[t[0]], disc.points[t[2]] - disc.points[t[0]]));
    for (Index v : t)
    {
      area[v] += a;
      if (a > 0) { sum[v] += a * map.faces[f].stretch_l2 * map.faces[f].stretch_l2; }
    }
  }
  const int rounds = static_cast<int>(std::sqrt(n) / 4);
  for (int i = 0; i < rounds; ++i)
    for (auto* values : {&sum, &area})
    {
      std::vector<double> next(n, 0);
      for (Index v = 0; v < n; ++v)
      {
        double around = 0;
        int neighbors = 0;
        disc.for_each_outgoing(v, [&](Index h) {
          around += (*values)[disc.target(h)];
          ++neighbors;
        });
        next[v] = ((*values)[v] + around / neighbors) / 2;
      }
      *values = std::move(next);
    }
  const auto key = [&](Index v) { return std::make_pair(area[v] > 0 ? sum[v] / area[v] : 0, -v); };
  std::vector<Index> peaks;
  for (Index v = 0; v < n; ++v)
  {
    if (disc.is_boundary_vertex(v)) { continue; }
    bool is_peak = true;
    disc.for_each_outgoing(v, [&](Index h) {
      is_peak = is_peak && (disc.is_boundary_vertex(disc.target(h)) || key(disc.target(h)) < key(v));
    });
    if (is_peak) { peaks.push_back(v); }
  }
  std::sort(peaks.begin(), peaks.end(), [&](Index v, Index w) { return key(v) > key(w); });
  if (peaks.size() > most) { peaks.resize(most); }
  return peaks;
}

} // namespace meridian

#endif // MERIDIAN_UNWRAP_EXTEND_CUT_H
