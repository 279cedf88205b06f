// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/internal/untouched_stars.h>

#include <meridian/base/exceptions.h>

#include <string>

namespace meridian {

namespace internal {

void check_stars(const Triangle_surface& root, const Triangle_surface& disc, const std::vector<Index>& untouched)
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

std::vector<double> weights_on_disc(const Triangle_surface& root, const Triangle_surface& disc,
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

} // namespace internal

} // namespace meridian
