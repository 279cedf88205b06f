// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/internal/flat_regions.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace meridian {

namespace internal {

Index characteristic_around(const Triangle_surface& s, const Closed_model& g, const std::vector<Index>& nodes)
{
  std::vector<Index> faces, edges, corners;
  for (Index a : nodes)
    for (Index i = g.begin[a]; i < g.begin[a + 1]; ++i)
    {
      faces.push_back(s.face(g.halfedge[i]));
      faces.push_back(s.face(s.opposite[g.halfedge[i]]));
    }
  const auto unique = [](std::vector<Index>& v) {
    std::sort(v.begin(), v.end());
    v.erase(std::unique(v.begin(), v.end()), v.end());
  };
  unique(faces);
  for (Index f : faces)
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      corners.push_back(g.node[s.source(h)]);
      if (s.opposite[h] >= 0) { edges.push_back(s.edge(h)); } // a boundary edge is a point of the model
    }
  unique(edges);
  unique(corners);
  return static_cast<Index>(corners.size()) - static_cast<Index>(edges.size()) + static_cast<Index>(faces.size());
}

void solve_flat_regions(const Triangle_surface& s, const Closed_model& g, Laplace_system& system,
                        std::vector<Index> nodes, Scalar_field& field)
{
  const Closed_model& joined = system.graph();
  // Far below what draws a smooth contour, and far above the rounding of the solution, or above what it leaves.
  const double flat = std::max(1e-11, 0.1 * system.residual());
  std::vector<std::pair<Index, std::vector<Index>>> open; // a region and its nodes
  open.emplace_back(0, std::move(nodes));
  std::vector<Index> mark(g.number_of_nodes, -1); // the last region in which a node was found flat
  while (!open.empty())
  {
    const auto [region, inside] = std::move(open.back());
    open.pop_back();
    std::vector<Index> flats;
    for (Index a : inside)
    {
      const double x = field.value[a];
      bool is_flat = true;
      for (Index i = joined.begin[a]; i < joined.begin[a + 1] && is_flat; ++i)
        is_flat = std::abs(field.value_in(region, joined.neighbor[i]) - x) <= flat;
      if (is_flat)
      {
        flats.push_back(a);
        mark[a] = region;
      }
    }
    for (Index seed : flats)
    {
      if (mark[seed] != region) { continue; }
      std::vector<Index> part{seed}, rim;
      mark[seed] = -1;
      for (std::size_t i = 0; i < part.size(); ++i)
        for (Index e = joined.begin[part[i]]; e < joined.begin[part[i] + 1]; ++e)
          if (mark[joined.neighbor[e]] == region)
          {
            mark[joined.neighbor[e]] = -1;
            part.push_back(joined.neighbor[e]);
          }
      if (part.size() == inside.size() || characteristic_around(s, g, part) == 1) { continue; }
      std::sort(part.begin(), part.end());
      for (Index a : part)
        for (Index e = joined.begin[a]; e < joined.begin[a + 1]; ++e)
          if (!std::binary_search(part.begin(), part.end(), joined.neighbor[e])) { rim.push_back(joined.neighbor[e]); }
      std::sort(rim.begin(), rim.end());
      rim.erase(std::unique(rim.begin(), rim.end()), rim.end());
      if (rim.empty()) { continue; }

      Scalar_field::Region r{region, 0, 0};
      for (Index a : rim) { r.offset += field.value_in(region, a) / static_cast<double>(rim.size()); }
      for (Index a : rim) { r.scale = std::max(r.scale, std::abs(field.value_in(region, a) - r.offset)); }
      if (!(r.scale > 0)) { continue; } // nothing to magnify: the order is flooded instead
      const Index index = static_cast<Index>(field.regions.size());
      field.regions.push_back(r);
      if (field.region.empty()) { field.region.assign(g.number_of_nodes, 0); }
      system.solve(
        part, [&](Index a) { return field.value_in(index, a); }, field.value);
      for (Index a : part) { field.region[a] = index; }
      open.emplace_back(index, std::move(part));
    }
  }
}

} // namespace internal

} // namespace meridian
