// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FILES_SCANNER_H
#define MERIDIAN_FILES_SCANNER_H

#include "read_mesh.h"

#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace meridian {
namespace files {

// Reads words and numbers from text, and says where it was when something is wrong.
class Scanner
{
public:
  Scanner(std::string_view text, const char* what, char comment = '\0')
    : m_begin(text.data()), m_at(text.data()), m_end(text.data() + text.size()), m_what(what), m_comment(comment)
  {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF"; // of UTF-8, which some editors begin a text with
    if (text.substr(0, byte_order_mark.size()) == byte_order_mark) { m_at += byte_order_mark.size(); }
  }

  [[noreturn]] void fail(const std::string& message) const
  {
    std::size_t line = 1;
    for (const char* p = m_begin; p < m_at && p < m_end; ++p) { line += *p == '\n'; }
    throw File_error(std::string(m_what) + ", line " + std::to_string(line) + ": " + message);
  }
  bool at_end()
  {
    skip_space(true);
    return m_at == m_end;
  }
  // Whether nothing but a comment is left on this line.
  bool at_line_end()
  {
    skip_space(false);
    return m_at == m_end || *m_at == '\n';
  }
  void skip_line()
  {
    const void* p = std::memchr(m_at, '\n', static_cast<std::size_t>(m_end - m_at));
    m_at = p ? static_cast<const char*>(p) + 1 : m_end;
  }
  // The next word of this line; empty at its end.
  std::string_view word_on_line()
  {
    skip_space(false);
    const char* first = m_at;
    while (m_at < m_end && !is_space(*m_at)) { ++m_at; }
    return {first, static_cast<std::size_t>(m_at - first)};
  }
  std::string_view word()
  {
    skip_space(true);
    if (m_at == m_end) { fail("the file ends too early"); }
    return word_on_line();
  }
  double real(const char* name) { return number<double>(name); }
  std::int64_t integer(const char* name) { return number<std::int64_t>(name); }
  const char* position() const { return m_at; }
  const char* end() const { return m_end; }

  template <class Number> Number parse(std::string_view text, const char* name) const
  {
    Number value{};
    const char *first = text.data(), *last = first + text.size();
    if (first < last && *first == '+') { ++first; }
    const auto [p, error] = std::from_chars(first, last, value);
    if (error == std::errc::result_out_of_range && std::is_floating_point_v<Number>)
      return static_cast<Number>(std::strtod(std::string(text).c_str(), nullptr)); // zero, or infinite
    if (error != std::errc() || p != last)
    {
      fail("expected " + std::string(name) + ", found '" + std::string(text.substr(0, 40)) + "'");
    }
    return value;
  }

private:
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v'; }
  template <class Number> Number number(const char* name)
  {
    skip_space(true);
    if (m_at == m_end) { fail("the file ends where " + std::string(name) + " should be"); }
    return parse<Number>(word_on_line(), name);
  }
  void skip_space(bool lines)
  {
    while (m_at < m_end)
    {
      if (m_comment != '\0' && *m_at == m_comment)
      {
        while (m_at < m_end && *m_at != '\n') { ++m_at; }
        continue;
      }
      if (!is_space(*m_at) || (*m_at == '\n' && !lines)) { return; }
      ++m_at;
    }
  }

  const char *m_begin, *m_at, *m_end;
  const char* m_what;
  char m_comment;
};

// An index that does not fit is kept out of range, so that examination counts and names the face.
inline std::int32_t clamped(std::int64_t i) { return i < 0 || i > 2147483646 ? -1 : static_cast<std::int32_t>(i); }

// The place of an index as OBJ files have it, from 1 on or counted back from -1, among so many; outside of them if it
// is none: 0 is no index.
inline std::int64_t place_of(std::int64_t i, std::size_t count)
{
  return i < 0 ? static_cast<std::int64_t>(count) + i : i - 1;
}

// The same of a word; fails if it is none.
inline std::int32_t place_in(const Scanner& in, std::string_view word, std::size_t count, const char* name)
{
  const auto i = in.parse<std::int64_t>(word, name);
  const std::int64_t place = place_of(i, count);
  if (place < 0 || place >= static_cast<std::int64_t>(count))
  {
    in.fail("a corner names " + std::string(name) + " " + std::to_string(i) + ", and " + std::to_string(count)
            + " stand above it");
  }
  return static_cast<std::int32_t>(place);
}

// The next word, a vertex of so many, counted from 0; fails if it is none.
inline std::int32_t vertex_in(Scanner& in, std::size_t vertices)
{
  const std::int64_t v = in.integer("a vertex");
  if (v < 0 || v >= static_cast<std::int64_t>(vertices))
  {
    in.fail("vertex " + std::to_string(v) + " is none of the mesh, which has " + std::to_string(vertices)
            + ", counted from 0");
  }
  return static_cast<std::int32_t>(v);
}

} // namespace files
} // namespace meridian

#endif // MERIDIAN_FILES_SCANNER_H
