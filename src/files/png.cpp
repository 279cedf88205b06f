// SPDX-License-Identifier: GPL-3.0-or-later
#include "png.h"

#include "read_mesh.h"

#include <meridian/base/exceptions.h>

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>

namespace meridian {
namespace files {

namespace {

// What a run of libpng shares with its callbacks. Errors leave libpng by longjmp, so that every object with a
// destructor is made outside of the functions that call setjmp, and no callback leaves while it holds one.
struct State
{
  std::string* out = nullptr;
  const char* at = nullptr;
  std::size_t left = 0;
  char message[200] = "";
};

[[noreturn]] void on_error(png_structp png, png_const_charp message)
{
  State& state = *static_cast<State*>(png_get_error_ptr(png));
  std::strncpy(state.message, message, sizeof state.message - 1);
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void write_bytes(png_structp png, png_bytep bytes, std::size_t n)
{
  bool is_written = false;
  try
  {
    static_cast<State*>(png_get_io_ptr(png))->out->append(reinterpret_cast<const char*>(bytes), n);
    is_written = true;
  }
  catch (const std::bad_alloc&)
  {}
  if (!is_written) { png_error(png, "out of memory"); }
}

void flush(png_structp) {}

void take_bytes(png_structp png, png_bytep bytes, std::size_t n)
{
  State& state = *static_cast<State*>(png_get_io_ptr(png));
  if (n > state.left) { png_error(png, "the file ends too early"); }
  std::memcpy(bytes, state.at, n);
  state.at += n;
  state.left -= n;
}

// What libpng keeps for a file that is written or read.
struct Png_file
{
  State state;
  png_structp png;
  png_infop info;
  explicit Png_file(decltype(png_create_read_struct)& create)
    : png(create(PNG_LIBPNG_VER_STRING, &state, on_error, on_warning)),
      info(png ? png_create_info_struct(png) : nullptr)
  {}
  Png_file(const Png_file&) = delete;
  Png_file& operator=(const Png_file&) = delete;
};

struct Writer : Png_file
{
  Writer() : Png_file(png_create_write_struct) {}
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

struct Reader : Png_file
{
  Reader() : Png_file(png_create_read_struct) {}
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

bool write_image(png_structp png, png_infop info, int width, int height, int channels, int bits, png_bytepp rows)
{
  if (setjmp(png_jmpbuf(png))) { return false; }
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), bits,
               channels == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_compression_level(png, 6);
  png_write_info(png, info);
  png_write_image(png, rows);
  png_write_end(png, nullptr);
  return true;
}

bool read_head(png_structp png, png_infop info)
{
  if (setjmp(png_jmpbuf(png))) { return false; }
  png_read_info(png, info);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  return true;
}

bool read_image(png_structp png, png_bytepp rows)
{
  if (setjmp(png_jmpbuf(png))) { return false; }
  png_read_image(png, rows);
  png_read_end(png, nullptr);
  return true;
}

std::vector<png_bytep> rows_of(std::vector<unsigned char>& bytes, std::size_t height)
{
  std::vector<png_bytep> rows(height);
  for (std::size_t y = 0; y < height; ++y) { rows[y] = bytes.data() + y * (bytes.size() / height); }
  return rows;
}

} // namespace

std::string format_png(int width, int height, int channels, const std::vector<std::uint16_t>& samples, int bits)
{
  if (width < 1 || height < 1 || (channels != 1 && channels != 3) || (bits != 8 && bits != 16)
      || samples.size()
           != static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(channels))
    throw Internal_error("format_png: the sizes of an image do not fit together");
  if (bits == 8 && std::any_of(samples.begin(), samples.end(), [](std::uint16_t x) { return x > 255; }))
    throw Internal_error("format_png: a sample needs more than 8 bits");
  std::vector<unsigned char> bytes;
  bytes.reserve(samples.size() * static_cast<std::size_t>(bits / 8));
  for (std::uint16_t x : samples)
  {
    if (bits == 16) { bytes.push_back(static_cast<unsigned char>(x >> 8)); }
    bytes.push_back(static_cast<unsigned char>(x & 255));
  }
  std::vector<png_bytep> rows = rows_of(bytes, static_cast<std::size_t>(height));
  std::string out;
  Writer w;
  w.state.out = &out;
  if (!w.info) { throw File_error("an image cannot be written: out of memory"); }
  png_set_write_fn(w.png, &w.state, write_bytes, flush);
  if (!write_image(w.png, w.info, width, height, channels, bits, rows.data()))
    throw File_error("an image of " + std::to_string(width) + " x " + std::to_string(height)
                     + " pixels cannot be written: " + w.state.message);
  return out;
}

Image read_png(const std::string& path)
{
  const std::string bytes = read_bytes(path);
  const auto fail = [&](const std::string& why) { throw File_error(path + ": " + why); };
  static const unsigned char signature[] = {137, 'P', 'N', 'G', 13, 10, 26, 10};
  if (bytes.size() < sizeof signature || std::memcmp(bytes.data(), signature, sizeof signature) != 0)
  {
    fail("not a PNG file");
  }
  Reader r;
  r.state.at = bytes.data();
  r.state.left = bytes.size();
  if (!r.info) { fail("out of memory"); }
  png_set_read_fn(r.png, &r.state, take_bytes);
  const auto fail_to_decode = [&] { fail(std::string("a damaged PNG file: ") + r.state.message); };
  if (!read_head(r.png, r.info)) { fail_to_decode(); }

  Image image;
  const std::size_t width = png_get_image_width(r.png, r.info), height = png_get_image_height(r.png, r.info);
  image.bits = png_get_bit_depth(r.png, r.info);
  const int color = png_get_color_type(r.png, r.info);
  if (color & PNG_COLOR_MASK_PALETTE) { fail("the image has a palette; grey or red, green and blue are read"); }
  if (color & PNG_COLOR_MASK_ALPHA) { fail("the image has an alpha channel; grey or red, green and blue are read"); }
  if (image.bits != 8 && image.bits != 16)
  {
    fail("the image has " + std::to_string(image.bits) + " bits a sample; 8 or 16 are read");
  }
  image.channels = color & PNG_COLOR_MASK_COLOR ? 3 : 1;
  if (width * height > 200000000)
  {
    fail("the image has " + std::to_string(width) + " x " + std::to_string(height)
         + " pixels; at most 200 million are read");
  }
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  const std::size_t n = width * height * static_cast<std::size_t>(image.channels),
                    size = static_cast<std::size_t>(image.bits / 8);
  std::vector<unsigned char> content(n * size);
  std::vector<png_bytep> rows = rows_of(content, height);
  if (!read_image(r.png, rows.data())) { fail_to_decode(); }
  image.samples.resize(n);
  for (std::size_t i = 0; i < n; ++i)
    image.samples[i] = static_cast<std::uint16_t>(size == 1 ? content[i] : content[2 * i] << 8 | content[2 * i + 1]);
  return image;
}

std::string format_checkerboard(int width, int height, int square)
{
  std::vector<std::uint16_t> samples;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
    {
      const int i = x / square, j = (height - 1 - y) / square;
      const int right = 120 * x / width, up = 120 * (height - 1 - y) / height;
      const bool is_dark = (i + j) % 2 == 0;
      samples.push_back(static_cast<std::uint16_t>(is_dark ? 60 + right : 230));
      samples.push_back(static_cast<std::uint16_t>(is_dark ? 80 : 230));
      samples.push_back(static_cast<std::uint16_t>(is_dark ? 60 + up : 230));
    }
  return format_png(width, height, 3, samples, 8);
}

} // namespace files
} // namespace meridian
