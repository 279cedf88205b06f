// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh_attributes.h"
#include "Scanner.h"
#include "formats.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/vectors.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace meridian {
namespace files {

namespace {

// Joins lines that end with a backslash to the next; empty if there are none.
std::string join_lines(const std::string& bytes)
{
  if (bytes.find("\\\n") == std::string::npos && bytes.find("\\\r\n") == std::string::npos) { return ""; }
  std::string joined = bytes;
  for (std::size_t i = joined.find('\\'); i != std::string::npos; i = joined.find('\\', i))
  {
    std::size_t j = i + 1;
    if (j < joined.size() && joined[j] == '\r') { ++j; }
    if (j < joined.size() && joined[j] == '\n')
    {
      for (; i <= j; ++i) { joined[i] = ' '; }
    }
    else { ++i; }
  }
  return joined;
}

// Reads what is no point and no corner. What is malformed there is left out: the mesh is none the worse.
class Attribute_reader
{
public:
  Attribute_reader(Scanner& in, Mesh_attributes& attributes) : m_in(in), m_attributes(attributes)
  {
    m_current.fill(-1);
  }

  // What follows the coordinates of point `index`.
  void read_colour(std::size_t index)
  {
    Point colour;
    if (!read_numbers(colour)) { return; }
    m_attributes.colours.resize(index, {1, 1, 1});
    m_attributes.colours.push_back(colour);
  }

  // A line that begins with another word than `v` and `f`.
  void read_line(std::string_view key)
  {
    if (key == "vt")
    {
      Plane_point p{0, 0};
      std::array<double, 1> u, v{0};
      if (read_numbers(u) && (m_in.at_line_end() || read_numbers(v))) { p = {u[0], v[0]}; }
      m_attributes.texture.push_back(p);
    }
    else if (key == "vn")
    {
      Point p{0, 0, 0};
      if (!read_numbers(p)) { p = {0, 0, 0}; }
      m_attributes.normals.push_back(p);
    }
    else if (key == "mtllib") { m_attributes.libraries.emplace_back(rest_of_line()); }
    else if (const auto kind = from_name<Part_kind>(std::string(key))) { name_part(*kind, rest_of_line()); }
  }

  // The corner of a face, after its vertex: `/t`, `//n` or `/t/n`.
  void read_corner(std::string_view rest)
  {
    const std::size_t slash = rest.empty() ? std::string_view::npos : rest.find('/', 1);
    const std::string_view texture = rest.substr(0, slash);
    add(texture, m_attributes.texture.size(), m_attributes.texture_of);
    add(slash == std::string_view::npos ? std::string_view() : rest.substr(slash), m_attributes.normals.size(),
        m_attributes.normal_of);
  }

  void end_face()
  {
    for (std::size_t k = 0; k < m_current.size(); ++k) { m_attributes.parts[k].of.push_back(m_current[k]); }
  }

  // Takes away what the file has nothing of.
  void finish(std::size_t points)
  {
    if (!m_attributes.colours.empty()) { m_attributes.colours.resize(points, {1, 1, 1}); }
    if (m_attributes.texture.empty()) { m_attributes.texture_of.clear(); }
    if (m_attributes.normals.empty()) { m_attributes.normal_of.clear(); }
    for (Named_parts& parts : m_attributes.parts)
    {
      if (parts.names.empty()) { parts.of.clear(); }
    }
  }

private:
  template <std::size_t N> bool read_numbers(std::array<double, N>& numbers)
  {
    for (double& x : numbers)
    {
      const std::string_view word = m_in.word_on_line();
      if (word.empty() || !parse_real(word, x)) { return false; }
    }
    return true;
  }

  static bool parse_real(std::string_view word, double& x)
  {
    if (word.front() == '+') { word.remove_prefix(1); }
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), x);
    return error == std::errc() && end == word.data() + word.size();
  }

  // What is left of a line, without spaces around.
  std::string_view rest_of_line()
  {
    m_in.at_line_end(); // skips spaces
    const char *first = m_in.position(), *last = first;
    for (std::string_view word = m_in.word_on_line(); !word.empty(); word = m_in.word_on_line())
    {
      last = word.data() + word.size();
    }
    return {first, static_cast<std::size_t>(last - first)};
  }

  void name_part(Part_kind kind, std::string_view name)
  {
    const auto k = static_cast<std::size_t>(kind);
    if (kind == Part_kind::SMOOTHING && (name == "off" || name == "0")) // as before any was named
    {
      m_current[k] = -1;
      return;
    }
    Named_parts& parts = m_attributes.parts[k];
    const auto [at, is_new] =
      m_numbers[k].try_emplace(std::string(name), static_cast<std::int32_t>(parts.names.size()));
    if (is_new) { parts.names.emplace_back(name); }
    m_current[k] = at->second;
  }

  // An index behind a slash, if there is one.
  static void add(std::string_view slash_and_index, std::size_t count, std::vector<std::int32_t>& of)
  {
    std::int64_t i = 0;
    if (slash_and_index.size() > 1)
    {
      std::from_chars(slash_and_index.data() + 1, slash_and_index.data() + slash_and_index.size(), i);
    }
    const std::int64_t place = place_of(i, count);
    of.push_back(place < 0 || place >= static_cast<std::int64_t>(count) ? -1 : static_cast<std::int32_t>(place));
  }

  Scanner& m_in;
  Mesh_attributes& m_attributes;
  std::array<std::int32_t, number_of<Part_kind>> m_current;                                  // part of each kind
  std::array<std::unordered_map<std::string, std::int32_t>, number_of<Part_kind>> m_numbers; // of names
};

Point read_point(Scanner& in)
{
  Point p;
  for (double& x : p)
  {
    if (in.at_line_end()) { in.fail("a vertex has fewer than three coordinates"); }
    x = in.real("a coordinate");
  }
  return p;
}

} // namespace

Polygon_soup read_obj(const std::string& bytes, Mesh_attributes* attributes)
{
  const std::string joined = join_lines(bytes);
  Scanner in(joined.empty() ? bytes : joined, "OBJ", '#');
  std::optional<Attribute_reader> more;
  if (attributes) { more.emplace(in, *attributes); }
  Polygon_soup soup;
  std::vector<std::int32_t> corners;
  while (!in.at_end())
  {
    const std::string_view key = in.word();
    if (key == "v")
    {
      soup.points.push_back(read_point(in));
      if (more && !in.at_line_end()) { more->read_colour(soup.points.size() - 1); }
    }
    else if (key == "f")
    {
      corners.clear();
      for (std::string_view word = in.word_on_line(); !word.empty(); word = in.word_on_line())
      {
        const std::size_t slash = word.find('/');
        const auto i = in.parse<std::int64_t>(word.substr(0, slash), "a vertex of a face");
        corners.push_back(clamped(place_of(i, soup.points.size())));
        if (more) { more->read_corner(slash == std::string_view::npos ? std::string_view() : word.substr(slash)); }
      }
      soup.add_polygon(corners.data(), corners.size());
      if (more) { more->end_face(); }
    }
    else if (more) { more->read_line(key); }
    if (!in.at_line_end()) { in.skip_line(); }
  }
  if (soup.points.empty() && soup.number_of_polygons() == 0) { in.fail("the file has neither vertices nor faces"); }
  if (more) { more->finish(soup.points.size()); }
  return soup;
}

} // namespace files
} // namespace meridian
