// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/proof/internal/Mesh_verifier.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <future>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace meridian {

namespace verification {

bool Mesh_verifier::verify_mesh()
{
  // The input and the result are taken apart side by side: neither needs the other.
  auto pairing = std::async(std::launch::async, [this] { pair_result(); });
  m_in = Input_topology(m_input);
  m_report.components = m_in.counts;
  pairing.get();
  fail("faces of the input name a vertex that it does not have", m_in.damaged);
  if (m_report.components.empty()) { m_report.failures.push_back("the input has no face, so nothing can be shown"); }
  if (!check_arrays()) { return false; }
  check_vertices();
  if (!find_triangles()) { return false; }
  check_subdivision();
  check_glueing();
  return true;
}

bool Mesh_verifier::check_arrays()
{
  const Result_mesh& r = m_result;
  const std::size_t vertices = r.points.size(), faces = r.faces.size(), n = m_input.points.size();
  const std::size_t before = m_report.failures.size();
  const auto expect = [&](bool holds, const std::string& text) {
    if (!holds) { m_report.failures.push_back(text); }
  };
  expect(r.copy_of.size() == vertices && r.origin.size() == vertices,
         "the map is not of this mesh: it has " + std::to_string(r.copy_of.size()) + " and "
           + std::to_string(r.origin.size()) + " entries for vertices, the mesh has " + std::to_string(vertices)
           + " vertices");
  expect(r.face_of.size() == faces && r.component_of.size() == faces,
         "the map is not of this mesh: it has " + std::to_string(r.face_of.size()) + " and "
           + std::to_string(r.component_of.size()) + " entries for faces, the mesh has " + std::to_string(faces)
           + " faces");
  expect(vertices >= n,
         "the result has " + std::to_string(vertices) + " vertices, fewer than the input's " + std::to_string(n));
  if (m_report.failures.size() != before) { return false; }
  const auto in = [](Id i, std::size_t size) { return i >= 0 && static_cast<std::size_t>(i) < size; };
  std::vector<Id> bad_faces, bad_vertices, bad_seams;
  for (std::size_t f = 0; f < faces; ++f)
  {
    const auto& c = r.faces[f];
    if (!in(c[0], vertices) || !in(c[1], vertices) || !in(c[2], vertices) || c[0] == c[1] || c[1] == c[2]
        || c[0] == c[2] || !in(r.face_of[f], m_input.number_of_polygons())
        || !in(r.component_of[f], m_report.components.size()))
      bad_faces.push_back(static_cast<Id>(f));
  }
  for (std::size_t v = 0; v < vertices; ++v)
  {
    const Result_origin& o = r.origin[v];
    const bool good = o.kind == Result_origin::VERTEX ? in(o.index[0], n)
                      : o.kind == Result_origin::EDGE
                        ? in(o.index[0], n) && in(o.index[1], n) && o.index[0] < o.index[1]
                        : in(o.index[0], m_in.triangles.size()) && m_in.is_used[o.index[0]];
    if (!good || r.copy_of[v] < -1 || r.copy_of[v] >= static_cast<Id>(v))
    {
      bad_vertices.push_back(static_cast<Id>(v));
    }
  }
  for (std::size_t i = 0; i < r.seams.size(); ++i)
    if (!in(r.seams[i][0], 3 * faces) || !in(r.seams[i][1], 3 * faces)) { bad_seams.push_back(static_cast<Id>(i)); }
  fail("faces repeat a vertex or have an index out of range", bad_faces);
  fail("vertices have a copy or an origin out of range", bad_vertices);
  fail("seams have a side out of range", bad_seams);
  return m_report.failures.size() == before;
}

bool Mesh_verifier::is_same(const Point& p, const Point& q)
{
  for (int i = 0; i < 3; ++i)
    if (std::memcmp(&p[i], &q[i], sizeof(double)) != 0 && !(std::isnan(p[i]) && std::isnan(q[i]))) { return false; }
  return true;
}

// Whether barycentric coordinates are those of a point inside: to the rounding of a few sums.
bool Mesh_verifier::is_inside(const std::array<double, 3>& weight)
{
  constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
  return weight[0] > 0 && weight[1] > 0 && weight[2] > 0 && std::abs(weight[0] + weight[1] + weight[2] - 1) <= rounding;
}

void Mesh_verifier::check_vertices()
{
  const Result_mesh& r = m_result;
  const std::size_t n = m_input.points.size();
  std::vector<Id> moved, outside, wrong_copies, misplaced, doubled, fresh;
  for (std::size_t i = 0; i < r.points.size(); ++i)
  {
    const Id v = static_cast<Id>(i);
    const auto p =
      position_of(r.origin[v], m_input.points, [&](Id t) -> const std::array<Id, 3>& { return m_in.triangles[t]; });
    if (!is_same(p, r.points[v])) { moved.push_back(v); }
    if (r.origin[v].kind == Result_origin::FACE && !is_inside(r.origin[v].weight)) { outside.push_back(v); }
    if (r.copy_of[v] >= 0)
    {
      if (i < n || r.copy_of[r.copy_of[v]] >= 0 || !(r.origin[v] == r.origin[r.copy_of[v]]))
      {
        wrong_copies.push_back(v);
      }
      continue;
    }
    const bool is_files = r.origin[v].kind == Result_origin::VERTEX && r.origin[v].index[0] == v;
    if (i < n ? !is_files : r.origin[v].kind == Result_origin::VERTEX) { misplaced.push_back(v); }
    if (i >= n) { fresh.push_back(v); }
  }
  const auto key = [&](Id v) {
    return std::make_pair(std::make_pair(static_cast<int>(r.origin[v].kind), r.origin[v].index), r.origin[v].weight);
  };
  std::sort(fresh.begin(), fresh.end(), [&](Id a, Id b) { return key(a) < key(b); });
  // Along an edge with three or more faces several sheets may be divided alike.
  const auto is_crowded = [&](Id v) {
    return r.origin[v].kind == Result_origin::EDGE && m_in.crowded_edges.count(r.origin[v].index) > 0;
  };
  for (std::size_t i = 1; i < fresh.size(); ++i)
    if (key(fresh[i - 1]) == key(fresh[i]) && !is_crowded(fresh[i])) { doubled.push_back(fresh[i]); }
  fail("vertices are not at the position of their origin", moved);
  fail("vertices inside faces have weights that are not positive, or that do not add up to 1", outside);
  fail("vertices are copies of the wrong vertex", wrong_copies);
  fail("vertices do not stand in the order of the input", misplaced);
  fail("vertices stand twice without being copies", doubled);
}

int Mesh_verifier::sides_of(const Result_origin& o, Id t) const
{
  const auto& c = m_in.triangles[t];
  if (o.kind == Result_origin::FACE) { return o.index[0] == t ? 0 : -1; }
  int at[2] = {-1, -1};
  for (int k = 0; k < 3; ++k)
    for (int e = 0; e < 2; ++e)
    {
      if (c[k] == o.index[e]) { at[e] = k; }
    }
  if (at[0] < 0 || (o.kind == Result_origin::EDGE && at[1] < 0)) { return -1; }
  if (o.kind == Result_origin::VERTEX) { return 1 << at[0] | 1 << (at[0] + 2) % 3; }
  return (at[0] + 1) % 3 == at[1] ? 1 << at[0] : 1 << at[1];
}

bool Mesh_verifier::find_triangles()
{
  const Id faces = static_cast<Id>(m_result.faces.size());
  m_triangle_of.assign(faces, -1);
  std::vector<Id> off, missing;
  std::vector<char> is_covered(m_in.triangles.size(), 0);
  for (Id f = 0; f < faces; ++f)
  {
    const Id polygon = m_result.face_of[f];
    // The parts of a polygon come in the order of its triangles, so the search goes on where the last one ended.
    const Id first = m_in.first_triangle[polygon], size = m_in.first_triangle[polygon + 1] - first;
    const Id hint =
      f > 0 && m_result.face_of[f - 1] == polygon && m_triangle_of[f - 1] >= 0 ? m_triangle_of[f - 1] - first : 0;
    for (Id i = 0; i < size && m_triangle_of[f] < 0; ++i)
    {
      const Id t = first + (hint + i) % size;
      if (!m_in.is_used[t]) { continue; }
      int common = 7;
      bool is_on = true;
      for (Id v : m_result.faces[f])
      {
        const int sides = sides_of(m_result.origin[v], t);
        is_on = is_on && sides >= 0;
        common &= sides;
      }
      if (is_on && common == 0) { m_triangle_of[f] = t; } // three corners on one side have no area
    }
    if (m_triangle_of[f] < 0) { off.push_back(f); }
    else { is_covered[m_triangle_of[f]] = 1; }
  }
  std::size_t polygon = 0;
  for (std::size_t t = 0; t < m_in.triangles.size(); ++t)
  {
    while (m_in.first_triangle[polygon + 1] <= static_cast<Id>(t)) { ++polygon; }
    if (m_in.is_used[t] && !is_covered[t]) { missing.push_back(static_cast<Id>(polygon)); }
  }
  fail("faces do not lie on the face of the input that the map gives them", off);
  fail("faces of the input are missing from the result", missing);
  return off.empty();
}

// What is wrong with the division of the input's faces: faces of the result, and components that are turned over.
struct Mesh_verifier::Faults
{
  std::vector<Id> turned, broken, holes, folded, turned_over;
};

// The faces of the result in one triangle of the input.
struct Mesh_verifier::Division
{
  // A side of the result on the triangle's side `side`: how far along it its ends lie, and which vertices they are.
  struct Rim_side
  {
    int side;
    double from, to;
    Id first, last;
  };
  std::vector<Id> corners;
  std::vector<Rim_side> rim;
  int inner = 0; // how many sides do not lie on the rim

  bool turn_rim(bool forward);
  bool has_whole_rim(const std::array<Id, 3>& triangle);
  bool has_disc_count(Id faces);
};

// Turns the rim's sides to run along the triangle's. Returns whether all ran the way that is said.
bool Mesh_verifier::Division::turn_rim(bool forward)
{
  bool is_alike = true;
  for (Rim_side& p : rim)
  {
    is_alike = is_alike && (p.from < p.to) == forward;
    if (!(p.from < p.to))
    {
      std::swap(p.from, p.to);
      std::swap(p.first, p.last);
    }
  }
  return is_alike;
}

// Whether each side of the triangle is divided from end to end.
bool Mesh_verifier::Division::has_whole_rim(const std::array<Id, 3>& triangle)
{
  std::sort(rim.begin(), rim.end(),
            [](const Rim_side& a, const Rim_side& b) { return a.side != b.side ? a.side < b.side : a.from < b.from; });
  for (std::size_t i = 0; i < rim.size(); ++i)
  {
    const bool first = i == 0 || rim[i - 1].side != rim[i].side,
               last = i + 1 == rim.size() || rim[i + 1].side != rim[i].side;
    if (first ? rim[i].first != triangle[rim[i].side] : rim[i].first != rim[i - 1].last) { return false; }
    if (last && rim[i].last != triangle[(rim[i].side + 1) % 3]) { return false; }
    if (!(rim[i].from < rim[i].to)) { return false; }
  }
  return true;
}

// Whether the Euler characteristic is 1.
bool Mesh_verifier::Division::has_disc_count(Id faces)
{
  std::sort(corners.begin(), corners.end());
  const int vertices = static_cast<int>(std::unique(corners.begin(), corners.end()) - corners.begin());
  const int edges = static_cast<int>(rim.size()) + inner / 2;
  return rim.size() >= 3 && inner % 2 == 0 && vertices - edges + faces == 1;
}

void Mesh_verifier::check_subdivision()
{
  const std::vector<Id> input_side = find_input_sides();
  Faults faults;
  find_mates(input_side, faults);
  check_divisions(input_side, faults);
  fail("components are turned over", faults.turned_over);
  fail("faces are turned against their neighbours", faults.turned);
  fail("faces lack a neighbour that the input has", faults.holes);
  fail("faces of the input are not divided into a disc; it begins with faces of the result", faults.broken);
  fail("faces have no area on the face of the input that they are a part of, or are folded over", faults.folded);
}

std::vector<Id> Mesh_verifier::find_input_sides() const
{
  const Id sides = static_cast<Id>(3 * m_result.faces.size());
  std::vector<Id> input_side(sides, -1);
  for (Id s = 0; s < sides; ++s)
  {
    const Id t = m_triangle_of[s / 3];
    const int common = sides_of(m_result.origin[corner(s)], t) & sides_of(m_result.origin[corner(next_side(s))], t);
    if (common != 0) { input_side[s] = 3 * t + (common == 1 ? 0 : common == 2 ? 1 : 2); }
  }
  return input_side;
}

void Mesh_verifier::find_mates(const std::vector<Id>& input_side, Faults& faults)
{
  const Id sides = static_cast<Id>(3 * m_result.faces.size());
  m_mate.assign(sides, -1);
  const auto root_ends = [&](Id s) { return std::make_pair(root(corner(s)), root(corner(next_side(s)))); };
  for_each_edge(sides, static_cast<Id>(m_result.points.size()), root_ends, [&](auto i, auto j) {
    for (auto a = i; a != j; ++a)
      for (auto b = std::next(a); b != j; ++b)
      {
        const bool inside = input_side[*a] < 0 && input_side[*b] < 0 && m_triangle_of[*a / 3] == m_triangle_of[*b / 3];
        const bool across = input_side[*a] >= 0 && input_side[*b] >= 0 && m_in.twin[input_side[*a]] == input_side[*b];
        if (!inside && !across) { continue; }
        if (m_mate[*a] >= 0 || m_mate[*b] >= 0) { faults.broken.push_back(*a / 3); }
        if (root_ends(*a).first == root_ends(*b).first) { faults.turned.push_back(*b / 3); }
        m_mate[*a] = *b;
        m_mate[*b] = *a;
      }
  });
  for (Id s = 0; s < sides; ++s)
    if (m_mate[s] < 0 && (input_side[s] < 0 || m_in.twin[input_side[s]] >= 0)) { faults.holes.push_back(s / 3); }
}

void Mesh_verifier::check_divisions(const std::vector<Id>& input_side, Faults& faults) const
{
  const Id faces = static_cast<Id>(m_result.faces.size()), triangles = static_cast<Id>(m_in.triangles.size());
  std::vector<Id> begin(triangles + 1, 0), order(faces);
  for (Id t : m_triangle_of) { ++begin[t + 1]; }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Id> fill(begin.begin(), begin.end() - 1);
  for (Id f = 0; f < faces; ++f) { order[fill[m_triangle_of[f]]++] = f; }
  Union_find parts(faces);
  for (Id s = 0; s < 3 * faces; ++s)
    if (input_side[s] < 0 && m_mate[s] >= 0) { parts.join(s / 3, m_mate[s] / 3); }
  Division division;
  std::vector<int> kept(m_report.components.size(), 0); // faces as in the input, less those turned over
  for (Id t = 0; t < triangles; ++t)
  {
    if (begin[t] == begin[t + 1]) { continue; }
    const auto first = order.begin() + begin[t], last = order.begin() + begin[t + 1];
    const bool is_connected = std::all_of(first, last, [&](Id f) { return parts.find(f) == parts.find(*first); });
    collect_division(first, last, input_side, division);
    const bool forward = division.rim.empty() || division.rim.front().from < division.rim.front().to;
    kept[m_in.component[t]] += forward ? 1 : -1;
    if (!division.turn_rim(forward)) { faults.turned.push_back(*first); }
    for (auto f = first; f != last && last - first > 1; ++f)
    {
      if (orientation_in(*f, t) != (forward ? 1 : -1)) { faults.folded.push_back(*f); }
    }
    if (!is_connected || !division.has_whole_rim(m_in.triangles[t])
        || !division.has_disc_count(static_cast<Id>(last - first)))
    {
      faults.broken.push_back(*first);
    }
  }
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    if (kept[i] < 0) { faults.turned_over.push_back(static_cast<Id>(i)); }
  }
}

void Mesh_verifier::collect_division(Face_iterator first, Face_iterator last, const std::vector<Id>& input_side,
                                     Division& division) const
{
  division.corners.clear();
  division.rim.clear();
  division.inner = 0;
  const Id t = m_triangle_of[*first];
  for (; first != last; ++first)
    for (Id s = 3 * *first; s < 3 * *first + 3; ++s)
    {
      division.corners.push_back(root(corner(s)));
      if (input_side[s] < 0)
      {
        ++division.inner;
        continue;
      }
      const int k = input_side[s] % 3;
      division.rim.push_back(
        {k, along(corner(s), t, k), along(corner(next_side(s)), t, k), root(corner(s)), root(corner(next_side(s)))});
    }
}

// A disc whose rim is the triangle's, and whose faces all turn as the triangle does, covers it once. 0 if a face has no
// area there.
int Mesh_verifier::orientation_in(Id f, Id t) const
{
  using Vector = CGAL::Exact_predicates_inexact_constructions_kernel::Vector_3;
  std::array<Vector, 3> at;
  for (int i = 0; i < 3; ++i)
  {
    const Result_origin& o = m_result.origin[m_result.faces[f][i]];
    std::array<double, 3> place = o.weight; // homogeneous barycentric coordinates
    for (int k = 0; k < 3 && o.kind != Result_origin::FACE; ++k)
    {
      const Id c = m_in.triangles[t][k];
      const double second = o.kind == Result_origin::VERTEX ? 0 : o.weight[0];
      place[k] = c == o.index[0] ? 1 - second : c == o.index[1] ? second : 0;
    }
    if (!std::isfinite(place[0]) || !std::isfinite(place[1]) || !std::isfinite(place[2])) { return 0; }
    at[i] = Vector(place[0], place[1], place[2]);
  }
  return CGAL::orientation(at[0], at[1], at[2]);
}

double Mesh_verifier::along(Id v, Id t, int k) const
{
  const Result_origin& o = m_result.origin[v];
  if (o.kind == Result_origin::VERTEX) { return o.index[0] == m_in.triangles[t][k] ? 0 : 1; }
  return o.index[0] == m_in.triangles[t][k] ? o.weight[0] : 1 - o.weight[0];
}

void Mesh_verifier::pair_result()
{
  const Id faces = static_cast<Id>(m_result.faces.size()), vertices = static_cast<Id>(m_result.points.size());
  for (const auto& face : m_result.faces)
    for (Id v : face)
    {
      if (v < 0 || v >= vertices) { return; }
    } // refused before this is used
  m_result_twin.assign(3 * static_cast<std::size_t>(faces), -1);
  for_each_edge(
    3 * faces, vertices, [&](Id s) { return std::make_pair(corner(s), corner(next_side(s))); },
    [&](auto i, auto j) {
      if (j - i > 2)
      {
        for (auto s = i; s != j; ++s) { m_crowded.push_back(*s / 3); }
      }
      if (j - i != 2) { return; }
      const Id a = *i, b = *(i + 1);
      if (corner(a) == corner(b)) { m_against.push_back(b / 3); }
      m_result_twin[a] = b;
      m_result_twin[b] = a;
    });
}

void Mesh_verifier::check_glueing()
{
  const std::vector<Id> seam = check_seams();
  check_glued_counts(seam);
  const Id faces = static_cast<Id>(m_result.faces.size());
  std::vector<Id> mislabelled;
  for (Id f = 0; f < faces; ++f)
  {
    if (m_result.component_of[f] != component(f)) { mislabelled.push_back(f); }
  }
  fail("faces are said to lie in a component that they do not lie in", mislabelled);
}

std::vector<Id> Mesh_verifier::check_seams()
{
  const Id faces = static_cast<Id>(m_result.faces.size());
  std::vector<Id> wrong, unlisted, repeated, superfluous;
  std::vector<Id> seam(3 * static_cast<std::size_t>(faces), -1);
  for (std::size_t i = 0; i < m_result.seams.size(); ++i)
  {
    const auto [a, b] = m_result.seams[i];
    if (a == b || seam[a] >= 0 || seam[b] >= 0)
    {
      repeated.push_back(static_cast<Id>(i));
      continue;
    }
    seam[a] = b;
    seam[b] = a;
    if (m_result_twin[a] >= 0 || m_result_twin[b] >= 0) { superfluous.push_back(static_cast<Id>(i)); }
    else if (m_mate[a] != b) { wrong.push_back(static_cast<Id>(i)); }
  }
  std::vector<Id> wrong_neighbours;
  for (Id s = 0; s < 3 * faces; ++s)
  {
    if (m_result_twin[s] >= 0)
    {
      if (m_result_twin[s] != m_mate[s]) { wrong_neighbours.push_back(s / 3); }
    }
    else if (m_mate[s] >= 0 && seam[s] < 0) { unlisted.push_back(s / 3); }
  }
  fail("faces share an edge with two or more others", m_crowded);
  fail("faces run along an edge in the direction of their neighbour", m_against);
  fail("faces share an edge with a face that is not their neighbour on the input", wrong_neighbours);
  fail("faces are cut from a neighbour without a seam", unlisted);
  fail("seams use a side that another seam uses", repeated);
  fail("seams join sides that are not cut", superfluous);
  fail("seams join sides that were not one edge of the input", wrong);
  return seam;
}

void Mesh_verifier::check_glued_counts(const std::vector<Id>& seam)
{
  const Id faces = static_cast<Id>(m_result.faces.size());
  const int components = static_cast<int>(m_report.components.size());
  std::vector<Id> glued(m_result_twin);
  for (Id s = 0; s < 3 * faces; ++s)
  {
    if (glued[s] < 0) { glued[s] = seam[s]; }
  }
  Union_find fans(3 * static_cast<std::size_t>(faces));
  for (Id s = 0; s < 3 * faces; ++s)
    if (glued[s] > s)
    {
      fans.join(s, next_side(glued[s]));
      fans.join(next_side(s), glued[s]);
    }
  const Counts c = count_glued(
    faces, glued, components, [&](Id f) { return component(f); }, fans);
  std::vector<Id> different;
  for (int i = 0; i < components; ++i)
  {
    Component_count& count = m_report.components[i];
    count.glued_euler_characteristic = c.vertices[i] - c.edges[i] + c.faces[i];
    count.glued_boundary_loops = c.loops[i];
    if (count.glued_euler_characteristic != count.euler_characteristic
        || count.glued_boundary_loops != count.boundary_loops)
    {
      different.push_back(i);
    }
  }
  fail("components have another Euler characteristic or number of boundary loops than the input once the seams are "
       "glued",
       different);
}

Union_find Mesh_verifier::find_fans(Union_find* parts)
{
  const Id faces = static_cast<Id>(m_result.faces.size());
  Union_find fans(3 * static_cast<std::size_t>(faces));
  for (Id s = 0; s < 3 * faces; ++s)
  {
    const Id o = m_result_twin[s];
    if (o < s) { continue; }
    if (parts) { parts->join(s / 3, o / 3); }
    const bool opposite = corner(s) == corner(next_side(o));
    fans.join(s, opposite ? next_side(o) : o);
    fans.join(next_side(s), opposite ? o : next_side(o));
  }
  std::vector<Id> pinched;
  std::vector<char> has_fan(m_result.points.size(), 0);
  for (Id s = 0; s < 3 * faces; ++s)
  {
    if (fans.find(s) != s) { continue; }
    if (has_fan[corner(s)]) { pinched.push_back(corner(s)); }
    has_fan[corner(s)] = 1;
  }
  fail("vertices are pinched: their faces form several fans", pinched);
  return fans;
}

} // namespace verification

} // namespace meridian
