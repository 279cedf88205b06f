// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_INTERNAL_SLEEVE_SEARCH_H
#define MERIDIAN_CUT_INTERNAL_SLEEVE_SEARCH_H

#include <meridian/base/vectors.h>
#include <meridian/curves/sleeve.h>
#include <meridian/cut/internal/slit_surface.h>
#include <meridian/surface/Refined_surface.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <queue>
#include <set>
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
class Sleeve_search
{
public:
  explicit Sleeve_search(Slit_surface& slit)
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
  bool near(Index from, Index to, Sleeve& sleeve) const
  {
    return search(from, sleeve, [&](Index f) { return m_cell[f] == from || m_cell[f] == to; });
  }

  // The same through the whole surface. It fails only if everything is joined.
  bool anywhere(Index from, Sleeve& sleeve) const
  {
    return search(from, sleeve, [](Index) { return true; });
  }

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
    double key;
    Index face, halfedge;
    bool along;
  };
  struct Is_later
  {
    bool operator()(const Growth_event& x, const Growth_event& y) const
    {
      return std::tie(x.key, x.face, x.halfedge) > std::tie(y.key, y.face, y.halfedge);
    }
  };
  using Growth = std::priority_queue<Growth_event, std::vector<Growth_event>, Is_later>;

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

  template <class Is_allowed> bool search(Index from, Sleeve& sleeve, const Is_allowed& is_allowed, Index to = -1) const
  {
    const Refined_surface& s = m_slit.surface();
    std::map<Index, Reached> reached;
    struct Event
    {
      double key;
      Index face, corner;
    };
    const auto later = [](const Event& x, const Event& y) {
      return std::tie(x.key, x.face, x.corner) > std::tie(y.key, y.face, y.corner);
    };
    std::priority_queue<Event, std::vector<Event>, decltype(later)> queue(later);
    const auto reach = [&](Index f, const Reached& r) {
      Reached& old = reached[f];
      if (!(r.distance < old.distance)) { return; }
      old = r;
      queue.push({r.distance, f, -1});
    };
    for_each_corner(from, [&](Index h) {
      if (is_allowed(s.face(h))) { reach(s.face(h), {0, s.points[s.source(h)], h, true}); }
    });
    std::set<Index> done;
    while (!queue.empty())
    {
      const Event e = queue.top();
      queue.pop();
      if (e.corner >= 0)
      {
        sleeve = Sleeve{};
        sleeve.end = s.source(e.corner);
        Index f = s.face(e.corner);
        for (; !reached[f].is_seed; f = s.face(reached[f].by)) { sleeve.halfedges.push_back(reached[f].by); }
        sleeve.start = s.source(reached[f].by);
        std::reverse(sleeve.halfedges.begin(), sleeve.halfedges.end());
        trim(s, sleeve);
        if (is_usable(sleeve)) { return true; }
        continue;
      }
      if (!done.insert(e.face).second) { continue; }
      const Reached r = reached[e.face];
      for (Index h = 3 * e.face; h < 3 * e.face + 3; ++h)
      {
        if (m_slit.loop(h) >= 0
            && (to >= 0 ? m_slit.are_joined(m_slit.loop(h), to) : !m_slit.are_joined(m_slit.loop(h), from)))
          queue.push({r.distance + distance(r.entry, s.points[s.source(h)]), e.face, h});
        if (!m_slit.may_cross(h)) { continue; }
        const Index g = s.face(s.opposite[h]);
        if (!is_allowed(g) || done.count(g)) { continue; }
        const Point middle = s.point_on(h, 0.5);
        reach(g, {r.distance + distance(r.entry, middle), middle, h, false});
      }
    }
    return false;
  }

  Slit_surface& m_slit;
  std::vector<Index> m_cell;      // the boundary whose cell holds each face, -1 where the search did not come
  std::vector<Reached> m_reached; // of the faces that were there when the diagram was grown
  std::size_t m_known_parents;
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CUT_INTERNAL_SLEEVE_SEARCH_H
