// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/proof/internal/Generator_verifier.h>

#include <meridian/proof/internal/verify_basis.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace meridian {

namespace verification {

Generator_verification Generator_verifier::run()
{
  if (verify_mesh())
  {
    find_fans();
    if (m_report.failures.empty() && read_names() && read_walks())
    {
      count_curves();
      for (const Result_curve& c : m_curves)
      {
        if (!c.field.empty()) { check_flow(c); }
      }
    }
  }
  Generator_verification found;
  static_cast<Verification&>(found) = std::move(m_report);
  found.curves = std::move(m_counts);
  return found;
}

bool Generator_verifier::read_names()
{
  const std::size_t before = m_report.failures.size();
  static constexpr std::array<const char*, 4> kinds{"meridian_", "longitude_", "loop_", "boundary_"};
  std::array<std::set<Id>, 4> numbers;
  for (const Result_curve& c : m_curves)
  {
    int kind = -1;
    Id number = -1;
    for (int k = 0; k < 4; ++k)
    {
      const std::string prefix = kinds[k];
      const std::string rest = c.name.substr(0, prefix.size()) == prefix ? c.name.substr(prefix.size()) : "";
      if (rest.empty() || rest.size() > 8 || rest.find_first_not_of("0123456789") != std::string::npos) { continue; }
      kind = k;
      number = std::stoi(rest);
    }
    if (kind < 0)
    {
      complain("curve '" + c.name + "' is not a meridian, longitude, loop or boundary with a number");
      continue;
    }
    if (!numbers[kind].insert(number).second) { complain("there are two curves '" + c.name + "'"); }
    m_read.push_back({static_cast<Kind>(kind), number, -1, {}});
  }
  for (int k = 0; k < 4; ++k)
    if (!numbers[k].empty() && *numbers[k].rbegin() != static_cast<Id>(numbers[k].size()) - 1)
      complain(std::string("curves '") + kinds[k] + "...' are not numbered through from 0");
  if (numbers[MERIDIAN] != numbers[LONGITUDE])
    complain("there are " + std::to_string(numbers[MERIDIAN].size()) + " meridians and "
             + std::to_string(numbers[LONGITUDE].size()) + " longitudes");
  return m_report.failures.size() == before;
}

bool Generator_verifier::read_walks()
{
  const std::size_t before = m_report.failures.size();
  const Id sides = 3 * static_cast<Id>(m_result.faces.size()), vertices = static_cast<Id>(m_result.points.size());
  m_begin.assign(vertices + 1, 0);
  for (Id s = 0; s < sides; ++s) { ++m_begin[corner(s) + 1]; }
  std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());
  m_leaving.resize(sides);
  std::vector<Id> fill(m_begin.begin(), m_begin.end() - 1);
  for (Id s = 0; s < sides; ++s) { m_leaving[fill[corner(s)]++] = s; }
  const auto find = [&](Id u, Id v) {
    for (Id i = m_begin[u]; i < m_begin[u + 1]; ++i)
    {
      if (corner(next_side(m_leaving[i])) == v) { return m_leaving[i]; }
    }
    return Id(-1);
  };
  for (std::size_t c = 0; c < m_curves.size(); ++c)
  {
    const auto& points = m_curves[c].points;
    const std::string& text = m_curves[c].name;
    if (points.size() < 4 || points.front() != points.back())
    {
      complain(text + " is not closed, or has less than three edges");
      continue;
    }
    std::vector<Id> sorted(points.begin() + 1, points.end());
    std::sort(sorted.begin(), sorted.end());
    if (sorted.front() < 0 || sorted.back() >= vertices)
    {
      complain(text + " names a vertex that is not there");
      continue;
    }
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end())
    {
      complain(text + " touches itself at vertex " + std::to_string(*twice));
      continue;
    }
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      Id s = find(points[i], points[i + 1]);
      const int sign = s >= 0 ? 1 : -1;
      if (s < 0) { s = find(points[i + 1], points[i]); }
      if (s < 0)
      {
        complain(text + " goes from vertex " + std::to_string(points[i]) + " to " + std::to_string(points[i + 1])
                 + " where the mesh has no edge");
        break;
      }
      m_read[c].walk.emplace_back(s, sign);
      m_read[c].component = component(s / 3);
    }
  }
  return m_report.failures.size() == before;
}

std::vector<Id> Generator_verifier::rotation(Id v) const
{
  std::vector<Id> around;
  Id start = m_leaving[m_begin[v]];
  for (Id s = start;;)
  {
    const Id o = m_result_twin[s]; // one step clockwise
    if (o < 0)
    {
      start = s;
      break;
    }
    s = next_side(o);
    if (s == start) { break; }
  }
  for (Id s = start;;)
  {
    around.push_back(s);
    s = m_result_twin[next_side(next_side(s))];
    if (s < 0 || s == start) { return around; }
  }
}

void Generator_verifier::count_curves()
{
  const int components = static_cast<int>(m_report.components.size());
  m_counts.assign(components, {});
  std::vector<std::vector<Id>> of(components); // curves that should generate
  std::vector<Id> order(m_read.size());
  std::iota(order.begin(), order.end(), Id(0));
  std::sort(order.begin(), order.end(), [&](Id a, Id b) {
    const auto key = [&](Id c) { return std::make_tuple(m_read[c].number, static_cast<int>(m_read[c].kind)); };
    return key(a) < key(b);
  });
  for (Id c : order)
  {
    if (m_read[c].kind == BOUNDARY) { check_boundary(c); }
    else { of[m_read[c].component].push_back(c); }
  }
  int last = 0;
  for (Id c : order)
  {
    if (m_read[c].kind == BOUNDARY) { continue; }
    if (m_read[c].component < last)
    {
      complain(name(c) + " lies on component " + std::to_string(m_read[c].component) + ", out of order");
    }
    last = m_read[c].component;
  }
  find_intersections();
  std::vector<std::vector<Id>> faces(components);
  std::vector<Id> local(m_result.faces.size());
  for (Id f = 0; f < static_cast<Id>(m_result.faces.size()); ++f)
  {
    local[f] = static_cast<Id>(faces[component(f)].size());
    faces[component(f)].push_back(f);
  }
  for (int i = 0; i < components; ++i)
  {
    const Component_count& count = m_report.components[i];
    const bool are_pairs = of[i].empty() || m_read[of[i].front()].kind != LOOP;
    m_counts[i].pairs = static_cast<int>(of[i].size()) / 2;
    if (static_cast<int>(of[i].size()) != 2 * count.genus)
    {
      complain("component " + std::to_string(i) + " has genus " + std::to_string(count.genus) + " and "
               + std::to_string(of[i].size()) + " curves, not twice as many");
      continue;
    }
    if (m_counts[i].boundary_loops != count.boundary_loops)
      complain("component " + std::to_string(i) + " has " + std::to_string(count.boundary_loops)
               + " boundary loops, and " + std::to_string(m_counts[i].boundary_loops) + " are listed");
    fill_matrix(i, of[i], are_pairs);
    // A symplectic matrix is unimodular: on a closed component the curves are a basis.
    if (m_counts[i].is_symplectic && count.boundary_loops == 0)
    {
      m_counts[i].is_basis = true;
      continue;
    }
    check_basis(i, of[i], faces[i], local);
  }
}

void Generator_verifier::check_boundary(Id c)
{
  for (const auto& [side, sign] : m_read[c].walk)
    if (m_result_twin[side] >= 0)
    {
      complain(name(c) + " leaves the boundary");
      return;
    }
  ++m_counts[m_read[c].component].boundary_loops;
  const auto first = std::min_element(m_read[c].walk.begin(), m_read[c].walk.end())->first;
  if (!m_boundaries.insert(first).second) { complain(name(c) + " is listed twice"); }
}

void Generator_verifier::check_basis(int component, const std::vector<Id>& curves, const std::vector<Id>& faces,
                                     const std::vector<Id>& local)
{
  const Component_count& count = m_report.components[component];
  const Tree_cotree trees(faces, local, m_result_twin, static_cast<Id>(m_result.points.size()),
                          [&](Id s) { return corner(s); });
  std::vector<Integer_row> rows;
  for (Id c : curves) { rows.push_back(trees.class_of(m_read[c].walk)); }
  bool is_first = true;
  for (std::size_t c = 0; c < m_read.size(); ++c)
  {
    if (m_read[c].kind != BOUNDARY || m_read[c].component != component) { continue; }
    if (!is_first) { rows.push_back(trees.class_of(m_read[c].walk)); }
    is_first = false;
  }
  if (trees.rank() != 2 * count.genus + std::max(count.boundary_loops - 1, 0))
    complain("component " + std::to_string(component) + ": spanning trees leave " + std::to_string(trees.rank())
             + " edges");
  m_counts[component].is_basis = is_unimodular(rows, trees.rank());
  if (!m_counts[component].is_basis)
    complain("the curves of component " + std::to_string(component)
             + ", with its boundary loops but one, are not a basis of first homology: their determinant is neither 1 "
               "nor -1");
}

void Generator_verifier::check_flow(const Result_curve& c)
{
  std::vector<double> values;
  for (std::size_t i = 0; i + 1 < c.points.size(); ++i)
  {
    const Result_origin& o = m_result.origin[c.points[i]];
    const auto a = c.field.find(o.index[0]), b = o.kind == Result_origin::EDGE ? c.field.find(o.index[1]) : a;
    if (o.kind == Result_origin::FACE || a == c.field.end() || b == c.field.end())
    {
      complain(c.name + " is said to be made of flow lines, and its field has no value at vertex "
               + std::to_string(c.points[i]));
      return;
    }
    values.push_back(o.kind == Result_origin::EDGE ? a->second + o.weight[0] * (b->second - a->second) : a->second);
  }
  int turns = 0;
  bool is_strict = true;
  const std::size_t n = values.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const double before = values[(i + n - 1) % n], after = values[(i + 1) % n];
    is_strict = is_strict && (values[i] < after || values[i] > after);
    turns += (before < values[i]) != (values[i] < after);
  }
  if (!is_strict || turns != 2)
    complain(c.name + " is said to be made of flow lines, and its field turns " + std::to_string(turns)
             + " times along it, not twice");
}

} // namespace verification

} // namespace meridian
