// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/unfold_disc.h>

#include <meridian/base/exceptions.h>
#include <meridian/field/Sparse_matrix.h>
#include <meridian/field/edge_weights.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace meridian {

namespace internal {

namespace {

class Disc_unfolder
{
public:
  Disc_unfolder(const Triangle_surface& disc, Make_solver make_solver)
    : m_disc(disc), m_make_solver(make_solver), m_flat(disc.number_of_faces()), m_strength(disc.number_of_halfedges()),
      m_turn(disc.number_of_faces(), 0), m_at(disc.number_of_vertices(), Plane_point{0, 0})
  {
    for (Index f = 0; f < disc.number_of_faces(); ++f) { flatten(f); }
  }

  // Turns faces as they unfold.
  void turn_by_connection()
  {
    const std::vector<double> weights = edge_weights(m_disc, Weights::POSITIVE), u = potential(weights);
    std::vector<Index> stack{0};
    std::vector<char> is_turned(m_disc.number_of_faces(), 0);
    is_turned[0] = 1;
    while (!stack.empty())
    {
      const Index f = stack.back();
      stack.pop_back();
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        const Index o = m_disc.opposite[h];
        if (o < 0 || is_turned[m_disc.face(o)]) { continue; }
        const Index g = m_disc.face(o);
        is_turned[g] = 1;
        // `h` leaves its source clockwise of the face
        const double further = weights[h] * (u[m_disc.source(h)] - u[m_disc.target(h)]);
        m_turn[g] = m_turn[f] + direction(h) - direction(o) - std::acos(-1.) - further;
        stack.push_back(g);
      }
    }
  }

  // Turns each face so that it fits its image best.
  void turn_by_image()
  {
    for (Index f = 0; f < m_disc.number_of_faces(); ++f)
    {
      double cosine = 0, sine = 0;
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        const Plane_point own = side(h), image = m_at[m_disc.target(h)] - m_at[m_disc.source(h)];
        cosine += m_strength[h] * dot(own, image);
        sine += m_strength[h] * cross(own, image);
      }
      m_turn[f] = std::atan2(sine, cosine);
    }
  }

  // Finds the points that fit the turned faces best; the first stays where it is.
  void place()
  {
    if (!m_solver) { factor(); }
    const Index n = m_disc.number_of_vertices();
    std::array<std::vector<double>, 2> right{std::vector<double>(n, 0), std::vector<double>(n, 0)};
    for (Index h = 0; h < m_disc.number_of_halfedges(); ++h)
    {
      const double c = std::cos(m_turn[m_disc.face(h)]), s = std::sin(m_turn[m_disc.face(h)]);
      const Plane_point own = side(h);
      const std::array<double, 2> turned{c * own[0] - s * own[1], s * own[0] + c * own[1]};
      for (std::size_t k = 0; k < 2; ++k)
      {
        right[k][m_disc.source(h)] -= m_strength[h] * turned[k];
        right[k][m_disc.target(h)] += m_strength[h] * turned[k];
      }
    }
    std::vector<double> solution;
    for (std::size_t k = 0; k < 2; ++k)
    {
      right[k][0] = 0;
      if (!m_solver->solve(right[k], solution)) { throw Solver_error("unfold_disc: the points cannot be solved for"); }
      for (Index v = 0; v < n; ++v) { m_at[v][k] = solution[v]; }
    }
  }

  std::vector<Plane_point> take_points() { return std::move(m_at); }

private:
  // Lays a face into the plane, its first side along the x-axis, and finds how strongly each side holds: the cotangent
  // of the angle across from it, within bounds.
  void flatten(Index f)
  {
    const auto& t = m_disc.triangles[f];
    const Point to_second = m_disc.points[t[1]] - m_disc.points[t[0]],
                to_third = m_disc.points[t[2]] - m_disc.points[t[0]];
    const double length = norm(to_second), twice = norm(cross(to_second, to_third));
    m_flat[f][1] = {length, 0};
    m_flat[f][2] =
      length > 0 ? Plane_point{dot(to_second, to_third) / length, twice / length} : Plane_point{norm(to_third), 0};
    for (Index k = 0; k < 3; ++k)
    {
      const Plane_point a = m_flat[f][k] - m_flat[f][(k + 2) % 3], b = m_flat[f][(k + 1) % 3] - m_flat[f][(k + 2) % 3];
      constexpr double least = 0.05, most = 20;
      const double along = dot(a, b), across = cross(a, b);
      m_strength[3 * f + k] = across * most > along ? std::max(along / across, least) : most;
    }
  }

  Plane_point side(Index h) const { return m_flat[h / 3][(h + 1) % 3] - m_flat[h / 3][h % 3]; }
  double direction(Index h) const
  {
    const Plane_point d = side(h);
    return std::atan2(d[1], d[0]);
  }

  // The potential whose flow out of each vertex inside the disc is its angle defect; 0 on the border.
  std::vector<double> potential(const std::vector<double>& weights) const
  {
    std::vector<Index> row(m_disc.number_of_vertices(), -1), unknown;
    for (Index v = 0; v < m_disc.number_of_vertices(); ++v)
    {
      if (m_disc.is_boundary_vertex(v)) { continue; }
      row[v] = static_cast<Index>(unknown.size());
      unknown.push_back(v);
    }
    std::vector<double> u(m_disc.number_of_vertices(), 0);
    if (unknown.empty()) { return u; }
    Sparse_matrix a(static_cast<Index>(unknown.size()), 7 * unknown.size());
    std::vector<double> right, solution;
    for (Index v : unknown)
    {
      double sum = 0, defect = 2 * std::acos(-1.);
      m_disc.for_each_outgoing(v, [&](Index h) {
        const Index w = row[m_disc.target(h)];
        sum += weights[h];
        if (w >= 0) { a.add(w, -weights[h]); }
        const Plane_point to_next = side(h), to_last = Plane_point{0, 0} - side(m_disc.prev(h));
        defect -= std::atan2(cross(to_next, to_last), dot(to_next, to_last));
      });
      a.add(row[v], sum);
      a.end_row();
      right.push_back(defect);
    }
    const auto solver = m_make_solver();
    if (!solver->factor(a) || !solver->solve(right, solution))
    {
      throw Solver_error("unfold_disc: the connection cannot be solved for");
    }
    for (std::size_t i = 0; i < unknown.size(); ++i) { u[unknown[i]] = solution[i]; }
    return u;
  }

  void factor()
  {
    Sparse_matrix a(m_disc.number_of_vertices(), 7 * static_cast<std::size_t>(m_disc.number_of_vertices()));
    for (Index v = 0; v < m_disc.number_of_vertices(); ++v)
    {
      double sum = 0;
      const auto join = [&](Index w, double strength) {
        sum += strength;
        if (v > 0 && w > 0) { a.add(w, -strength); }
      };
      m_disc.for_each_outgoing(v, [&](Index h) {
        join(m_disc.target(h), m_strength[h]);
        join(m_disc.apex(h), m_strength[m_disc.prev(h)]);
      });
      a.add(v, v > 0 ? sum : 1);
      a.end_row();
    }
    m_solver = m_make_solver();
    if (!m_solver->factor(a)) { throw Solver_error("unfold_disc: the points cannot be solved for"); }
  }

  const Triangle_surface& m_disc;
  const Make_solver m_make_solver;
  std::vector<std::array<Plane_point, 3>> m_flat; // the corners of each face
  std::vector<double> m_strength;                 // of each halfedge
  std::vector<double> m_turn;                     // of each face
  std::vector<Plane_point> m_at;
  std::unique_ptr<Sparse_solver> m_solver;
};

} // namespace

} // namespace internal

std::vector<Plane_point> unfold_disc(const Triangle_surface& disc, Make_solver solver)
{
  constexpr int rounds = 8; // more gain little
  internal::Disc_unfolder unfolder(disc, solver);
  unfolder.turn_by_connection();
  unfolder.place();
  for (int i = 0; i < rounds; ++i)
  {
    unfolder.turn_by_image();
    unfolder.place();
  }
  return unfolder.take_points();
}

} // namespace meridian
