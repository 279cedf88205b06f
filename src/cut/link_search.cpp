// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/internal/link_search.h>

#include <meridian/base/Union_find.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/internal/minimum_spanning_tree.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <set>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

std::vector<Contact> Link_search::find_spanning_contacts(Extent extent)
{
  const std::vector<Contact> contacts = collect_contacts(extent);
  // The weight of a contact is its place in the order in which cells meet, so that ties are broken as the search did.
  std::vector<Spanning_edge> edges;
  for (const Contact& c : contacts) { edges.push_back({c.from, c.to, static_cast<double>(edges.size())}); }
  std::vector<Contact> tree;
  for (std::size_t i : minimum_spanning_tree(m_slit.number_of_loops(), edges)) { tree.push_back(contacts[i]); }
  return tree;
}

std::vector<Contact> Link_search::collect_contacts(Extent extent)
{
  const Index faces = m_slit.surface().number_of_faces();
  m_reached.assign(faces, Reached{});
  m_cell.assign(faces, -1);
  m_known_parents = m_slit.parents.size();
  Growth growth;
  for (Index loop = 0; loop < m_slit.number_of_loops(); ++loop) { seed_cell(loop, growth); }
  Union_find joined(m_slit.number_of_loops());
  Index missing = m_slit.number_of_loops() - 1; // links, until all boundaries are joined
  std::vector<Contact> contacts;
  std::vector<char> is_done(faces, 0);
  while (!growth.is_empty() && (missing > 0 || extent == Extent::WHOLE))
  {
    const Growth_event e = growth.pop().second;
    if (e.face < 0)
    {
      contacts.push_back(contact_of(e));
      missing -= joined.unite(contacts.back().from, contacts.back().to);
      continue;
    }
    if (is_done[e.face]) { continue; }
    is_done[e.face] = 1;
    leave_face(e.face, is_done, growth);
  }
  for (Index f = 0; f < faces; ++f)
  {
    if (!is_done[f]) { m_cell[f] = -1; }
  }
  return contacts;
}

void Link_search::seed_cell(Index loop, Growth& growth)
{
  const Refined_surface& s = m_slit.surface();
  for_each_corner(loop, [&](Index h) {
    const Index f = s.face(h), g = s.next(h);
    if (m_slit.detour(f) < m_reached[f].distance)
    {
      m_reached[f] = {m_slit.detour(f), s.points[s.source(h)], h, true};
      m_cell[f] = loop;
      growth.reach(m_reached[f].distance, {f, -1, false});
    }
    for (const Index k : {h, s.prev(h)}) // an edge from this boundary to another
    {
      const Index end = k == h ? g : k;
      if (m_slit.may_cross(k) && m_slit.loop(end) >= 0 && m_slit.loop(end) != loop)
      {
        growth.reach((s.length(k) + m_slit.detour_along(k)) / 2, {-1, k, true});
      }
    }
  });
}

Contact Link_search::contact_of(const Growth_event& e) const
{
  const Refined_surface& s = m_slit.surface();
  const Index a = e.along ? m_slit.loop(e.halfedge) : m_cell[s.face(e.halfedge)];
  const Index b = e.along ? m_slit.loop(s.next(e.halfedge)) : m_cell[s.face(s.opposite[e.halfedge])];
  return {a, b, e.halfedge, e.along};
}

void Link_search::leave_face(Index f, const std::vector<char>& is_done, Growth& growth)
{
  const Refined_surface& s = m_slit.surface();
  for (Index h = 3 * f; h < 3 * f + 3; ++h)
  {
    if (!m_slit.may_cross(h)) { continue; }
    const Index o = s.opposite[h], g = s.face(o);
    const Point middle = s.point_on(h, 0.5);
    const double d = m_reached[f].distance + distance(m_reached[f].entry, middle);
    if (is_done[g])
    {
      if (m_cell[g] != m_cell[f])
        growth.reach((d + m_reached[g].distance + distance(m_reached[g].entry, middle)) / 2, {-1, h, false});
      continue;
    }
    if (d + m_slit.detour(g) < m_reached[g].distance)
    {
      m_reached[g] = {d + m_slit.detour(g), middle, h, false};
      m_cell[g] = m_cell[f];
      growth.reach(m_reached[g].distance, {g, -1, false});
    }
  }
}

bool Link_search::near(Index from, Index to, Sleeve& sleeve) const
{
  return search(from, sleeve, [&](Index f) { return m_cell[f] == from || m_cell[f] == to; });
}

bool Link_search::anywhere(Index from, Sleeve& sleeve) const
{
  return search(from, sleeve, [](Index) { return true; });
}

bool Link_search::search(Index from, Sleeve& sleeve, const std::function<bool(Index)>& is_allowed, Index to) const
{
  const Refined_surface& s = m_slit.surface();
  Reached_faces reached;
  std::set<Index> done;
  Nearest_first<std::pair<Index, Index>> queue; // a face, and the corner of it where a strip ends, or -1
  const auto reach = [&](Index f, const Reached& r) {
    Reached& old = reached[f];
    if (!(r.distance < old.distance)) { return; }
    old = r;
    queue.reach(r.distance, {f, -1});
  };
  const auto is_wanted = [&](Index loop) {
    return loop >= 0 && (to >= 0 ? m_slit.are_joined(loop, to) : !m_slit.are_joined(loop, from));
  };
  for_each_corner(from, [&](Index h) {
    const Index f = s.face(h);
    if (is_allowed(f)) { reach(f, {m_slit.detour(f), s.points[s.source(h)], h, true}); }
  });
  return queue.search([&](double, const std::pair<Index, Index>& place) {
    const auto [f, corner] = place;
    if (corner >= 0) { return take_strip(reached, corner, sleeve); }
    if (!done.insert(f).second) { return false; }
    const Reached r = reached[f];
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      if (is_wanted(m_slit.loop(h))) { queue.reach(r.distance + distance(r.entry, s.points[s.source(h)]), {f, h}); }
      if (!m_slit.may_cross(h)) { continue; }
      const Index g = s.face(s.opposite[h]);
      if (!is_allowed(g) || done.count(g)) { continue; }
      const Point middle = s.point_on(h, 0.5);
      reach(g, {r.distance + distance(r.entry, middle) + m_slit.detour(g), middle, h, false});
    }
    return false;
  });
}

bool Link_search::take_strip(Reached_faces& reached, Index corner, Sleeve& sleeve) const
{
  const Refined_surface& s = m_slit.surface();
  sleeve = Sleeve{};
  sleeve.end = s.source(corner);
  Index f = s.face(corner);
  for (; !reached[f].is_seed; f = s.face(reached[f].by)) { sleeve.halfedges.push_back(reached[f].by); }
  sleeve.start = s.source(reached[f].by);
  std::reverse(sleeve.halfedges.begin(), sleeve.halfedges.end());
  trim(s, sleeve);
  return is_usable(sleeve);
}

bool Link_search::along_cells(const Contact& c, Sleeve& sleeve) const
{
  const Refined_surface& s = m_slit.surface();
  if (c.along)
  {
    const auto& changed = m_slit.was_changed();
    const Index f = s.face(c.halfedge);
    if (f < static_cast<Index>(changed.size()) && changed[f]) { return false; }
    if (!m_slit.may_cross(c.halfedge)) { return false; }
    sleeve = {s.source(c.halfedge), s.target(c.halfedge), {}};
    return true;
  }
  sleeve = Sleeve{};
  const auto& changed = m_slit.was_changed();
  const auto is_changed = [&](Index f) { return f < static_cast<Index>(changed.size()) && changed[f]; };
  Index f = s.face(c.halfedge);
  for (; !is_changed(f) && !m_reached[f].is_seed; f = s.face(m_reached[f].by))
  {
    sleeve.halfedges.push_back(m_reached[f].by);
  }
  if (is_changed(f)) { return false; }
  sleeve.start = s.source(m_reached[f].by);
  std::reverse(sleeve.halfedges.begin(), sleeve.halfedges.end());
  sleeve.halfedges.push_back(c.halfedge);
  if (is_changed(s.face(s.opposite[c.halfedge]))) { return false; }
  for (f = s.face(s.opposite[c.halfedge]); !is_changed(f) && !m_reached[f].is_seed; f = s.face(m_reached[f].by))
    sleeve.halfedges.push_back(s.opposite[m_reached[f].by]);
  if (is_changed(f)) { return false; }
  sleeve.end = s.source(m_reached[f].by);
  trim(s, sleeve);
  for (Index h : sleeve.halfedges)
  {
    if (!m_slit.may_cross(h)) { return false; }
  } // a link may run along an edge
  return is_usable(sleeve);
}

bool Link_search::along_faces(Index from, Index to, const std::vector<Index>& faces, Sleeve& sleeve) const
{
  const auto is_allowed = [&](Index f) {
    return std::binary_search(faces.begin(), faces.end(), m_slit.surface().face_of[f]);
  };
  return search(from, sleeve, is_allowed, to);
}

void Link_search::grow()
{
  const auto& parents = m_slit.parents;
  for (std::size_t i = m_known_parents; i < parents.size(); ++i) { m_cell.push_back(m_cell[parents[i]]); }
  m_known_parents = parents.size();
}

bool Link_search::is_usable(const Sleeve& sleeve) const
{
  if (!sleeve.halfedges.empty()) { return true; }
  if (sleeve.start == sleeve.end) { return false; }
  const Refined_surface& s = m_slit.surface();
  const Index h = s.find_halfedge(sleeve.start, sleeve.end);
  return h >= 0 && m_slit.may_cross(h);
}

} // namespace internal

} // namespace meridian
