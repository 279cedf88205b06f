// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_TEST_RANDOM_MESH_H
#define MERIDIAN_TEST_RANDOM_MESH_H

#include <array>
#include <random>
#include <string>
#include <vector>

namespace random_runs {

// The same numbers everywhere: the distributions of the standard library differ.
class Random
{
public:
  explicit Random(unsigned seed) : m_engine(seed) {}
  double fraction() { return static_cast<double>(m_engine()) / 4294967296.; }
  int below(int n) { return static_cast<int>(m_engine() % static_cast<unsigned>(n)); }
  bool once_in(int n) { return below(n) == 0; }
  template <class Values> auto one_of(const Values& values) { return values[below(static_cast<int>(values.size()))]; }

private:
  std::mt19937 m_engine;
};

struct Mesh
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<int>> faces;
  std::string description;
};

// A surface of genus 0 to 50 with anything that meshes of people have: loops, components, pinched vertices, faces that
// are turned over, repeat a vertex or are one too many, equal points, slivers, and coordinates of any size.
Mesh random_mesh(Random& random);

std::string format_off(const Mesh& mesh);

// What a program is asked for: FIRST and COUNT, by themselves 1 and 300.
struct Arguments
{
  unsigned first, count;
};
Arguments read_arguments(int argc, char** argv);

} // namespace random_runs

#endif // MERIDIAN_TEST_RANDOM_MESH_H
