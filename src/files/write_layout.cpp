// SPDX-License-Identifier: GPL-3.0-or-later
#include "write_layout.h"

#include "Text.h"
#include "chart_borders.h"

#include <meridian/base/Result_mesh.h>
#include <meridian/base/vectors.h>
#include <meridian/unwrap/square_border.h>

#include <algorithm>
#include <cmath>

namespace meridian {
namespace files {

namespace {

using Place = std::array<std::int64_t, 2>; // in hundredths of a unit of the picture, downwards
constexpr std::int64_t unit = 100, side = 1000 * unit;
constexpr int shades = 25; // an odd number, so that one of them is for 1

// The shade of a distortion: 0 for 1/4 and less, the last for 4 and more.
std::size_t shade_of(double distortion)
{
  if (std::isnan(distortion)) { return shades - 1; }
  const double level = distortion > 0 ? std::min(std::max(std::log(distortion) / std::log(4.), -1.), 1.) : -1;
  return static_cast<std::size_t>(std::lround((level + 1) / 2 * (shades - 1)));
}

std::string color_of(std::size_t shade)
{
  static const int middle[3] = {238, 238, 234}, red[3] = {200, 30, 40}, blue[3] = {30, 75, 190};
  constexpr int half = (shades - 1) / 2;
  const int step = static_cast<int>(shade) - half, *end = step > 0 ? red : blue;
  std::string text = "#";
  for (int i = 0; i < 3; ++i)
  {
    const int c = middle[i] + (end[i] - middle[i]) * std::abs(step) / half;
    text += "0123456789abcdef"[c / 16];
    text += "0123456789abcdef"[c % 16];
  }
  return text;
}

// The data of a path element, in the fewest letters: moves are absolute, lines relative.
class Path_data
{
public:
  void move_to(const Place& p) { append('M', p); }
  void line_to(const Place& p)
  {
    append('l', {p[0] - m_last[0], p[1] - m_last[1]});
    m_last = p;
  }
  void close()
  {
    m_text << 'z';
    m_command = 'z';
  }
  std::string take() { return m_text.take(); }

private:
  void append(char command, const Place& p)
  {
    const bool is_new = command != m_command;
    if (is_new) { m_text << command; }
    for (int i = 0; i < 2; ++i)
    {
      if ((i > 0 || !is_new) && p[i] >= 0) { m_text << ' '; }
      append(p[i]);
    }
    m_command = command;
    if (command == 'M') { m_last = p; }
  }
  void append(std::int64_t x)
  {
    if (x < 0) { m_text << '-'; }
    x = std::abs(x);
    if (x >= unit || x == 0) { m_text << x / unit; }
    if (x % unit == 0) { return; }
    m_text << '.' << x % unit / 10;
    if (x % 10 != 0) { m_text << x % 10; }
  }

  Text m_text;
  Place m_last{0, 0};
  char m_command = 0;
};

class Layout
{
public:
  Layout(const Result_mesh& mesh, const std::vector<Plane_point>& texture) : m_mesh(mesh)
  {
    for (const auto& t : texture) { m_at.push_back({std::llround(t[0] * side), std::llround((1 - t[1]) * side)}); }
    m_out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-20 -20 1040 1090\" width=\"1040\" height=\"1090\" "
             "font-family=\"sans-serif\">\n"
             "<style>.numbers text { stroke-width: .2em; }</style>\n"
             "<rect x=\"-20\" y=\"-20\" width=\"1040\" height=\"1090\" fill=\"#fff\"/>\n<rect width=\"1000\" "
             "height=\"1000\" fill=\"none\" stroke=\"#ccc\"/>\n";
  }

  void draw_faces(const std::vector<double>& distortion)
  {
    std::vector<Path_data> paths(shades);
    std::vector<char> is_used(shades, 0);
    for (std::size_t f = 0; f < m_mesh.faces.size(); ++f)
    {
      const std::size_t shade = shade_of(distortion[f]);
      is_used[shade] = 1;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Place& p = m_at[m_mesh.faces[f][k]];
        if (k == 0) { paths[shade].move_to(p); }
        else { paths[shade].line_to(p); }
      }
      paths[shade].close();
    }
    m_out << "<g class=\"faces\" stroke-width=\".4\" stroke-linejoin=\"round\">\n";
    for (std::size_t i = 0; i < shades; ++i)
      if (is_used[i])
      {
        m_out << "<path fill=\"" << color_of(i) << "\" stroke=\"" << color_of(i) << "\" d=\"" << paths[i].take()
              << "\"/>\n";
      }
    m_out << "</g>\n";
  }

  void draw_borders()
  {
    static const char* const colors[] = {"#1f5fb4", "#c4510a", "#1c7c2c", "#a3171f", "#6b3fa0",
                                         "#6d4336", "#b0308a", "#4d4d4d", "#7d7f10", "#0f8a96"};
    const std::vector<Border_path> paths = find_chart_borders(m_mesh);
    m_out
      << "<g fill=\"none\" stroke=\"#222\" stroke-width=\"1.2\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
    std::string numbers;
    int number = 0;
    for (const Border_path& path : paths)
    {
      if (path.mates.empty())
      {
        draw_line(path.sides, "border", "");
        continue;
      }
      const char* color = colors[static_cast<std::size_t>(number++) % (sizeof colors / sizeof *colors)];
      for (const auto* sides : {&path.sides, &path.mates})
      {
        draw_line(*sides, "seam", color);
        numbers += format_number(*sides, number, color);
      }
    }
    m_out << "</g>\n<g class=\"numbers\" text-anchor=\"middle\" stroke=\"#fff\" paint-order=\"stroke\">\n"
          << numbers << "</g>\n";
  }

  void draw_legend()
  {
    m_out << "<g class=\"legend\" font-size=\"14\" text-anchor=\"middle\" fill=\"#222\">\n";
    for (std::size_t i = 0; i < shades; ++i)
      m_out << "<rect x=\"" << 250 + 20 * i << "\" y=\"1012\" width=\"20\" height=\"14\" fill=\"" << color_of(i)
            << "\"/>\n";
    static const char* const marks[] = {"1/4", "1/2", "1", "2", "4"};
    for (int i = 0; i < 5; ++i)
    {
      m_out << "<text x=\"" << 260 + 120 * i << "\" y=\"1042\">" << marks[i] << "</text>\n";
    }
    m_out
      << "<text x=\"500\" y=\"1062\">distortion of faces; equal numbers mark the two sides of a seam</text>\n</g>\n";
  }

  std::string take()
  {
    m_out << "</svg>\n";
    return m_out.take();
  }

private:
  const Place& source(std::int32_t h) const { return m_at[m_mesh.faces[h / 3][h % 3]]; }
  const Place& target(std::int32_t h) const { return m_at[m_mesh.faces[h / 3][(h + 1) % 3]]; }

  void draw_line(const std::vector<std::int32_t>& sides, const char* kind, const char* color)
  {
    Path_data data;
    data.move_to(source(sides.front()));
    for (std::int32_t h : sides) { data.line_to(target(h)); }
    m_out << "<path class=\"" << kind << '"';
    if (*color) { m_out << " stroke=\"" << color << '"'; }
    m_out << " d=\"" << data.take() << "\"/>\n";
  }

  // The number at the middle of a path, a little to the left of it, which is inside the chart.
  std::string format_number(const std::vector<std::int32_t>& sides, int number, const char* color) const
  {
    const auto length = [&](std::int32_t h) {
      return std::hypot(static_cast<double>(target(h)[0] - source(h)[0]),
                        static_cast<double>(target(h)[1] - source(h)[1]));
    };
    double whole = 0, along = 0;
    for (std::int32_t h : sides) { whole += length(h); }
    std::size_t i = 0;
    while (i + 1 < sides.size() && along + length(sides[i]) < whole / 2) { along += length(sides[i++]); }
    const Place &a = source(sides[i]), &b = target(sides[i]);
    const double x = static_cast<double>(b[0] - a[0]), y = static_cast<double>(b[1] - a[1]), l = length(sides[i]);
    // of letters
    const double part = l > 0 ? std::min((whole / 2 - along) / l, 1.) : 0,
                 size = std::min(std::max(whole / 4 / unit, 4.), 11.);
    const double inward = l > 0 ? 0.8 * size * unit / l : 0;
    const auto units = [&](double v) { return static_cast<double>(std::llround(v / unit * 10)) / 10; };
    Text text;
    text << "<text x=\"" << units(static_cast<double>(a[0]) + part * x + inward * y) << "\" y=\""
         << units(static_cast<double>(a[1]) + part * y - inward * x + 0.35 * size * unit) << "\" font-size=\""
         << units(size * unit) << "\" fill=\"" << color << "\">" << number << "</text>\n";
    return text.take();
  }

  const Result_mesh& m_mesh;
  std::vector<Place> m_at;
  Text m_out;
};

} // namespace

std::string format_layout(const Result_mesh& mesh, const std::vector<Plane_point>& texture,
                          const std::vector<double>& distortion)
{
  Layout layout(mesh, texture);
  layout.draw_faces(distortion);
  layout.draw_borders();
  layout.draw_legend();
  return layout.take();
}

} // namespace files
} // namespace meridian
