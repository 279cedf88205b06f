// SPDX-License-Identifier: GPL-3.0-or-later
#include "Scanner.h"
#include "formats.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/place_crossings.h>
#include <meridian/field/Sparse_solver.h>

#include <cmath>

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

} // namespace

Polygon_soup read_ply(const std::string& bytes)
{
  const std::size_t header = bytes.find("end_header");
  if (bytes.compare(0, 3, "ply") != 0 || header == std::string::npos)
  {
    throw File_error("PLY: the file has no PLY header");
  }
  const std::size_t body_begin = bytes.find('\n', header);
  if (body_begin == std::string::npos) { throw File_error("PLY: the file ends with its header"); }

  Scanner head(std::string_view(bytes).substr(0, header), "PLY");
  std::string encoding;
  std::vector<Element> elements;
  head.skip_line();
  while (!head.at_end())
  {
    const std::string_view key = head.word();
    if (key == "format") { encoding = head.word(); }
    else if (key == "element")
    {
      elements.emplace_back();
      elements.back().name = head.word();
      elements.back().count = head.integer("the number of elements");
      if (elements.back().count < 0 || elements.back().count > 500000000)
      {
        head.fail("an impossible number of elements");
      }
    }
    else if (key == "property")
    {
      if (elements.empty()) { head.fail("a property before the first element"); }
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
      elements.back().properties.push_back(p);
    }
    head.skip_line();
  }
  if (encoding != "ascii" && encoding != "binary_little_endian" && encoding != "binary_big_endian")
    throw File_error("PLY: unknown encoding '" + encoding + "'");

  Scanner in(std::string_view(bytes).substr(body_begin + 1), "PLY, after the header");
  Body body(in, encoding);
  Polygon_soup soup;
  std::vector<std::int32_t> list;
  bool has_faces = false;
  for (const Element& element : elements)
  {
    const bool is_vertex = element.name == "vertex", is_face = element.name == "face",
               is_strip = element.name == "tristrips";
    std::array<int, 3> axis{-1, -1, -1};
    int corners = -1;
    for (std::size_t i = 0; i < element.properties.size(); ++i)
    {
      const Property& p = element.properties[i];
      for (int k = 0; k < 3; ++k)
      {
        if (p.name == std::string(1, "xyz"[k]) && !p.is_list) { axis[k] = static_cast<int>(i); }
      }
      if (p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index")) { corners = static_cast<int>(i); }
    }
    if (is_vertex && (axis[0] < 0 || axis[1] < 0 || axis[2] < 0))
    {
      throw File_error("PLY: the vertices have no x, y and z");
    }
    if ((is_face || is_strip) && corners < 0)
    {
      throw File_error("PLY: the element '" + element.name + "' has no list 'vertex_indices'");
    }
    has_faces |= is_face || is_strip;
    for (std::int64_t i = 0; i < element.count && !element.properties.empty(); ++i)
    {
      Point point{0, 0, 0};
      for (std::size_t k = 0; k < element.properties.size(); ++k)
      {
        const Property& p = element.properties[k];
        if (!p.is_list)
        {
          const double x = body.value(p.type);
          for (int a = 0; a < 3; ++a)
          {
            if (axis[a] == static_cast<int>(k)) { point[a] = x; }
          }
          continue;
        }
        const double n = body.value(p.count);
        if (!(n >= 0) || n > static_cast<double>(body.left()))
        {
          throw File_error("PLY: element " + std::to_string(i) + " of '" + element.name
                           + "' has a list of impossible length");
        }
        list.clear();
        for (std::int64_t j = 0; j < static_cast<std::int64_t>(n); ++j) { list.push_back(body.index(p.type)); }
        if (static_cast<int>(k) != corners) { continue; }
        if (is_face) { soup.add_polygon(list.data(), list.size()); }
        if (is_strip) // -1 ends a strip; every other triangle is turned
          for (std::size_t j = 0, first = 0; j < list.size(); ++j)
          {
            if (list[j] == -1)
            {
              first = j + 1;
              continue;
            }
            if (j < first + 2) { continue; }
            const bool odd = (j - first) % 2 == 1;
            const std::array<std::int32_t, 3> t{list[j - 2], list[odd ? j : j - 1], list[odd ? j - 1 : j]};
            soup.add_polygon(t.data(), 3);
          }
      }
      if (is_vertex) { soup.points.push_back(point); }
    }
  }
  if (!has_faces && !soup.points.empty()) { throw File_error("PLY: the file has points and no faces"); }
  return soup;
}

} // namespace files
} // namespace meridian
