// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/proof/internal/verify_basis.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

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

namespace {

// The edges of some faces that a spanning tree of their vertices leaves, each as its higher side.
std::vector<Id> leave_tree(const std::vector<Id>& faces, const std::vector<Id>& twin, Id vertices,
                           const std::function<Id(Id)>& corner)
{
  Union_find tree(vertices);
  std::vector<Id> rest;
  for (Id f : faces)
    for (Id s = 3 * f; s < 3 * f + 3; ++s)
    {
      if (twin[s] > s) { continue; }
      const Id a = corner(s), b = corner(next_side(s));
      if (tree.find(a) != tree.find(b)) { tree.join(a, b); }
      else { rest.push_back(s); }
    }
  return rest;
}

} // namespace

Tree_cotree::Tree_cotree(const std::vector<Id>& faces, const std::vector<Id>& local, const std::vector<Id>& twin,
                         Id vertices, const std::function<Id(Id)>& corner)
  : m_local(local), m_twin(twin), m_outside(static_cast<Id>(faces.size()))
{
  const bool is_closed = std::all_of(
    faces.begin(), faces.end(), [&](Id f) { return twin[3 * f] >= 0 && twin[3 * f + 1] >= 0 && twin[3 * f + 2] >= 0; });
  tour(grow_cotree(leave_tree(faces, twin, vertices, corner)), is_closed ? 0 : m_outside);
}

Tree_cotree::Cotree Tree_cotree::grow_cotree(const std::vector<Id>& edges)
{
  Union_find joined(m_outside + 1);
  Cotree cotree(m_outside + 1);
  for (Id s : edges)
  {
    const Id f = m_local[s / 3], g = place(m_twin[s]);
    if (joined.find(f) == joined.find(g))
    {
      m_edges.push_back(s);
      continue;
    }
    joined.join(f, g);
    cotree[g].emplace_back(s, f);
    cotree[f].emplace_back(m_twin[s], g);
  }
  return cotree;
}

void Tree_cotree::tour(const Cotree& cotree, Id root)
{
  m_enter.resize(cotree.size());
  m_leave.resize(cotree.size());
  m_is_down.assign(3 * static_cast<std::size_t>(m_outside), 0);
  struct Visit
  {
    Id face, parent;
    std::size_t next;
  };
  std::vector<Visit> stack{{root, -1, 0}};
  Id time = 0;
  m_enter[root] = time++;
  while (!stack.empty())
  {
    Visit& v = stack.back();
    const auto& around = cotree[v.face];
    if (v.next == around.size())
    {
      m_leave[v.face] = time;
      stack.pop_back();
      continue;
    }
    const auto [side, g] = around[v.next++];
    if (g == v.parent) { continue; }
    m_is_down[3 * g + side % 3] = 1;
    m_enter[g] = time++;
    stack.push_back({g, v.face, 0});
  }
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
