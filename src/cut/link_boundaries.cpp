// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/link_boundaries.h>

#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/sleeve.h>
#include <meridian/cut/internal/link_search.h>
#include <meridian/cut/internal/slit_surface.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/measures.h>

#include <algorithm>
#include <vector>

namespace meridian {

std::vector<std::vector<Index>> link_boundaries(const Triangle_surface& root, Refined_surface& s,
                                                const Link_options& options, const std::vector<Link_guide>& guides,
                                                const Progress& progress, std::vector<Index>* parents,
                                                const std::vector<Index>& points)
{
  internal::Slit_surface slit(root, s, options.bifurcations, options.kept_out);
  const bool is_closed = slit.number_of_loops() == 0;
  if (options.source >= 0) { slit.add_point(options.source); }
  for (Index v : points) { slit.add_point(v); }
  if (is_closed && slit.number_of_loops() < 2)
  {
    const auto [from, to] = find_distant_nodes(s, make_closed_model(s));
    for (Index v : {from, to}) { slit.add_point(v); }
  }
  std::vector<std::vector<Index>> links;
  if (slit.number_of_loops() < 2) { return links; } // a disc already

  internal::Link_search search(slit);
  for (const Link_guide& guide : guides)
  {
    internal::Sleeve sleeve;
    const Index from = slit.loop(s.outgoing[guide.from]), to = slit.loop(s.outgoing[guide.to]);
    if (from < 0 || to < 0 || slit.are_joined(from, to)) { continue; }
    if (!search.along_faces(from, to, guide.faces, sleeve)) { continue; } // something is in the way
    links.push_back(slit.insert(sleeve));
    search.grow();
  }
  for (const auto& contact : search.find_spanning_contacts())
  {
    if (slit.are_joined(contact.from, contact.to)) { continue; }
    internal::Sleeve sleeve;
    if (!search.along_cells(contact, sleeve) && !search.near(contact.from, contact.to, sleeve)
        && !search.anywhere(contact.from, sleeve))
      throw Internal_error("link_boundaries: a boundary cannot be reached");
    links.push_back(slit.insert(sleeve));
    search.grow();
    if (progress) { progress(static_cast<double>(links.size()) / (slit.number_of_loops() - 1)); }
  }
  std::vector<Index> firsts{0}; // of each piece, a boundary
  for (Index loop = 1; loop < slit.number_of_loops(); ++loop)
  {
    const auto is_known = [&] {
      return std::any_of(firsts.begin(), firsts.end(), [&](Index a) { return slit.are_joined(a, loop); });
    };
    while (!is_known()) // a link went elsewhere than planned, or the piece is another
    {
      internal::Sleeve sleeve;
      if (!search.anywhere(loop, sleeve))
      {
        firsts.push_back(loop);
        break;
      }
      links.push_back(slit.insert(sleeve));
      search.grow();
    }
  }
  if (parents) { parents->insert(parents->end(), slit.parents.begin(), slit.parents.end()); }
  return links;
}

} // namespace meridian
