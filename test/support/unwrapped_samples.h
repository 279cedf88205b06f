// Opened meshes with texture coordinates, built in code, and what tests of their files share.
#ifndef MERIDIAN_TEST_UNWRAPPED_SAMPLES_H
#define MERIDIAN_TEST_UNWRAPPED_SAMPLES_H

#include "sample_surfaces.h"

#include "files/Output_files.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

#include <cstdlib>
#include <filesystem>
#include <set>

namespace unwrapped {

using namespace meridian;
using Texture = std::vector<Plane_point>;

// A folder that goes away with the test.
struct Folder
{
  std::filesystem::path path;
  Folder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "meridian-XXXXXX").string();
    path = mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(path); }
  std::string write(const std::string& name, const std::string& bytes) const
  {
    files::Output_files out;
    out.add((path / name).string(), bytes); // packs
    out.commit();
    return (path / name).string();
  }
  template <class Read> std::string message_of(const Read& read) const
  {
    try
    {
      read();
    }
    catch (const files::File_error& e)
    {
      return e.what();
    }
    return "";
  }
};

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

inline std::size_t count(const std::string& text, const std::string& part)
{
  std::size_t n = 0;
  for (std::size_t i = text.find(part); i != std::string::npos; i = text.find(part, i + 1)) { ++n; }
  return n;
}

inline Index base(const Result_mesh& m, Index v) { return m.copy_of[v] < 0 ? v : m.copy_of[v]; }

// Glues the border sides of an opened mesh that were one edge.
inline void find_seams(Result_mesh& m)
{
  std::set<std::pair<Index, Index>> sides;
  std::map<std::pair<Index, Index>, Index> open;
  const auto each_side = [&](const auto& f) {
    for (Index h = 0; h < static_cast<Index>(3 * m.faces.size()); ++h)
    {
      f(h, m.faces[h / 3][h % 3], m.faces[h / 3][(h + 1) % 3]);
    }
  };
  each_side([&](Index, Index a, Index b) { sides.insert({a, b}); });
  each_side([&](Index h, Index a, Index b) {
    if (sides.count({b, a})) { return; }
    const auto twin = open.find({base(m, b), base(m, a)});
    if (twin == open.end()) { open[{base(m, a), base(m, b)}] = h; }
    else { m.seams.push_back({twin->second, h}); }
  });
}

// A surface with every chart taken off its neighbours.
inline Result_mesh opened_into_charts(const Triangle_surface& s, const std::function<Index(Index)>& chart_of)
{
  Result_mesh m;
  m.points = s.points;
  m.copy_of.assign(s.points.size(), -1);
  std::map<std::pair<Index, Index>, Index> number; // of a vertex in a chart
  std::set<Index> seen;
  for (Index f = 0; f < s.number_of_faces(); ++f)
  {
    m.faces.push_back(s.triangles[f]);
    m.face_of.push_back(f);
    for (Index& v : m.faces.back())
    {
      const Index of = v, copy = seen.insert(of).second ? of : static_cast<Index>(m.points.size());
      const auto [at, is_new] = number.try_emplace({of, chart_of(f)}, copy);
      v = at->second;
      if (!is_new || v == of) { continue; }
      m.points.push_back(s.points[of]);
      m.copy_of.push_back(of);
    }
  }
  find_seams(m);
  return m;
}

// A torus of n x m quadrilaterals, cut along two circles and laid out as the unit square.
struct Torus
{
  Polygon_soup soup;
  Result_mesh mesh;
  Texture texture;
};
inline Torus opened_torus(Index n, Index m)
{
  Torus t;
  t.soup.points = sample::torus(n, m).points;
  t.mesh.points = t.soup.points;
  t.mesh.copy_of.assign(n * m, -1);
  std::map<std::pair<Index, Index>, Index> number;
  for (Index v = 0; v < n * m; ++v)
  {
    number[{v / m, v % m}] = v;
    t.texture.push_back({double(v / m) / n, double(v % m) / m});
  }
  for (Index i = 0; i <= n; ++i)
    for (Index j = 0; j <= m; ++j)
    {
      const Index v = i % n * m + j % m;
      if (!number.try_emplace({i, j}, static_cast<Index>(t.mesh.points.size())).second) { continue; }
      t.mesh.points.push_back(t.soup.points[v]);
      t.mesh.copy_of.push_back(v);
      t.texture.push_back({double(i) / n, double(j) / m});
    }
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < m; ++j)
    {
      const std::array<Index, 4> q{number[{i, j + 1}], number[{i, j}], number[{i + 1, j}], number[{i + 1, j + 1}]};
      std::array<Index, 4> corners;
      for (int k = 0; k < 4; ++k) { corners[k] = base(t.mesh, q[k]); }
      const auto lowest = std::min_element(corners.begin(), corners.end()) - corners.begin();
      for (int k = 1; k < 3; ++k)
      {
        t.mesh.faces.push_back({q[lowest], q[(lowest + k) % 4], q[(lowest + k + 1) % 4]});
        t.mesh.face_of.push_back(static_cast<Index>(t.soup.number_of_polygons()));
      }
      t.soup.add_polygon(corners.data(), 4);
    }
  find_seams(t.mesh);
  return t;
}

inline Texture random_texture(const Result_mesh& m, unsigned seed)
{
  std::mt19937_64 random(seed);
  Texture texture(m.points.size());
  for (auto& t : texture)
    for (double& x : t) { x = static_cast<double>(random() >> 11) / 9007199254740992.; }
  return texture;
}

} // namespace unwrapped

#endif // MERIDIAN_TEST_UNWRAPPED_SAMPLES_H
