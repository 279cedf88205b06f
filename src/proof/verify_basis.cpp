// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/proof/internal/verify_basis.h>

#include <algorithm>
#include <set>

namespace meridian {

namespace verification {

bool is_unimodular(std::vector<Integer_row> rows, Id columns)
{
  if (static_cast<Id>(rows.size()) != columns) { return false; }
  std::vector<std::set<Id>> rows_of(columns);
  for (Id r = 0; r < columns; ++r)
  {
    for (const auto& [c, value] : rows[r]) { rows_of[c].insert(r); }
  }
  std::set<std::pair<std::size_t, Id>> order; // columns by how many rows they have
  for (Id c = 0; c < columns; ++c) { order.insert({rows_of[c].size(), c}); }
  const auto enter = [&](Id c, Id r, bool add) {
    order.erase({rows_of[c].size(), c});
    if (add) { rows_of[c].insert(r); }
    else { rows_of[c].erase(r); }
    order.insert({rows_of[c].size(), c});
  };
  while (!order.empty())
  {
    const Id column = order.begin()->second;
    for (;;)
    {
      if (rows_of[column].empty()) { return false; }
      Id pivot = -1;
      for (Id r : rows_of[column])
      {
        const auto size = [&](Id row) { return std::make_pair(abs(rows[row].at(column)), rows[row].size()); };
        if (pivot < 0 || size(r) < size(pivot)) { pivot = r; }
      }
      const Integer_row from = rows[pivot];
      const std::set<Id> others = rows_of[column];
      for (Id r : others)
      {
        if (r == pivot) { continue; }
        const boost::multiprecision::cpp_int factor = rows[r].at(column) / from.at(column);
        for (const auto& [c, value] : from)
        {
          auto [at, is_new] = rows[r].try_emplace(c, 0);
          at->second -= factor * value;
          if (at->second == 0)
          {
            rows[r].erase(at);
            if (!is_new) { enter(c, r, false); }
          }
          else if (is_new) { enter(c, r, true); }
        }
      }
      if (rows_of[column].size() == 1)
      {
        if (abs(from.at(column)) != 1) { return false; }
        for (const auto& [c, value] : from) { enter(c, pivot, false); }
        order.erase({0, column});
        break;
      }
    }
  }
  return true;
}

Integer_row Tree_cotree::class_of(const std::vector<std::pair<Id, int>>& walk) const
{
  std::map<Id, int> flow; // through each edge, along its higher side
  for (const auto& [side, sign] : walk)
  {
    const Id o = m_twin[side];
    flow[std::max(side, o)] += o > side ? -sign : sign;
  }
  std::vector<std::pair<Id, int>> steps; // where on the tour the sum changes
  for (const auto& [side, amount] : flow)
    for (Id s : {side, m_twin[side]})
    {
      if (s < 0 || !m_is_down[3 * place(s) + s % 3]) { continue; }
      const int into = s == side ? -amount : amount; // going down into the face of `s`
      steps.emplace_back(m_enter[place(s)], into);
      steps.emplace_back(m_leave[place(s)], -into);
    }
  std::sort(steps.begin(), steps.end());
  std::vector<Id> times;
  std::vector<int> sums;
  int sum = 0;
  for (const auto& [time, change] : steps)
  {
    sum += change;
    times.push_back(time);
    sums.push_back(sum);
  }
  const auto at = [&](Id face) {
    const auto after = std::upper_bound(times.begin(), times.end(), m_enter[face]) - times.begin();
    return after == 0 ? 0 : sums[after - 1];
  };
  Integer_row row;
  for (Id i = 0; i < rank(); ++i)
  {
    const Id s = m_edges[i], o = m_twin[s];
    const auto own = flow.find(s);
    const int value = (own == flow.end() ? 0 : own->second) + at(place(s)) - at(place(o));
    if (value != 0) { row[i] = value; }
  }
  return row;
}

} // namespace verification

} // namespace meridian
