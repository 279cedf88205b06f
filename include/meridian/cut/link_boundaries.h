// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_LINK_BOUNDARIES_H
#define MERIDIAN_CUT_LINK_BOUNDARIES_H

#include <meridian/cut/internal/sleeve_search.h>
#include <meridian/cut/internal/slit_surface.h>

#include <functional>

namespace meridian {

/// \ingroup PkgMeridianLinks
/// a way that a link shall take: between the boundaries of the cut surface that two vertices lie on, through faces of
/// the root.
struct Link_guide
{
  Index from, to;
  std::vector<Index> faces; /**< sorted */
};

/// \ingroup PkgMeridianLinks
/// how boundaries are joined.
struct Link_options
{
  std::vector<Link_guide> guides; ///< taken first, as far as no seam is in the way
  bool bifurcations = false;      ///< whether a link may end on an earlier link
  Index source = -1;              ///< a root vertex that the links shall pass through, or -1
  /// told after each link how much is done, from 0 to 1; may throw to end the run
  std::function<void(double)> progress;
};

/*!
 * \ingroup PkgMeridianLinks
 *
 * joins all boundaries of a slit genus-0 surface by a tree of shortest paths, which makes it a disc.
 *
 * The Voronoi diagram of the boundaries is grown until its cells' contacts hold a minimum spanning tree (Kruskal
 * 1956); it gives the pairs. Each link is then found as a strip of faces, moved and pulled until it is locally
 * shortest, and inserted before the next, so that links never cross. The topology rests on strips of different faces
 * that cross no seam, which always exist, and on a union-find of boundaries.
 *
 * A closed surface of genus 0 is opened along a path between two vertices far apart, of at least two edges.
 *
 * \param root the surface that `s` refines
 * \param s the surface. The links are inserted and flagged.
 * \param options see there
 *
 * \returns the links as vertices of `s`
 * \pre cutting `s` along its seams leaves a connected surface of genus 0
 * \post cutting it along all seams leaves a disc
 * \throws Internal_error if two boundaries cannot be joined
 * \par Complexity
 * \f$ O(n \log n) \f$, plus the size of two cells for each link that meets an earlier one
 */
inline std::vector<std::vector<Index>> link_boundaries(const Triangle_surface& root, Refined_surface& s,
                                                       const Link_options& options = Link_options())
{
  internal::Slit_surface slit(root, s, options.bifurcations);
  const bool is_closed = slit.number_of_loops() == 0;
  if (options.source >= 0) { slit.add_point(options.source); }
  if (is_closed && slit.number_of_loops() < 2)
  {
    const auto [from, to] = find_distant_nodes(s, make_closed_model(s));
    for (Index v : {from, to}) { slit.add_point(v); }
  }
  std::vector<std::vector<Index>> links;
  if (slit.number_of_loops() < 2) { return links; } // a disc already

  internal::Sleeve_search search(slit);
  for (const Link_guide& guide : options.guides)
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
    if (options.progress) { options.progress(static_cast<double>(links.size()) / (slit.number_of_loops() - 1)); }
  }
  for (Index loop = 1; loop < slit.number_of_loops(); ++loop) // links that went elsewhere than planned
    while (!slit.are_joined(0, loop))
    {
      internal::Sleeve sleeve;
      if (!search.anywhere(loop, sleeve)) { throw Internal_error("link_boundaries: a boundary cannot be reached"); }
      links.push_back(slit.insert(sleeve));
      search.grow();
    }
  return links;
}

} // namespace meridian

#endif // MERIDIAN_CUT_LINK_BOUNDARIES_H
