#include "support/unwrapped_samples.h"

#include "files/png.h"

#include <meridian/base/exceptions.h>

#include <zlib.h>

using namespace meridian;
using namespace unwrapped;

namespace {

// A folder to read images from.
struct Image_folder : Folder
{
  files::Image read(const std::string& bytes) const { return files::read_png(write("a.png", bytes)); }
  std::string refusal(const std::string& bytes) const
  {
    return message_of([&] { read(bytes); });
  }
};

// A PNG file put together from its definition.
std::string made_png(unsigned width, unsigned height, char bits, char color, const std::string& rows,
                     bool has_palette = false)
{
  const auto word = [](unsigned long x) {
    return std::string{static_cast<char>(x >> 24), static_cast<char>(x >> 16), static_cast<char>(x >> 8),
                       static_cast<char>(x)};
  };
  const auto chunk = [&](const std::string& body) {
    return word(body.size() - 4) + body
           + word(crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size())));
  };
  uLongf n = compressBound(rows.size());
  std::string packed(n, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &n, reinterpret_cast<const Bytef*>(rows.data()), rows.size());
  packed.resize(n);
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR" + word(width) + word(height) + bits + color + std::string(3, '\0'))
         + (has_palette ? chunk("PLTE" + std::string(6, '\x7f')) : "") + chunk("IDAT" + packed) + chunk("IEND");
}

} // namespace

// Known answer: samples of 16 bits have their high byte first, rows go down, red comes first.
BOOST_FIXTURE_TEST_CASE(images_have_the_samples_that_the_format_says, Image_folder)
{
  const files::Image grey = read(made_png(2, 2, 16, 0, std::string("\0\x12\x34\0\1\0\xff\xfe\0\0", 10)));
  BOOST_TEST((grey.width == 2 && grey.height == 2 && grey.channels == 1 && grey.bits == 16));
  BOOST_TEST((grey.samples == std::vector<std::uint16_t>{0x1234, 1, 0xfffe, 0}));
  const files::Image red = read(made_png(1, 2, 8, 2, std::string("\0\xff\0\7\0\1\2\3", 8)));
  BOOST_TEST((red.width == 1 && red.height == 2 && red.channels == 3 && red.bits == 8));
  BOOST_TEST((red.samples == std::vector<std::uint16_t>{255, 0, 7, 1, 2, 3}));
}

BOOST_FIXTURE_TEST_CASE(an_image_is_read_back_as_it_was, Image_folder)
{
  std::mt19937 random(11);
  for (const int channels : {1, 3})
    for (const int bits : {8, 16})
      for (const auto& [width, height] : {std::pair(1, 1), {7, 5}, {3, 200}, {300, 2}})
      {
        std::vector<std::uint16_t> samples(static_cast<std::size_t>(width * height * channels));
        for (auto& x : samples) { x = static_cast<std::uint16_t>(random() >> (32 - bits)); }
        const std::string bytes = files::format_png(width, height, channels, samples, bits);
        const files::Image image = read(bytes);
        BOOST_TEST(
          (image.width == width && image.height == height && image.channels == channels && image.bits == bits));
        BOOST_TEST((image.samples == samples));
        BOOST_TEST(files::format_png(width, height, channels, samples, bits) == bytes);
        BOOST_TEST(!contains(bytes, "tIME"));
      }
}

BOOST_FIXTURE_TEST_CASE(files_that_are_no_plain_images_are_refused, Image_folder)
{
  const std::string good = files::format_png(40, 30, 1, std::vector<std::uint16_t>(1200, 77), 16);
  for (std::size_t n : {std::size_t(8), std::size_t(20), good.size() / 2, good.size() - 1})
    BOOST_TEST(contains(refusal(good.substr(0, n)), "a.png: a damaged PNG file: the file ends too early"), n);
  BOOST_TEST(contains(refusal(""), "a.png: not a PNG file"));
  BOOST_TEST(contains(refusal("GIF89a, or some text"), "a.png: not a PNG file"));
  std::string damaged = good;
  damaged[good.find("IDAT") + 6] ^= 1;
  BOOST_TEST(contains(refusal(damaged), "a damaged PNG file: "));
  BOOST_TEST(contains(refusal(made_png(2, 1, 8, 3, std::string(3, '\0'), true)), "the image has a palette"));
  BOOST_TEST(contains(refusal(made_png(1, 1, 8, 6, std::string(5, '\0'))), "the image has an alpha channel"));
  BOOST_TEST(contains(refusal(made_png(1, 1, 16, 4, std::string(5, '\0'))), "the image has an alpha channel"));
  BOOST_TEST(contains(refusal(made_png(2, 1, 4, 0, std::string(2, '\0'))), "the image has 4 bits a sample"));
  BOOST_TEST(contains(refusal(made_png(1, 2, 8, 0, std::string(2, '\0'))), "a damaged PNG file: "));
  BOOST_TEST(
    contains(refusal(made_png(900000, 900000, 8, 0, std::string(2, '\0'))), "900000 x 900000 pixels; at most"));
  BOOST_TEST(contains(refusal(made_png(0, 1, 8, 0, std::string(2, '\0'))), "a damaged PNG file: "));
  BOOST_CHECK_THROW(files::format_png(2, 2, 1, {1, 2, 3}, 8), Internal_error);
  BOOST_CHECK_THROW(files::format_png(1, 1, 1, {256}, 8), Internal_error);
  BOOST_CHECK_THROW(files::format_png(1, 1, 2, {1, 2}, 8), Internal_error);
}

// Known answer: squares alternate; the lower left one is dark, red grows to the right and blue upwards.
BOOST_FIXTURE_TEST_CASE(a_checkerboard_shows_where_it_is, Image_folder)
{
  const files::Image image = read(files::format_checkerboard(64, 64, 8));
  const auto at = [&](int i, int j, int channel) {
    return image.samples[static_cast<std::size_t>(((63 - 8 * j - 4) * 64 + 8 * i + 4) * 3 + channel)];
  };
  BOOST_TEST((image.width == 64 && image.height == 64 && image.channels == 3 && image.bits == 8));
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) { BOOST_TEST((at(i, j, 1) < 128) == ((i + j) % 2 == 0)); }
  BOOST_TEST(at(0, 0, 0) < at(6, 0, 0));
  BOOST_TEST(at(0, 0, 2) < at(0, 6, 2));
  BOOST_TEST(at(0, 0, 2) == at(6, 0, 2));
}
