// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_GAP_RECORDS_H
#define MERIDIAN_CURVES_GAP_RECORDS_H

#include <meridian/base/vectors.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/surface/Triangle_surface.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

namespace meridian {
namespace internal {

// What a search through gaps notes of each. A record that an earlier search wrote counts as new: its `run` tells.
// References stay valid until the next search; curves must not change meanwhile.
template <class Record> class Gap_records
{
public:
  explicit Gap_records(const Normal_curves& curves)
    : m_curves(curves), m_plain(curves.surface().number_of_halfedges()), m_crowd(m_plain.size())
  {}

  // Begins another search.
  void forget()
  {
    ++m_run;
    m_used = 0;
  }
  std::uint32_t run() const { return m_run; }

  Record& operator[](const Gap& g)
  {
    const std::size_t crossings = m_curves.on(g.edge).size();
    Record& r = crossings == 0 ? m_plain[g.edge] : m_crowded[first(g.edge, crossings) + g.place];
    if (r.run != m_run)
    {
      r = Record{};
      r.run = m_run;
    }
    return r;
  }

private:
  // The first record of an edge with crossings, which are made when the search comes to it.
  std::size_t first(Index edge, std::size_t crossings)
  {
    Crowd& c = m_crowd[edge];
    if (c.run != m_run)
    {
      c = {m_run, static_cast<std::uint32_t>(m_used)};
      m_used += crossings + 1;
      while (m_crowded.size() < m_used) { m_crowded.emplace_back(); }
      for (std::size_t i = c.first; i < m_used; ++i) { m_crowded[i].run = m_run - 1; }
    }
    return c.first;
  }

  struct Crowd
  {
    std::uint32_t run = 0, first = 0;
  };

  const Normal_curves& m_curves;
  std::vector<Record> m_plain;  // of edges without crossings
  std::vector<Crowd> m_crowd;   // of the others: where their gaps begin in
  std::deque<Record> m_crowded; // one record a gap
  std::size_t m_used = 0;
  std::uint32_t m_run = 0;
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CURVES_GAP_RECORDS_H
