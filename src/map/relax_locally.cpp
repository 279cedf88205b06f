// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/internal/relax_locally.h>

#include <meridian/base/group_by.h>
#include <meridian/map/planar_map.h>

#include <algorithm>

namespace meridian {

namespace internal {

namespace {

constexpr double high = 20; // energy; 4 is the least that there is

class Local_relaxation
{
public:
  Local_relaxation(const std::vector<Rest_triangle>& triangles, const std::vector<Rest_triangle>& others,
                   const std::vector<char>& may_move, std::vector<Plane_point>& at)
    : m_triangles(triangles), m_others(others), m_may_move(may_move), m_at(at)
  {}

  void run()
  {
    constexpr int most_sweeps = 200;
    std::vector<Index> active = find_high(), next;
    if (active.empty()) { return; }
    const auto count = static_cast<Index>(m_triangles.size() + m_others.size());
    m_around =
      group_by(static_cast<Index>(m_at.size()), 3 * count, [&](Index i) { return triangle(i / 3).corners[i % 3]; });
    std::vector<char> is_next(m_at.size(), 0);
    for (int sweep = 0; sweep < most_sweeps && !active.empty(); ++sweep)
    {
      next.clear();
      for (Index v : active)
      {
        if (!relax(v)) { continue; }
        for_each_around(v, [&](const Rest_triangle& t, int) {
          for (Index u : t.corners)
          {
            if (!m_may_move[u] || is_next[u]) { continue; }
            is_next[u] = 1;
            next.push_back(u);
          }
        });
      }
      for (Index v : next) { is_next[v] = 0; }
      std::sort(next.begin(), next.end());
      active.swap(next);
    }
  }

private:
  const Rest_triangle& triangle(Index i) const
  {
    const auto n = static_cast<Index>(m_triangles.size());
    return i < n ? m_triangles[i] : m_others[i - n];
  }
  template <class Function> void for_each_around(Index v, const Function& f) const
  {
    for (Index k = m_around.begin[v]; k < m_around.begin[v + 1]; ++k)
    {
      f(triangle(m_around.element[k] / 3), m_around.element[k] % 3);
    }
  }

  // The vertices around which the mean energy is high, ascending.
  std::vector<Index> find_high() const
  {
    std::vector<double> excess(m_at.size(), 0);
    for (const auto* all : {&m_triangles, &m_others})
      for (const Rest_triangle& t : *all)
      {
        const double e = t.weight * (symmetric_dirichlet_energy(gradient_of(t, m_at)) - high);
        for (Index v : t.corners) { excess[v] += e; }
      }
    std::vector<Index> found;
    for (Index v = 0; v < static_cast<Index>(m_at.size()); ++v)
    {
      if (m_may_move[v] && excess[v] > 0) { found.push_back(v); }
    }
    return found;
  }

  double energy(Index v, double& weight) const
  {
    double sum = 0;
    weight = 0;
    for_each_around(v, [&](const Rest_triangle& t, int) {
      sum += t.weight * symmetric_dirichlet_energy(gradient_of(t, m_at));
      weight += t.weight;
    });
    return sum;
  }

  bool is_upright(Index v) const
  {
    bool all = true;
    for_each_around(v, [&](const Rest_triangle& t, int) {
      all = all && orientation_of(m_at[t.corners[0]], m_at[t.corners[1]], m_at[t.corners[2]]) > 0;
    });
    return all;
  }

  // Moves a vertex, if the energy around it is high. \returns whether it has fallen by more than a little
  bool relax(Index v)
  {
    constexpr int steps = 2;
    double weight = 0;
    const double before = energy(v, weight);
    double now = before;
    if (!(before > high * weight)) { return false; }
    for (int i = 0; i < steps; ++i)
    {
      const Plane_point from = m_at[v];
      Plane_point move;
      if (!find_local_direction([&](const auto& f) { for_each_around(v, f); }, m_at, move)) { break; }
      const auto try_length = [&](double length) {
        const Plane_point old = m_at[v];
        m_at[v] = from + length * move;
        double unused;
        const double then = energy(v, unused);
        if (then < now && is_upright(v))
        {
          now = then;
          return true;
        }
        m_at[v] = old;
        return false;
      };
      double length = 1;
      int tries = 0;
      while (tries < 8 && !try_length(length))
      {
        ++tries;
        length /= 2;
      }
      if (tries == 8) { break; }
      for (length *= 2; tries == 0 && length < 100 && try_length(length); length *= 2) {}
    }
    return now < 0.99 * before;
  }

  const std::vector<Rest_triangle>& m_triangles;
  const std::vector<Rest_triangle>& m_others;
  const std::vector<char>& m_may_move;
  std::vector<Plane_point>& m_at;
  Groups m_around; // of each vertex: three times a triangle, and the corner
};

} // namespace

void relax_locally(const std::vector<Rest_triangle>& triangles, const std::vector<Rest_triangle>& others,
                   const std::vector<char>& may_move, std::vector<Plane_point>& at)
{
  Local_relaxation(triangles, others, may_move, at).run();
}

} // namespace internal

} // namespace meridian
