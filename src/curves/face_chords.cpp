// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/internal/face_chords.h>

#include <algorithm>

namespace meridian {

namespace internal {

Face_chords::Gap Face_chords::beside(Id x, bool left) const
{
  const Index h = (*this)[x].halfedge, e = m_surface.edge(h), k = (*this)[x].place;
  return {e, (left == (h == e)) ? k + 1 : k}; // the target of `h` is on the left
}

double Face_chords::middle(const Gap& g) const
{
  const auto& list = on(g.edge);
  const double from = g.place == 0 ? 0 : (*this)[list[g.place - 1]].t;
  const double to = g.place == static_cast<Index>(list.size()) ? 1 : (*this)[list[g.place]].t;
  return (from + to) / 2;
}

std::int64_t Face_chords::around(Id x, Index face) const
{
  const Index h = side(x, face), e = m_surface.edge(h), k = (*this)[x].place;
  const Index along = h == e ? k : static_cast<Index>(on(e).size()) - 1 - k;
  return (static_cast<std::int64_t>(h % 3) << 32) + along;
}

bool Face_chords::alternate(Id x, Id y, Index face) const
{
  const std::int64_t a = around(x, face), b = around(across(x, face), face);
  const std::int64_t c = around(y, face), d = around(across(y, face), face);
  const auto inside = [&](std::int64_t p) { return std::min(a, b) < p && p < std::max(a, b); };
  return inside(c) != inside(d);
}

Face_chords::Id Face_chords::crossed_by(Id x, Index face) const
{
  for (Index h = 3 * face; h < 3 * face + 3; ++h)
    for (Id y : on(m_surface.edge(h)))
      if ((*this)[y].curve == partner((*this)[x].curve) && (*this)[y].halfedge != h && alternate(x, y, face))
      {
        return y;
      }
  return -1;
}

Index Face_chords::count_in_face(Index curve, Index face) const
{
  Index count = 0;
  for (Index h = 3 * face; h < 3 * face + 3; ++h)
    for (Id x : on(m_surface.edge(h)))
    {
      if ((*this)[x].curve != curve || (*this)[x].halfedge == h) { continue; }
      for (Index g = 3 * face; g < 3 * face + 3; ++g)
        for (Id y : on(m_surface.edge(g)))
          count += (*this)[y].curve == partner(curve) && (*this)[y].halfedge != g && alternate(x, y, face);
    }
  return count;
}

Index Face_chords::side(Id x, Index face) const
{
  const Index h = (*this)[x].halfedge;
  return m_surface.face(h) == face ? h : m_surface.opposite[h];
}

Index Face_chords::count_before_corner(Index h, Index face) const
{
  if (!has_open_curves()) { return 0; }
  const auto& list = on(m_surface.edge(h));
  const Index n = static_cast<Index>(list.size());
  for (Index k = n; k-- > 0;)
    if (across(list[m_surface.edge(h) == h ? k : n - 1 - k], face) < 0) { return k + 1; }
  return 0;
}

} // namespace internal

} // namespace meridian
