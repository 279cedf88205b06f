// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_INTERNAL_LINK_SEARCH_H
#define MERIDIAN_CUT_INTERNAL_LINK_SEARCH_H

#include <meridian/base/vectors.h>
#include <meridian/curves/sleeve.h>
#include <meridian/cut/internal/slit_surface.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/shortest_ways.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <tuple>
#include <vector>

namespace meridian {
namespace internal {

// Where two cells of the Voronoi diagram touch: across a halfedge, or along one that joins the two boundaries.
struct Contact
{
  Index from, to, halfedge;
  bool along;
};

// Shortest strips of faces between the boundaries of a slit surface. The distance of a face is measured to the middle
// of the edge by which it was entered.
class Link_search
{
public:
  explicit Link_search(Slit_surface& slit)
    : m_slit(slit), m_cell(slit.surface().number_of_faces(), -1), m_known_parents(slit.parents.size())
  {}

  enum class Extent
  {
    SPANNING, // ends when all boundaries are joined
    WHOLE     // until every face is in a cell
  };

  // The pairs of a minimum spanning tree of the boundaries, nearest first. Contacts come in order, so a longer search
  // finds the same tree.
  std::vector<Contact> find_spanning_contacts(Extent extent = Extent::SPANNING);

  // The strip through the two cells of a contact, if no link has changed a face of it.
  bool along_cells(const Contact& c, Sleeve& sleeve) const;

  // The shortest strip from boundary `from` through its cell and that of `to`, to any boundary not yet joined to it.
  bool near(Index from, Index to, Sleeve& sleeve) const;

  // The same through the whole surface. It fails only if everything is joined.
  bool anywhere(Index from, Sleeve& sleeve) const;

  // The shortest strip from boundary `from` to boundary `to` through parts of the given faces of the root.
  bool along_faces(Index from, Index to, const std::vector<Index>& faces, Sleeve& sleeve) const;

  // Takes over the faces that a link appended.
  void grow();

private:
  struct Reached
  {
    double distance = std::numeric_limits<double>::infinity();
    Point entry{0, 0, 0};
    Index by = -1; // the halfedge by which the face before was left; for a seed, that of its corner
    bool is_seed = false;
  };

  // Cells grow face by face. `face` is reached, or, if it is -1, two cells meet at `halfedge`.
  struct Growth_event
  {
    Index face, halfedge;
    bool along;
    bool operator<(const Growth_event& e) const { return std::tie(face, halfedge) < std::tie(e.face, e.halfedge); }
  };
  using Growth = Nearest_first<Growth_event>;

  // Grows the cells. Returns all contacts on the way, nearest first.
  std::vector<Contact> collect_contacts(Extent extent);
  void seed_cell(Index loop, Growth& growth);
  Contact contact_of(const Growth_event& e) const;
  void leave_face(Index f, const std::vector<char>& is_done, Growth& growth);

  template <class Function> void for_each_corner(Index loop, Function f) const
  {
    for (Index v : m_slit.vertices(loop))
      m_slit.surface().for_each_outgoing(v, [&](Index h) {
        if (m_slit.loop(h) == loop) { f(h); }
      });
  }

  // A strip that was trimmed to nothing must leave an edge that can be cut.
  bool is_usable(const Sleeve& sleeve) const;

  // The shortest strip through allowed faces from boundary `from` to any that is not joined to it, or to those that are
  // joined to `to`.
  bool search(Index from, Sleeve& sleeve, const std::function<bool(Index)>& is_allowed, Index to = -1) const;

  using Reached_faces = std::map<Index, Reached>;
  // The strip back from a corner. False if it cannot be used.
  bool take_strip(Reached_faces& reached, Index corner, Sleeve& sleeve) const;

  Slit_surface& m_slit;
  std::vector<Index> m_cell;      // the boundary whose cell holds each face, -1 where the search did not come
  std::vector<Reached> m_reached; // of the faces that were there when the diagram was grown
  std::size_t m_known_parents;
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CUT_INTERNAL_LINK_SEARCH_H
