// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/extend_cut.h>

#include <meridian/cut/link_boundaries.h>
#include <meridian/cut/link_on_edges.h>
#include <meridian/cut/open_cut.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/insert_curves.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/open_along.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace meridian {

std::vector<Index> extend_cut(const Triangle_surface& root, Cut& cut, const std::vector<Index>& vertices, bool on_edges,
                              const std::vector<char>& kept_out)
{
  std::vector<Index> parents;
  Link_options options;
  options.bifurcations = true;
  options.kept_out = kept_out;
  add_curves(cut, Curve_kind::LINK,
             on_edges ? link_boundaries_on_edges(cut.surface, vertices, kept_out)
                      : link_boundaries(root, cut.surface, options, {}, {}, &parents, vertices));
  open_cut(cut);
  return parents;
}

void divide_border_chords(const Triangle_surface& root, Cut& cut)
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

std::vector<Index> find_stretched_vertices(const Triangle_surface& disc, const Parameterization& map, std::size_t most)
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
