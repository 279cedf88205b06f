// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_GAP_RECORDS_H
#define MERIDIAN_CURVES_GAP_RECORDS_H

#include <meridian/base/vectors.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/surface/Triangle_surface.h>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace meridian {
namespace internal {

// What a search through gaps notes of each. A record that an earlier search wrote counts as new: its `run` tells.
template <class Record> class Gap_records
{
public:
  explicit Gap_records(const Normal_curves& curves) : m_curves(curves), m_plain(curves.surface().number_of_halfedges())
  {}

  // Begins another search.
  void forget()
  {
    ++m_run;
    m_crowded.clear();
  }
  std::uint32_t run() const { return m_run; }

  Record& operator[](const Gap& g)
  {
    Record& r = m_curves.on(g.edge).empty()
                  ? m_plain[g.edge]
                  : m_crowded[static_cast<std::uint64_t>(g.edge) << 32 | static_cast<std::uint32_t>(g.place)];
    if (r.run != m_run)
    {
      r = Record{};
      r.run = m_run;
    }
    return r;
  }

private:
  const Normal_curves& m_curves;
  std::vector<Record> m_plain;                         // of edges without crossings
  std::unordered_map<std::uint64_t, Record> m_crowded; // of gaps on the others
  std::uint32_t m_run = 0;
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CURVES_GAP_RECORDS_H
