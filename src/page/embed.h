// SPDX-License-Identifier: GPL-3.0-or-later
// What pages are put together with.
#ifndef MERIDIAN_PAGE_EMBED_H
#define MERIDIAN_PAGE_EMBED_H

#include <cstddef>
#include <string>
#include <vector>

// A file that the assembler puts into the program. The names are known in one source file alone.
#define MERIDIAN_EMBED(NAME, FILE) \
  __asm__(".section .rodata\n" #NAME "_begin:\n.incbin \"" FILE "\"\n" #NAME "_end:\n.byte 0\n.previous\n"); \
  extern "C" const char NAME##_begin[], NAME##_end[];

namespace meridian {
namespace page {

// A script element.
std::string script(const char* begin, const char* end);

// The script elements of three.js, of controls to turn a view, and of wide lines, and of what our pages share.
std::string library_scripts();

// Text as it stands in HTML.
std::string escaped(const std::string& text);

// The head of every page, then its own text, with the title and the caption put in.
std::string begin_page(const std::string& body, const std::string& title, const std::string& caption);

// Puts `by` in the place of a mark, which must be there.
void replace(std::string& text, const std::string& mark, const std::string& by);

template <class Number> std::string base64(const std::vector<Number>& values)
{
  static const char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
  const std::size_t n = values.size() * sizeof(Number);
  std::string text;
  text.reserve((n + 2) / 3 * 4);
  for (std::size_t i = 0; i < n; i += 3)
  {
    const unsigned long block = static_cast<unsigned long>(bytes[i]) << 16 | (i + 1 < n ? bytes[i + 1] : 0ul) << 8
                                | (i + 2 < n ? bytes[i + 2] : 0ul);
    text += letters[block >> 18 & 63];
    text += letters[block >> 12 & 63];
    text += i + 1 < n ? letters[block >> 6 & 63] : '=';
    text += i + 2 < n ? letters[block & 63] : '=';
  }
  return text;
}

} // namespace page
} // namespace meridian

#endif // MERIDIAN_PAGE_EMBED_H
