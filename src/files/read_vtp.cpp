// SPDX-License-Identifier: GPL-3.0-or-later
#include "Scanner.h"
#include "formats.h"

#include <meridian/base/Polygon_soup.h>

#include <pugixml.hpp>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meridian {
namespace files {

namespace {

std::string decode_base64(std::string_view text)
{
  static const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned buffer = 0;
  int bits = 0;
  for (const char c : text)
  {
    if (c == '=') { break; }
    const std::size_t value = letters.find(c);
    if (value == std::string::npos) { throw File_error("VTP: bad base64 data"); }
    buffer = buffer << 6 | static_cast<unsigned>(value);
    bits += 6;
    if (bits >= 8)
    {
      bits -= 8;
      bytes.push_back(static_cast<char>(buffer >> bits & 0xff));
    }
  }
  return bytes;
}

// The arrays of a file: text, or base64 or raw bytes, in place or appended, plain or in zlib blocks.
class Arrays
{
public:
  Arrays(const pugi::xml_node& root, std::string_view appended, bool appended_is_raw, std::size_t size,
         std::size_t most)
    : m_stored_left(size), m_left(most), m_appended(appended), m_appended_is_raw(appended_is_raw),
      m_header_size(std::string_view(root.attribute("header_type").value()) == "UInt64" ? 8 : 4),
      m_is_packed(*root.attribute("compressor").value() != '\0')
  {
    if (std::string_view(root.attribute("byte_order").value()) == "BigEndian")
    {
      throw File_error("VTP: big-endian data is not supported");
    }
    if (m_is_packed && std::string_view(root.attribute("compressor").value()) != "vtkZLibDataCompressor")
      throw File_error("VTP: the compressor '" + std::string(root.attribute("compressor").value())
                       + "' is not supported; write with zlib or none");
  }

  std::vector<double> read(const pugi::xml_node& node)
  {
    const std::string_view format = node.attribute("format").value(), type = node.attribute("type").value();
    std::vector<double> values;
    if (format == "ascii")
    {
      Scanner in(node.child_value(), "VTP");
      while (!in.at_end()) { values.push_back(in.real("a value")); }
      return values;
    }
    std::string bytes;
    if (format == "appended")
    {
      const std::size_t offset = static_cast<std::size_t>(node.attribute("offset").as_ullong());
      if (offset > m_appended.size()) { throw File_error("VTP: an array lies past the end of the file"); }
      bytes = m_appended_is_raw ? unpack(m_appended.substr(offset)) : unpack_base64(m_appended.substr(offset));
    }
    else { bytes = unpack_base64(node.child_value()); }
    convert(bytes, type, values);
    return values;
  }

private:
  std::uint64_t header(std::string_view bytes, std::size_t i) const
  {
    if (bytes.size() < (i + 1) * m_header_size) { throw File_error("VTP: the file ends too early"); }
    std::uint64_t x = 0;
    std::memcpy(&x, bytes.data() + i * m_header_size, m_header_size);
    return x;
  }
  // The bytes that so many letters stand for.
  static std::string decode(std::string_view text, std::size_t bytes)
  {
    const std::size_t letters = (bytes + 2) / 3 * 4;
    if (letters > text.size()) { throw File_error("VTP: the file ends too early"); }
    return decode_base64(text.substr(0, letters));
  }
  // Takes so many bytes of what the arrays of a file may have: as they stand there, each is read once, and packed
  // blocks do not make many of few.
  void take(std::uint64_t stored, std::uint64_t size)
  {
    if (stored > m_stored_left) { throw File_error("VTP: several arrays lie in the same bytes"); }
    if (size > m_left)
      throw File_error(
        "VTP: its arrays are more than 100 times the size of the file; if it is a mesh, write it without "
        "compression");
    m_stored_left -= stored;
    m_left -= size;
  }
  std::string unpack_base64(std::string_view text)
  {
    text.remove_prefix(std::min(text.find_first_not_of(" \n\r\t"), text.size()));
    text = text.substr(0, text.find_first_of(" \n\r\t<"));
    const std::uint64_t first = header(decode(text, m_header_size), 0); // the size, or how many blocks there are
    if (first > text.size()) { throw File_error("VTP: the file ends too early"); }
    const auto count = static_cast<std::size_t>(first);
    if (!m_is_packed) { return unpack(decode(text, m_header_size + count)); }
    // The header of packed data is encoded by itself.
    const std::size_t header_bytes = m_header_size * (3 + count);
    const std::string sizes = decode(text, header_bytes);
    std::uint64_t packed = 0;
    for (std::size_t b = 0; b < count; ++b) { packed += std::min<std::uint64_t>(header(sizes, 3 + b), text.size()); }
    if (packed > text.size()) { throw File_error("VTP: the file ends too early"); }
    return unpack(sizes + decode(text.substr((header_bytes + 2) / 3 * 4), static_cast<std::size_t>(packed)));
  }
  std::string unpack(std::string_view bytes)
  {
    if (!m_is_packed)
    {
      const std::uint64_t size = header(bytes, 0);
      if (size > bytes.size() - m_header_size) { throw File_error("VTP: the file ends too early"); }
      take(size, size);
      return std::string(bytes.substr(m_header_size, static_cast<std::size_t>(size)));
    }
    const std::uint64_t blocks = header(bytes, 0), block_size = header(bytes, 1), last_size = header(bytes, 2);
    if (block_size > (1u << 30) || last_size > block_size) { throw File_error("VTP: a block of impossible size"); }
    if (blocks > bytes.size() / m_header_size) { throw File_error("VTP: the file ends too early"); }
    take(0, blocks == 0 ? 0 : (blocks - 1) * block_size + (last_size == 0 ? block_size : last_size));
    std::string result;
    std::size_t at = m_header_size * (3 + static_cast<std::size_t>(blocks));
    for (std::uint64_t b = 0; b < blocks; ++b)
    {
      const std::size_t packed = static_cast<std::size_t>(header(bytes, 3 + static_cast<std::size_t>(b)));
      uLongf size = static_cast<uLongf>(b + 1 == blocks && last_size != 0 ? last_size : block_size);
      if (at > bytes.size() || packed > bytes.size() - at) { throw File_error("VTP: the file ends too early"); }
      take(packed, 0);
      const std::size_t old = result.size();
      result.resize(old + size);
      if (uncompress(reinterpret_cast<Bytef*>(&result[old]), &size, reinterpret_cast<const Bytef*>(bytes.data() + at),
                     packed)
          != Z_OK)
        throw File_error("VTP: packed data is damaged");
      result.resize(old + size);
      at += packed;
    }
    return result;
  }
  template <class Number> static void convert_as(const std::string& bytes, std::vector<double>& values)
  {
    values.resize(bytes.size() / sizeof(Number));
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      Number x;
      std::memcpy(&x, bytes.data() + i * sizeof x, sizeof x);
      values[i] = static_cast<double>(x);
    }
  }
  static void convert(const std::string& bytes, std::string_view type, std::vector<double>& values)
  {
    if (type == "Float32") { convert_as<float>(bytes, values); }
    else if (type == "Float64") { convert_as<double>(bytes, values); }
    else if (type == "Int32") { convert_as<std::int32_t>(bytes, values); }
    else if (type == "UInt32") { convert_as<std::uint32_t>(bytes, values); }
    else if (type == "Int64") { convert_as<std::int64_t>(bytes, values); }
    else if (type == "UInt64") { convert_as<std::uint64_t>(bytes, values); }
    else { throw File_error("VTP: an array of type '" + std::string(type) + "' is not supported"); }
  }

  std::uint64_t m_stored_left, m_left; // how many bytes more the arrays may have, as they stand there and unpacked
  std::string_view m_appended;
  bool m_appended_is_raw;
  std::size_t m_header_size;
  bool m_is_packed;
};

// A document whose appended raw bytes, which are not XML, are taken out of it.
struct Document
{
  std::string xml;
  std::string_view appended; // lies in the file's bytes
  bool is_raw = false;
};

Document split_document(const std::string& bytes)
{
  Document d;
  d.xml = bytes;
  const std::size_t tag = bytes.find("<AppendedData");
  if (tag == std::string::npos) { return d; }
  const std::size_t close = bytes.find('>', tag), mark = bytes.find('_', close);
  if (mark == std::string::npos) { throw File_error("VTP: the appended data has no beginning"); }
  d.is_raw = bytes.substr(tag, close - tag).find("raw") != std::string::npos;
  d.appended = std::string_view(bytes).substr(mark + 1);
  d.xml = bytes.substr(0, tag) + "</VTKFile>";
  return d;
}

// Parses a text in its place, which must stay.
pugi::xml_node parse(pugi::xml_document& xml, std::string& text)
{
  const pugi::xml_parse_result parsed = xml.load_buffer_inplace(text.data(), text.size());
  if (!parsed)
  {
    throw File_error("VTP: " + std::string(parsed.description()) + " at byte " + std::to_string(parsed.offset));
  }
  const pugi::xml_node root = xml.child("VTKFile");
  if (std::string_view(root.attribute("type").value()) != "PolyData")
  {
    throw File_error("VTP: the file holds no PolyData");
  }
  return root;
}

// Adds the points of a piece to a soup, and then its cells.
class Piece_reader
{
public:
  Piece_reader(const pugi::xml_node& piece, Arrays& arrays, Polygon_soup& soup)
    : m_piece(piece), m_arrays(arrays), m_soup(soup), m_base(static_cast<std::int32_t>(soup.points.size()))
  {}

  void read()
  {
    add_points();
    for (const char* kind : {"Polys", "Strips"}) { add_cells(kind); }
  }

private:
  void add_points()
  {
    const std::vector<double> xyz = m_arrays.read(m_piece.child("Points").child("DataArray"));
    if (xyz.size() % 3 != 0 || xyz.size() / 3 != m_piece.attribute("NumberOfPoints").as_ullong())
    {
      throw File_error("VTP: the number of coordinates does not match the number of points");
    }
    for (std::size_t i = 0; i < xyz.size(); i += 3) { m_soup.points.push_back({xyz[i], xyz[i + 1], xyz[i + 2]}); }
  }

  void add_cells(const char* kind)
  {
    const auto count = m_piece.attribute((std::string("NumberOf") + kind).c_str()).as_ullong();
    const pugi::xml_node cells = m_piece.child(kind);
    if (!cells || count == 0) { return; }
    std::vector<double> corners, ends;
    for (const pugi::xml_node array : cells.children("DataArray"))
    {
      if (std::string_view(array.attribute("Name").value()) == "connectivity") { corners = m_arrays.read(array); }
      if (std::string_view(array.attribute("Name").value()) == "offsets") { ends = m_arrays.read(array); }
    }
    if (ends.size() != count) { throw File_error("VTP: the number of cells does not match their offsets"); }
    std::size_t at = 0;
    for (double end : ends)
    {
      if (!(end >= static_cast<double>(at)) || end > static_cast<double>(corners.size()))
      {
        throw File_error("VTP: the cells' offsets do not match their corners");
      }
      m_polygon.clear();
      for (; static_cast<double>(at) < end; ++at) { m_polygon.push_back(vertex(corners[at])); }
      if (kind[0] == 'S') { add_strip(m_soup, m_polygon.begin(), m_polygon.end()); }
      else { m_soup.add_polygon(m_polygon.data(), m_polygon.size()); }
    }
  }

  // The vertex of the soup that a corner names; -1 if it is out of range.
  std::int32_t vertex(double corner) const
  {
    const std::int32_t i = corner >= 0 && corner <= 2147483646. ? static_cast<std::int32_t>(corner) : -1;
    return i < 0 || i > 2147483646 - m_base ? -1 : i + m_base;
  }

  pugi::xml_node m_piece;
  Arrays& m_arrays;
  Polygon_soup& m_soup;
  std::int32_t m_base; // the first of the piece's points
  std::vector<std::int32_t> m_polygon;
};

} // namespace

Polygon_soup read_vtp(const std::string& bytes, std::size_t size_on_disk)
{
  Document document = split_document(bytes);
  pugi::xml_document xml;
  const pugi::xml_node root = parse(xml, document.xml);
  Arrays arrays(root, document.appended, document.is_raw, bytes.size(), most_unpacked(size_on_disk));
  Polygon_soup soup;
  for (const pugi::xml_node piece : root.child("PolyData").children("Piece"))
  {
    Piece_reader(piece, arrays, soup).read();
  }
  return soup;
}

} // namespace files
} // namespace meridian
