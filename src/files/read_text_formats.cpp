// SPDX-License-Identifier: GPL-3.0-or-later
// OFF and STL.
#include "Scanner.h"
#include "formats.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/vectors.h>

#include <cmath>
#include <unordered_map>

namespace meridian {
namespace files {

namespace {

std::int32_t checked_count(const Scanner& in, std::int64_t n, const char* name)
{
  if (n < 0 || n > 500000000) { in.fail("the number of " + std::string(name) + " is " + std::to_string(n)); }
  return static_cast<std::int32_t>(n);
}

struct Hash
{
  std::size_t operator()(const Point& p) const
  {
    std::uint64_t h = 1469598103934665603u;
    for (double x : p)
    {
      std::uint64_t bits;
      std::memcpy(&bits, &x, sizeof bits);
      h = (h ^ bits) * 1099511628211u;
      h ^= h >> 29;
    }
    return static_cast<std::size_t>(h);
  }
};

// Vertices of an STL file are its distinct points, in order of first appearance.
class Welder
{
public:
  explicit Welder(Polygon_soup& soup) : m_soup(soup) {}
  std::int32_t operator()(Point p)
  {
    for (double& x : p) { x += 0.; } // -0 becomes 0
    const bool is_number = !std::isnan(p[0]) && !std::isnan(p[1]) && !std::isnan(p[2]);
    const auto index = static_cast<std::int32_t>(m_soup.points.size());
    if (is_number)
    {
      const auto [at, is_new] = m_index.try_emplace(p, index);
      if (!is_new) { return at->second; }
    }
    m_soup.points.push_back(p);
    return index;
  }

private:
  Polygon_soup& m_soup;
  std::unordered_map<Point, std::int32_t, Hash> m_index;
};

Polygon_soup read_binary_stl(const std::string& bytes, std::uint32_t n)
{
  Polygon_soup soup;
  Welder weld(soup);
  for (std::uint32_t i = 0; i < n; ++i)
  {
    std::array<std::int32_t, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
    {
      std::array<float, 3> p;
      std::memcpy(p.data(), bytes.data() + 84 + 50 * std::size_t(i) + 12 * (k + 1), sizeof p);
      corners[k] = weld({p[0], p[1], p[2]});
    }
    soup.add_polygon(corners.data(), 3);
  }
  return soup;
}

} // namespace

Polygon_soup read_off(const std::string& bytes)
{
  Scanner in(bytes, "OFF", '#');
  Polygon_soup soup;
  std::string_view head = in.word();
  if (head.size() >= 3 && head.substr(head.size() - 3) == "OFF")
  {
    const std::string_view kind = head.substr(0, head.size() - 3);
    if (kind.find('4') != std::string_view::npos || kind.find('n') != std::string_view::npos)
      in.fail("points of dimension other than 3 ('" + std::string(head) + "')");
    head = in.word();
    if (head == "BINARY") { in.fail("binary OFF is not supported; write it as text"); }
  }
  else if (head.empty() || (head[0] < '0' || head[0] > '9')) { in.fail("the file does not begin with 'OFF'"); }
  const std::int32_t n = checked_count(in, in.parse<std::int64_t>(head, "the number of vertices"), "vertices");
  const std::int32_t f = checked_count(in, in.integer("the number of faces"), "faces");
  if (!in.at_line_end()) { in.integer("the number of edges"); }
  soup.points.reserve(static_cast<std::size_t>(std::min<std::int64_t>(n, static_cast<std::int64_t>(bytes.size() / 2))));
  for (std::int32_t i = 0; i < n; ++i)
  {
    Point p;
    for (double& x : p) { x = in.real("a coordinate"); }
    soup.points.push_back(p);
    if (!in.at_line_end()) { in.skip_line(); } // colours, normals
  }
  std::vector<std::int32_t> corners;
  for (std::int32_t i = 0; i < f; ++i)
  {
    const std::int64_t k = in.integer("the number of corners of a face");
    if (k < 0 || k > n) { in.fail("face " + std::to_string(i) + " is said to have " + std::to_string(k) + " corners"); }
    corners.clear();
    for (std::int64_t j = 0; j < k; ++j)
    {
      if (in.at_line_end() && !in.at_end())
        in.fail("face " + std::to_string(i) + " is said to have " + std::to_string(k) + " corners and has "
                + std::to_string(j));
      corners.push_back(clamped(in.integer("a vertex of a face")));
    }
    soup.add_polygon(corners.data(), corners.size());
    if (!in.at_line_end()) { in.skip_line(); } // colours
  }
  return soup;
}

Polygon_soup read_stl(const std::string& bytes)
{
  std::uint32_t n = 0;
  if (bytes.size() >= 84)
  {
    std::memcpy(&n, bytes.data() + 80, sizeof n);
    if (bytes.size() == 84 + 50 * static_cast<std::size_t>(n)) { return read_binary_stl(bytes, n); }
  }
  Scanner in(bytes, "STL");
  if (in.at_end() || in.word() != "solid")
    in.fail("neither text nor binary STL: the header counts " + std::to_string(n) + " triangles, the file has "
            + std::to_string(bytes.size()) + " bytes");
  in.skip_line();
  Polygon_soup soup;
  Welder weld(soup);
  std::vector<std::int32_t> corners;
  bool is_closed = false;
  while (!in.at_end())
  {
    const std::string_view key = in.word();
    if (key == "vertex")
    {
      Point p;
      for (double& x : p) { x = in.real("a coordinate"); }
      corners.push_back(weld(p));
    }
    else if (key == "endloop")
    {
      soup.add_polygon(corners.data(), corners.size());
      corners.clear();
    }
    else if (key == "endsolid")
    {
      is_closed = true;
      in.skip_line();
    }
    else if (key == "solid")
    {
      is_closed = false;
      in.skip_line();
    }
    else if (key == "facet") { in.skip_line(); }
    else if (key != "outer" && key != "loop" && key != "endfacet")
    {
      in.fail("unexpected word '" + std::string(key.substr(0, 40)) + "'");
    }
  }
  if (!is_closed || !corners.empty()) { in.fail("the file ends within a solid"); }
  return soup;
}

} // namespace files
} // namespace meridian
