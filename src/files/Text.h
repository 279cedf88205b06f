// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FILES_TEXT_H
#define MERIDIAN_FILES_TEXT_H

#include <charconv>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>

namespace meridian {
namespace files {

// Text that is put together. Numbers have the shortest digits that read back to the same number.
class Text
{
public:
  // Makes room, so that long texts are not moved while they grow.
  void reserve(std::size_t characters) { m_text.reserve(characters); }
  Text& operator<<(const char* s)
  {
    m_text += s;
    return *this;
  }
  Text& operator<<(const std::string& s)
  {
    m_text += s;
    return *this;
  }
  Text& operator<<(char c)
  {
    m_text += c;
    return *this;
  }
  template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number>>> Text& operator<<(Number x)
  {
    char digits[40];
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, x);
    static_cast<void>(error); // 40 characters hold every number
    m_text.append(digits, end);
    return *this;
  }
  std::string take() { return std::move(m_text); }

private:
  std::string m_text;
};

} // namespace files
} // namespace meridian

#endif // MERIDIAN_FILES_TEXT_H
