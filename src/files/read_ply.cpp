// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh_attributes.h"
#include "Scanner.h"
#include "formats.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/vectors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace meridian {
namespace files {

namespace {

struct Type
{
  std::size_t size;
  char kind;
}; // kind: signed, unsigned or floating

Type type_of(const Scanner& in, std::string_view name)
{
  if (name == "char" || name == "int8") { return {1, 's'}; }
  if (name == "uchar" || name == "uint8") { return {1, 'u'}; }
  if (name == "short" || name == "int16") { return {2, 's'}; }
  if (name == "ushort" || name == "uint16") { return {2, 'u'}; }
  if (name == "int" || name == "int32") { return {4, 's'}; }
  if (name == "uint" || name == "uint32") { return {4, 'u'}; }
  if (name == "float" || name == "float32") { return {4, 'f'}; }
  if (name == "double" || name == "float64") { return {8, 'f'}; }
  in.fail("unknown type '" + std::string(name) + "'");
}

struct Property
{
  std::string name;
  Type type{0, 's'}, count{0, 'u'};
  bool is_list = false;
};
struct Element
{
  std::string name;
  std::int64_t count = 0;
  std::vector<Property> properties;
};

// The values of the body, as text or as numbers of fixed size.
class Body
{
public:
  Body(Scanner& in, std::string_view encoding)
    : m_in(in), m_at(in.position()), m_is_text(encoding == "ascii"), m_is_swapped(encoding == "binary_big_endian")
  {}

  double value(Type type)
  {
    if (m_is_text) { return m_in.real("a value"); }
    if (static_cast<std::size_t>(m_in.end() - m_at) < type.size) { throw File_error("PLY: the file ends too early"); }
    unsigned char raw[8];
    for (std::size_t i = 0; i < type.size; ++i)
    {
      raw[m_is_swapped ? type.size - 1 - i : i] = static_cast<unsigned char>(m_at[i]);
    }
    m_at += type.size;
    switch (type.kind)
    {
    case 'f': return type.size == 4 ? static_cast<double>(as<float>(raw)) : as<double>(raw);
    case 's':
      return type.size == 1 ? as<std::int8_t>(raw) : type.size == 2 ? as<std::int16_t>(raw) : as<std::int32_t>(raw);
    default:
      return type.size == 1 ? as<std::uint8_t>(raw) : type.size == 2 ? as<std::uint16_t>(raw) : as<std::uint32_t>(raw);
    }
  }
  std::int32_t index(Type type)
  {
    const double x = value(type);
    return x >= 0 && x <= 2147483646. && std::floor(x) == x ? static_cast<std::int32_t>(x) : x == -1 ? -1 : -2;
  }
  std::size_t left() const { return static_cast<std::size_t>(m_in.end() - (m_is_text ? m_in.position() : m_at)); }

private:
  template <class Number> static Number as(const unsigned char* raw)
  {
    Number x;
    std::memcpy(&x, raw, sizeof x);
    return x;
  }
  Scanner& m_in;
  const char* m_at;
  bool m_is_text, m_is_swapped;
};

struct Header
{
  std::string encoding;
  std::vector<Element> elements;
};

// What follows the word "element".
Element read_element(Scanner& head)
{
  Element element;
  element.name = head.word();
  element.count = head.integer("the number of elements");
  if (element.count < 0 || element.count > 500000000) { head.fail("an impossible number of elements"); }
  return element;
}

// What follows the word "property".
Property read_property(Scanner& head)
{
  Property p;
  std::string_view type = head.word();
  if (type == "list")
  {
    p.is_list = true;
    p.count = type_of(head, head.word());
    type = head.word();
  }
  p.type = type_of(head, type);
  p.name = head.word();
  return p;
}

// Reads the header, without the line that ends it.
Header read_header(std::string_view text)
{
  Scanner head(text, "PLY");
  Header header;
  head.skip_line();
  while (!head.at_end())
  {
    const std::string_view key = head.word();
    if (key == "format") { header.encoding = head.word(); }
    else if (key == "element") { header.elements.push_back(read_element(head)); }
    else if (key == "property")
    {
      if (header.elements.empty()) { head.fail("a property before the first element"); }
      header.elements.back().properties.push_back(read_property(head));
    }
    head.skip_line();
  }
  if (header.encoding != "ascii" && header.encoding != "binary_little_endian" && header.encoding != "binary_big_endian")
    throw File_error("PLY: unknown encoding '" + header.encoding + "'");
  return header;
}

// Adds the triangles of strips: -1 ends a strip.
void add_strips(Polygon_soup& soup, const std::vector<std::int32_t>& list)
{
  for (auto first = list.begin(); first != list.end();)
  {
    const auto end = std::find(first, list.end(), -1);
    add_strip(soup, first, end);
    first = end == list.end() ? end : end + 1;
  }
}

// Reads the elements of one kind and adds vertices and faces to a soup.
class Element_reader
{
public:
  explicit Element_reader(const Element& element)
    : m_element(element), m_is_vertex(element.name == "vertex"), m_is_face(element.name == "face"),
      m_is_strip(element.name == "tristrips")
  {
    find_properties();
    if (m_is_vertex && !m_has[0]) { throw File_error("PLY: the vertices have no x, y and z"); }
    if (has_faces() && m_corners < 0)
    {
      throw File_error("PLY: the element '" + element.name + "' has no list 'vertex_indices'");
    }
  }

  bool has_faces() const { return m_is_face || m_is_strip; }

  void read(Body& body, Polygon_soup& soup, Mesh_attributes* attributes)
  {
    for (std::int64_t i = 0; i < m_element.count && !m_element.properties.empty(); ++i)
    {
      std::array<Point, 3> of_vertex{}; // as `m_has`
      for (std::size_t k = 0; k < m_element.properties.size(); ++k)
      {
        if (m_element.properties[k].is_list) { read_list(body, i, k, soup); }
        else { read_number(body, k, of_vertex); }
      }
      if (!m_is_vertex) { continue; }
      soup.points.push_back(of_vertex[0]);
      if (attributes && m_has[1]) { attributes->normals.push_back(of_vertex[1]); }
      if (attributes && m_has[2]) { attributes->colours.push_back(of_vertex[2]); }
    }
  }

private:
  // Which properties are the coordinates, normals, colours and the corners.
  void find_properties()
  {
    const std::array<std::string, 9> names{"x", "y", "z", "nx", "ny", "nz", "red", "green", "blue"};
    std::array<int, 3> found{0, 0, 0}; // a bit for each
    m_place.assign(m_element.properties.size(), -1);
    for (std::size_t k = 0; k < m_element.properties.size(); ++k)
    {
      const Property& p = m_element.properties[k];
      const auto place = static_cast<int>(std::find(names.begin(), names.end(), p.name) - names.begin());
      if (!p.is_list && place < 9)
      {
        m_place[k] = place;
        found[place / 3] |= 1 << place % 3;
      }
      if (p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index")) { m_corners = static_cast<int>(k); }
    }
    for (std::size_t i = 0; i < 3; ++i) { m_has[i] = found[i] == 7; }
  }

  // Reads property `k`, a number, into the place that it has in `of_vertex`. Colours in whole numbers end at 1.
  void read_number(Body& body, std::size_t k, std::array<Point, 3>& of_vertex) const
  {
    const Type type = m_element.properties[k].type;
    const double x = body.value(type);
    if (m_place[k] < 0) { return; }
    const int i = m_place[k] / 3;
    of_vertex[i][m_place[k] % 3] =
      i < 2 || type.kind == 'f' ? x : x / (std::ldexp(1., 8 * static_cast<int>(type.size)) - 1);
  }

  // Reads property `k` of element `i`, a list, and adds faces if it names their corners.
  void read_list(Body& body, std::int64_t i, std::size_t k, Polygon_soup& soup)
  {
    const Property& p = m_element.properties[k];
    const double n = body.value(p.count);
    if (!(n >= 0) || n > static_cast<double>(body.left()))
    {
      throw File_error("PLY: element " + std::to_string(i) + " of '" + m_element.name
                       + "' has a list of impossible length");
    }
    m_list.clear();
    for (std::int64_t j = 0; j < static_cast<std::int64_t>(n); ++j) { m_list.push_back(body.index(p.type)); }
    if (static_cast<int>(k) != m_corners) { return; }
    if (m_is_face) { soup.add_polygon(m_list.data(), m_list.size()); }
    if (m_is_strip) { add_strips(soup, m_list); }
  }

  const Element& m_element;
  bool m_is_vertex, m_is_face, m_is_strip;
  std::vector<int> m_place;    // of each property: a coordinate, 3 + one of a normal, 6 + one of a colour, or -1
  std::array<bool, 3> m_has{}; // coordinates, normals, colours
  int m_corners = -1;
  std::vector<std::int32_t> m_list;
};

} // namespace

Polygon_soup read_ply(const std::string& bytes, Mesh_attributes* attributes)
{
  const std::size_t header_end = bytes.find("end_header");
  if (bytes.compare(0, 3, "ply") != 0 || header_end == std::string::npos)
  {
    throw File_error("PLY: the file has no PLY header");
  }
  const std::size_t body_begin = bytes.find('\n', header_end);
  if (body_begin == std::string::npos) { throw File_error("PLY: the file ends with its header"); }
  const Header header = read_header(std::string_view(bytes).substr(0, header_end));
  Scanner in(std::string_view(bytes).substr(body_begin + 1), "PLY, after the header");
  Body body(in, header.encoding);
  Polygon_soup soup;
  bool has_faces = false;
  for (const Element& element : header.elements)
  {
    Element_reader reader(element);
    has_faces |= reader.has_faces();
    reader.read(body, soup, attributes);
  }
  if (attributes && !attributes->normals.empty()) { attributes->normal_of = soup.corners; }
  if (!has_faces && !soup.points.empty()) { throw File_error("PLY: the file has points and no faces"); }
  return soup;
}

} // namespace files
} // namespace meridian
