// SPDX-License-Identifier: GPL-3.0-or-later
// Values, lists and dictionaries one after the other, as text or in binary.
#ifndef MERIDIAN_MAP_WRITERS_H
#define MERIDIAN_MAP_WRITERS_H

#include "Text.h"

#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>

namespace meridian {
namespace files {

// JSON (RFC 8259), with a line for each entry of the outermost dictionary.
class Json_writer
{
public:
  void reserve(std::size_t values) { m_text.reserve(9 * values); }
  void begin_dictionary(std::size_t) { open('{'); }
  void end_dictionary() { close('}'); }
  void begin_list(std::size_t) { open('['); }
  void end_list() { close(']'); }
  void key(const char* name)
  {
    if (!m_is_first) { m_text << (m_depth == 1 ? ",\n" : ", "); }
    m_text << '"' << name << "\": ";
    m_is_first = true; // no comma before its value
  }
  void write(const std::string& s)
  {
    separate();
    m_text << '"' << s << '"';
  }
  template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number>>> void write(Number x)
  {
    separate();
    m_text << x;
  }
  std::string take()
  {
    m_text << '\n';
    return m_text.take();
  }

private:
  void separate()
  {
    if (!m_is_first) { m_text << ','; }
    m_is_first = false;
  }
  void open(char bracket)
  {
    separate();
    m_text << bracket;
    if (m_depth++ == 0) { m_text << '\n'; }
    m_is_first = true;
  }
  void close(char bracket)
  {
    if (--m_depth == 0) { m_text << '\n'; }
    m_text << bracket;
    m_is_first = false;
  }

  Text m_text;
  int m_depth = 0;
  bool m_is_first = true;
};

// CBOR (RFC 8949).
class Cbor_writer
{
public:
  void reserve(std::size_t values) { m_bytes.reserve(5 * values); }
  void begin_dictionary(std::size_t size) { head(5, size); }
  void end_dictionary() {}
  void begin_list(std::size_t size) { head(4, size); }
  void end_list() {}
  void key(const char* name) { write(std::string(name)); }
  void write(const std::string& s)
  {
    head(3, s.size());
    m_bytes += s;
  }
  void write(std::int32_t x)
  {
    if (x < 0) { head(1, static_cast<std::uint64_t>(-1 - std::int64_t(x))); }
    else { head(0, static_cast<std::uint64_t>(x)); }
  }
  void write(double x)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    append(0xfb, bits, 8);
  }
  std::string take() { return std::move(m_bytes); }

private:
  // What follows, and how long it is or its value.
  void head(unsigned kind, std::uint64_t number)
  {
    const unsigned first = kind << 5;
    if (number < 24) { m_bytes += static_cast<char>(first | number); }
    else if (number < 1u << 8) { append(first | 24, number, 1); }
    else if (number < 1u << 16) { append(first | 25, number, 2); }
    else if (number < std::uint64_t(1) << 32) { append(first | 26, number, 4); }
    else { append(first | 27, number, 8); }
  }
  void append(unsigned first, std::uint64_t number, int bytes)
  {
    char buffer[9] = {static_cast<char>(first)};
    for (int i = bytes; i > 0; --i, number >>= 8) { buffer[i] = static_cast<char>(number & 255); }
    m_bytes.append(buffer, 1 + static_cast<std::size_t>(bytes));
  }

  std::string m_bytes;
};

} // namespace files
} // namespace meridian

#endif // MERIDIAN_MAP_WRITERS_H
