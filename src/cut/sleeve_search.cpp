// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/internal/sleeve_search.h>

#include <numeric>

namespace meridian {

namespace internal {

std::vector<Contact> Sleeve_search::find_spanning_contacts()
{
  const Refined_surface& s = m_slit.surface();
  const Index faces = s.number_of_faces();
  m_reached.assign(faces, Reached{});
  m_cell.assign(faces, -1);
  m_known_parents = m_slit.parents.size();
  std::vector<Index> joined(m_slit.number_of_loops());
  std::iota(joined.begin(), joined.end(), Index(0));
  const auto find = [&](Index a) {
    while (joined[a] != a) { a = joined[a] = joined[joined[a]]; }
    return a;
  };

  struct Event
  {
    double key;
    Index face, halfedge;
    bool along;
  };
  const auto later = [](const Event& x, const Event& y) {
    return std::tie(x.key, x.face, x.halfedge) > std::tie(y.key, y.face, y.halfedge);
  };
  std::priority_queue<Event, std::vector<Event>, decltype(later)> queue(later);
  for (Index loop = 0; loop < m_slit.number_of_loops(); ++loop)
    for_each_corner(loop, [&](Index h) {
      const Index f = s.face(h), g = s.next(h);
      if (m_reached[f].distance > 0)
      {
        m_reached[f] = {0, s.points[s.source(h)], h, true};
        m_cell[f] = loop;
        queue.push({0, f, -1, false});
      }
      for (const Index k : {h, s.prev(h)}) // an edge from this boundary to another
      {
        const Index end = k == h ? g : k;
        if (m_slit.may_cross(k) && m_slit.loop(end) >= 0 && m_slit.loop(end) != loop)
        {
          queue.push({s.length(k) / 2, -1, k, true});
        }
      }
    });
  std::vector<Contact> tree;
  std::vector<char> done(faces, 0);
  while (!queue.empty() && static_cast<Index>(tree.size()) + 1 < m_slit.number_of_loops())
  {
    const Event e = queue.top();
    queue.pop();
    if (e.face < 0)
    {
      const Index a = e.along ? m_slit.loop(e.halfedge) : m_cell[s.face(e.halfedge)];
      const Index b = e.along ? m_slit.loop(s.next(e.halfedge)) : m_cell[s.face(s.opposite[e.halfedge])];
      if (find(a) == find(b)) { continue; }
      joined[find(a)] = find(b);
      tree.push_back({a, b, e.halfedge, e.along});
      continue;
    }
    const Index f = e.face;
    if (done[f]) { continue; }
    done[f] = 1;
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      if (!m_slit.may_cross(h)) { continue; }
      const Index o = s.opposite[h], g = s.face(o);
      const Point middle = s.point_on(h, 0.5);
      const double d = m_reached[f].distance + distance(m_reached[f].entry, middle);
      if (done[g])
      {
        if (m_cell[g] != m_cell[f])
          queue.push({(d + m_reached[g].distance + distance(m_reached[g].entry, middle)) / 2, -1, h, false});
        continue;
      }
      if (d < m_reached[g].distance)
      {
        m_reached[g] = {d, middle, h, false};
        m_cell[g] = m_cell[f];
        queue.push({d, g, -1, false});
      }
    }
  }
  for (Index f = 0; f < faces; ++f)
  {
    if (!done[f]) { m_cell[f] = -1; }
  }
  return tree;
}

bool Sleeve_search::along_cells(const Contact& c, Sleeve& sleeve) const
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

bool Sleeve_search::along_faces(Index from, Index to, const std::vector<Index>& faces, Sleeve& sleeve) const
{
  const auto is_allowed = [&](Index f) {
    return std::binary_search(faces.begin(), faces.end(), m_slit.surface().face_of[f]);
  };
  return search(from, sleeve, is_allowed, to);
}

void Sleeve_search::grow()
{
  const auto& parents = m_slit.parents;
  for (std::size_t i = m_known_parents; i < parents.size(); ++i) { m_cell.push_back(m_cell[parents[i]]); }
  m_known_parents = parents.size();
}

bool Sleeve_search::is_usable(const Sleeve& sleeve) const
{
  if (!sleeve.halfedges.empty()) { return true; }
  if (sleeve.start == sleeve.end) { return false; }
  const Refined_surface& s = m_slit.surface();
  const Index h = s.find_halfedge(sleeve.start, sleeve.end);
  return h >= 0 && m_slit.may_cross(h);
}

} // namespace internal

} // namespace meridian
