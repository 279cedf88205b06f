// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FILES_PNG_H
#define MERIDIAN_FILES_PNG_H

#include <cstdint>
#include <string>
#include <vector>

namespace meridian {
namespace files {

// Rows from top to bottom, the channels of a pixel side by side: 1 is grey, 3 are red, green and blue.
struct Image
{
  int width = 0, height = 0, channels = 0, bits = 0; // bits of a sample: 8 or 16
  std::vector<std::uint16_t> samples;
};

// The bytes of a PNG file. The same image gives the same bytes. Throws Internal_error if sizes do not fit together or a
// sample needs more bits.
std::string format_png(int width, int height, int channels, const std::vector<std::uint16_t>& samples, int bits);

// Reads a PNG file of grey or red, green and blue, with 8 or 16 bits a sample. Throws File_error on any other.
Image read_png(const std::string& path);

// A PNG of squares with so many pixels along a side. The dark ones grow red to the right and blue upwards.
std::string format_checkerboard(int width, int height, int square);

} // namespace files
} // namespace meridian

#endif // MERIDIAN_FILES_PNG_H
