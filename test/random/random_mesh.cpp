// SPDX-License-Identifier: GPL-3.0-or-later
#include "random/random_mesh.h"

#include "support/sample_surfaces.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>

namespace random_runs {

namespace {

using meridian::Triangle_surface;

Triangle_surface base_surface(Random& random)
{
  switch (random.below(7))
  {
  case 0: return sample::sphere(random.below(3));
  case 1: return sample::torus(3 + random.below(10), 3 + random.below(8));
  case 2: return sample::plate(1 + random.below(6), 1 + random.below(2));
  case 3: return sample::plate(random.once_in(8) ? 50 : 7 + random.below(10), 1);
  case 4:
    return sample::sheet(1 + random.below(9), 1 + random.below(6), [](double x, double y) {
      return meridian::Point{x, y, 0.3 * x * y};
    });
  case 5: return sample::tube_with_cap(3 + random.below(8), 2 + random.below(5));
  default: return sample::subdivided(sample::torus(3, 3 + random.below(3)));
  }
}

// The skin of any set of cubes, of which many touch along edges and at corners.
void add_cubes(Mesh& mesh, Random& random)
{
  constexpr int n = 3;
  std::set<std::array<int, 3>> filled;
  for (int i = 0; i < 14; ++i) { filled.insert({random.below(n), random.below(n), random.below(n)}); }
  std::map<std::array<int, 3>, int> index;
  const auto vertex = [&](const std::array<int, 3>& c) {
    const auto [at, is_new] = index.try_emplace(c, static_cast<int>(mesh.points.size()));
    if (is_new) { mesh.points.push_back({-1. - c[0], 1. * c[1], 1. * c[2]}); }
    return at->second;
  };
  for (const auto& cube : filled)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (int side : {0, 1})
      {
        std::array<int, 3> beyond = cube;
        beyond[axis] += side ? 1 : -1;
        if (filled.count(beyond)) { continue; }
        std::array<int, 4> q;
        for (int k = 0; k < 4; ++k)
        {
          std::array<int, 3> corner = cube;
          corner[axis] += side;
          corner[(axis + 1) % 3] += k == 1 || k == 2;
          corner[(axis + 2) % 3] += k == 2 || k == 3;
          q[side ? k : 3 - k] = vertex(corner);
        }
        mesh.faces.push_back({q[0], q[1], q[2]});
        mesh.faces.push_back({q[0], q[2], q[3]});
      }
  mesh.description += " cubes;";
}

void add(Mesh& mesh, const Triangle_surface& s, double shift)
{
  const int first = static_cast<int>(mesh.points.size());
  for (const auto& p : s.points) { mesh.points.push_back({p[0] + shift, p[1], p[2]}); }
  for (const auto& t : s.triangles) { mesh.faces.push_back({first + t[0], first + t[1], first + t[2]}); }
}

void take_faces_out(Mesh& mesh, Random& random)
{
  for (int n = 1 + random.below(6); n > 0 && mesh.faces.size() > 1; --n)
  {
    mesh.faces.erase(mesh.faces.begin() + random.below(static_cast<int>(mesh.faces.size())));
  }
  mesh.description += " faces out;";
}

// Two vertices become one: a pinched vertex, or edges and faces that are there twice.
void merge_vertices(Mesh& mesh, Random& random)
{
  const int n = static_cast<int>(mesh.points.size()), v = random.below(n), w = random.below(n);
  for (auto& face : mesh.faces) { std::replace(face.begin(), face.end(), v, w); }
  mesh.description += " vertices merged;";
}

void add_odd_faces(Mesh& mesh, Random& random)
{
  const int n = static_cast<int>(mesh.points.size());
  const std::vector<int> face = random.one_of(mesh.faces);
  switch (random.below(4))
  {
  case 0: mesh.faces.push_back(face); break; // there twice
  case 1: mesh.faces.push_back({face[0], face[1], random.below(n)}); break;
  case 2: mesh.faces.push_back({face[0], face[0], face[1]}); break;
  default:
    mesh.points.push_back({0.5, 7, 1}); // a fin
    mesh.faces.push_back({face[1], face[0], n});
  }
  mesh.description += " odd face;";
}

void turn_faces(Mesh& mesh, Random& random)
{
  for (auto& face : mesh.faces)
  {
    if (random.once_in(3)) { std::swap(face[0], face[1]); }
  }
  mesh.description += " faces turned;";
}

void shuffle(Mesh& mesh, Random& random)
{
  std::vector<int> number(mesh.points.size());
  for (std::size_t i = 0; i < number.size(); ++i) { number[i] = static_cast<int>(i); }
  for (std::size_t i = number.size(); i-- > 1;) { std::swap(number[i], number[random.below(static_cast<int>(i + 1))]); }
  std::vector<std::array<double, 3>> points(mesh.points.size());
  for (std::size_t i = 0; i < number.size(); ++i) { points[number[i]] = mesh.points[i]; }
  mesh.points = points;
  for (auto& face : mesh.faces)
    for (int& v : face) { v = number[v]; }
  for (std::size_t i = mesh.faces.size(); i-- > 1;)
  {
    std::swap(mesh.faces[i], mesh.faces[random.below(static_cast<int>(i + 1))]);
  }
  mesh.description += " shuffled;";
}

// Where points are has no part in the topology.
void move_points(Mesh& mesh, Random& random)
{
  const int kind = random.below(12);
  const double size = std::pow(10, 200 * random.fraction() - 100);
  for (auto& p : mesh.points)
    for (std::size_t k = 0; k < 3; ++k)
    {
      double& x = p[k];
      switch (kind)
      {
      case 0: x = 1; break;
      case 1: x = k == 0 ? random.fraction() : 0; break;
      case 2: x = random.below(3); break;
      case 3: x = (random.below(2) ? 1 : -1) * std::pow(10, 200 * random.fraction() - 100); break;
      case 4: x *= size; break;
      case 5: x *= k == 2 ? 1e-13 : 1; break;
      case 6: x = k == 0 ? std::pow(10, 200 * random.fraction() - 100) : 0; break;
      case 7: x = x + 1e9 * static_cast<double>(k + 1); break;
      case 8: x = random.fraction(); break;
      default: x += 0.05 * random.fraction();
      }
    }
  if (kind == 9 && mesh.points.size() > 4) // some points are equal
  {
    for (int n = 0; n < 4; ++n) { mesh.points[random.below(static_cast<int>(mesh.points.size()))] = mesh.points[0]; }
  }
  mesh.description += " points " + std::to_string(kind) + ";";
}

} // namespace

Mesh random_mesh(Random& random)
{
  Mesh mesh;
  const int components = random.once_in(4) ? 2 + random.below(3) : 1;
  for (int i = 0; i < components; ++i) { add(mesh, base_surface(random), 10. * i); }
  if (random.once_in(12)) { add_cubes(mesh, random); }
  if (random.once_in(3)) { take_faces_out(mesh, random); }
  if (random.once_in(8)) { merge_vertices(mesh, random); }
  if (random.once_in(10)) { add_odd_faces(mesh, random); }
  if (random.once_in(6)) { turn_faces(mesh, random); }
  if (random.once_in(2)) { move_points(mesh, random); }
  if (random.once_in(10)) // no face uses it
  {
    const double odd[] = {0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()};
    mesh.points.push_back({1, odd[random.below(3)], 2});
    mesh.description += " vertex without faces;";
  }
  if (random.once_in(2)) { shuffle(mesh, random); }
  return mesh;
}

std::string format_off(const Mesh& mesh)
{
  std::string text = "OFF\n" + std::to_string(mesh.points.size()) + ' ' + std::to_string(mesh.faces.size()) + " 0\n";
  char digits[40];
  for (const auto& p : mesh.points)
    for (std::size_t k = 0; k < 3; ++k)
    {
      text.append(digits, std::to_chars(digits, digits + sizeof digits, p[k]).ptr);
      text += k == 2 ? '\n' : ' ';
    }
  for (const auto& face : mesh.faces)
  {
    text += std::to_string(face.size());
    for (int v : face) { text += ' ' + std::to_string(v); }
    text += '\n';
  }
  return text;
}

Arguments read_arguments(int argc, char** argv)
{
  const auto number = [&](int i, unsigned otherwise) {
    return argc > i ? static_cast<unsigned>(std::atoi(argv[i])) : otherwise;
  };
  return {number(1, 1), number(2, 300)};
}

} // namespace random_runs
