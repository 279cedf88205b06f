// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/internal/border_strands.h>

#include <meridian/base/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

void space_strand(const Triangle_surface& s, Strand& strand)
{
  const std::size_t n = strand.vertices.size() - 1;
  std::vector<double> edges(n);
  strand.length = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    strand.length += edges[i] = distance(s.points[strand.vertices[i]], s.points[strand.vertices[i + 1]]);
  }
  const double floor = strand.length > 0 ? 1e-4 * strand.length / static_cast<double>(n) : 1;
  double whole = 0;
  for (double& e : edges) { whole += e = std::max(e, floor); }
  strand.along.assign(n + 1, 0);
  double sum = 0;
  for (std::size_t i = 1; i < n; ++i) { strand.along[i] = strand.steps * ((sum += edges[i - 1]) / whole); }
  strand.along[n] = strand.steps;
}

void find_least_steps(Border_strands& border)
{
  std::map<std::pair<Index, Index>, int> parallel;
  const auto ends = [](const Strand& s) { return std::minmax(s.vertices.front(), s.vertices.back()); };
  for (const Strand& s : border.strands) { ++parallel[ends(s)]; }
  for (Strand& s : border.strands)
  {
    s.least = s.vertices.front() == s.vertices.back() ? 3 : parallel[ends(s)] > 1 ? 2 : 1;
  }
}

namespace {

// Takes the border of a disc apart where seams meet or end.
class Border_walk
{
public:
  Border_walk(const Refined_surface& s, const Opened_surface& opened, const Triangle_surface& disc)
    : m_surface(s), m_opened(opened), m_disc(disc), m_degree(s.number_of_vertices(), 0),
      m_side_of(s.number_of_halfedges(), -1)
  {
    for (Index h = 0; h < s.number_of_halfedges(); ++h)
    {
      if (!s.seam[h]) { continue; }
      if (s.opposite[h] < 0) { throw Internal_error("square_border: a seam lies on the boundary"); }
      ++m_degree[s.source(h)];
    }
  }

  Border_strands gather(std::vector<Index> loop)
  {
    const auto first = std::find_if(loop.begin(), loop.end(), [&](Index h) { return is_end(h); });
    m_border.is_whole = first == loop.end();
    if (!m_border.is_whole) { std::rotate(loop.begin(), first, loop.end()); }
    for (std::size_t i = 0; i < loop.size();) { i = add_side(loop, i); }
    find_least_steps(m_border);
    return std::move(m_border);
  }

private:
  Index below(Index v) const
  {
    return v < m_surface.number_of_vertices() ? v : m_opened.copy_of[v - m_surface.number_of_vertices()];
  }

  // Whether seams meet or end at the source of a halfedge of the disc.
  bool is_end(Index h) const
  {
    const Index v = below(m_disc.source(h));
    return m_degree[v] > 0 && (m_degree[v] != 2 || m_surface.is_boundary_vertex(v));
  }

  // Adds the side that begins at place `i` of the loop. Returns where it ends.
  std::size_t add_side(const std::vector<Index>& loop, std::size_t i)
  {
    const Index h = loop[i], side = static_cast<Index>(m_border.sides.size());
    Border_side& b = m_border.sides.emplace_back();
    do {
      m_side_of[loop[i]] = side;
      b.vertices.push_back(m_disc.source(loop[i]));
      ++i;
    } while (i < loop.size() && !is_end(loop[i]));
    b.vertices.push_back(m_disc.target(loop[i - 1]));
    const Index twin = m_surface.opposite[h];
    if (twin >= 0 && m_side_of[twin] == side) { throw Internal_error("square_border: a seam is its own mate"); }
    if (twin >= 0 && m_side_of[twin] >= 0) { join_mate(side, m_side_of[twin]); }
    else
    {
      b.strand = static_cast<Index>(m_border.strands.size());
      Strand& strand = m_border.strands.emplace_back();
      for (Index v : b.vertices) { strand.vertices.push_back(below(v)); }
      space_strand(m_surface, strand);
    }
    return i;
  }

  // Makes a side the other one of a seam.
  void join_mate(Index side, Index mate)
  {
    Border_side& b = m_border.sides[side];
    b.mate = mate;
    m_border.sides[mate].mate = side;
    b.strand = m_border.sides[mate].strand;
    b.is_reversed = true;
    std::reverse(b.vertices.begin(), b.vertices.end());
    if (b.vertices.size() != m_border.strands[b.strand].vertices.size())
    {
      throw Internal_error("square_border: the sides of a seam differ");
    }
  }

  const Refined_surface& m_surface;
  const Opened_surface& m_opened;
  const Triangle_surface& m_disc;
  std::vector<int> m_degree;    // of each vertex: seams at it
  std::vector<Index> m_side_of; // of each halfedge, or -1
  Border_strands m_border;
};

} // namespace

Border_strands gather_border(const Refined_surface& s, const Opened_surface& opened, const Triangle_surface& disc)
{
  const auto loops = boundary_loops(disc);
  const int characteristic = disc.number_of_vertices() - disc.number_of_edges() + disc.number_of_faces();
  if (loops.size() != 1 || characteristic != 1)
    throw Invalid_input_error("a geometry image is made of a disc, but the surface has " + std::to_string(loops.size())
                              + " borders and Euler characteristic " + std::to_string(characteristic)
                              + " after it is cut");
  return Border_walk(s, opened, disc).gather(loops.front());
}

void share_out(std::vector<Strand*> strands, int total)
{
  for (bool was_fixed = true; was_fixed;)
  {
    was_fixed = false;
    double length = 0;
    for (const Strand* s : strands) { length += s->length; }
    const auto share = [&](const Strand* s) {
      return length > 0 ? total * (s->length / length) : total / static_cast<double>(strands.size());
    };
    std::vector<Strand*> rest;
    int left = total;
    for (Strand* s : strands)
    {
      if (share(s) < s->least)
      {
        left -= s->steps = s->least;
        was_fixed = true;
      }
      else { rest.push_back(s); }
    }
    if (was_fixed && !rest.empty())
    {
      strands = rest;
      total = left;
      continue;
    }
    std::vector<std::pair<double, std::size_t>> remainders;
    for (std::size_t i = 0; i < rest.size(); ++i)
    {
      rest[i]->steps = static_cast<int>(share(rest[i]));
      remainders.emplace_back(rest[i]->steps - share(rest[i]), i);
      left -= rest[i]->steps;
    }
    std::sort(remainders.begin(), remainders.end());
    for (std::size_t i = 0; left > 0; ++i, --left)
    {
      ++(rest.empty() ? strands[i % strands.size()] : rest[remainders[i % rest.size()].second])->steps;
    }
    was_fixed = false;
  }
}

std::array<std::vector<Strand*>, 2> boundary_and_seams(Border_strands& border)
{
  std::array<std::vector<Strand*>, 2> kinds;
  for (const Border_side& b : border.sides)
  {
    if (!b.is_reversed) { kinds[b.mate >= 0].push_back(&border.strands[b.strand]); }
  }
  return kinds;
}

int least_size(Border_strands& border)
{
  std::array<int, 2> least{0, 0};
  const auto kinds = boundary_and_seams(border);
  for (int k : {0, 1})
  {
    for (const Strand* s : kinds[k]) { least[k] += s->least; }
  }
  return std::max(5, 1 + (least[0] + 2 * least[1] + 3) / 4);
}

void distribute_steps(const Triangle_surface& s, Border_strands& border, int total)
{
  const auto kinds = boundary_and_seams(border);
  std::array<int, 2> least{0, 0};
  std::array<double, 2> length{0, 0};
  for (int k : {0, 1})
    for (const Strand* strand : kinds[k])
    {
      least[k] += strand->least;
      length[k] += strand->length;
    }
  int seams = kinds[0].empty() ? total / 2 : 0;
  if (!kinds[0].empty() && !kinds[1].empty())
  {
    const double whole = length[0] + 2 * length[1];
    const int wanted = whole > 0 ? static_cast<int>(std::floor(total * (length[1] / whole) + 0.5)) : total / 4;
    seams = std::min(std::max(wanted, least[1]), (total - least[0]) / 2);
  }
  if (!kinds[1].empty()) { share_out(kinds[1], seams); }
  if (!kinds[0].empty()) { share_out(kinds[0], total - 2 * seams); }
  for (Strand& strand : border.strands) { space_strand(s, strand); }
  int sum = 0;
  for (Border_side& b : border.sides)
  {
    b.start = sum;
    sum += border.strands[b.strand].steps;
  }
  if (sum != total) { throw Internal_error("square_border: the steps of the border do not add up"); }
}

Index vertex_near(const std::vector<double>& along, double step)
{
  const std::size_t right = std::lower_bound(along.begin(), along.end(), step) - along.begin();
  Index best = -1;
  double nearest = 0.5;
  for (std::size_t i = right > 0 ? right - 1 : 0; i <= right; ++i)
  {
    if (i < 1 || i + 1 >= along.size()) { continue; }
    const double limit = std::min(along[i] - along[i - 1], along[i + 1] - along[i]) / 4, d = std::abs(along[i] - step);
    if (d <= limit && d < nearest)
    {
      nearest = d;
      best = static_cast<Index>(i);
    }
  }
  return best;
}

std::pair<Index, int> side_at(const Border_strands& border, int point)
{
  const auto after = std::upper_bound(border.sides.begin(), border.sides.end(), point,
                                      [](int p, const Border_side& b) { return p < b.start; });
  const Index side = static_cast<Index>(after - border.sides.begin()) - 1;
  return {side, point - border.sides[side].start};
}

} // namespace internal

} // namespace meridian
