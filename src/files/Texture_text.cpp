// SPDX-License-Identifier: GPL-3.0-or-later
#include "Texture_text.h"

#include "Scanner.h"
#include "Text.h"
#include "read_mesh.h"

#include <cmath>
#include <string_view>
#include <utility>

namespace meridian {
namespace files {

namespace {

double finite_number(Scanner& in, std::string_view word)
{
  const double x = in.parse<double>(word, "a coordinate");
  if (!std::isfinite(x)) { in.fail("a coordinate that is not a finite number"); }
  return x;
}

} // namespace

Texture_text::Texture_text(const std::string& path, std::string bytes) : m_bytes(std::move(bytes))
{
  if (m_bytes.find("\\\n") != std::string::npos || m_bytes.find("\\\r\n") != std::string::npos)
  {
    throw File_error(path + ": it has lines that go on behind a backslash, which are not packed");
  }
  Scanner in(m_bytes, path.c_str(), '#');
  while (!in.at_end())
  {
    const std::string_view key = in.word();
    if (key == "v")
    {
      Point p;
      for (double& x : p) { x = finite_number(in, in.word_on_line()); }
      m_points.push_back(p);
    }
    else if (key == "vt")
    {
      const std::string_view u = in.word_on_line();
      const std::size_t begin = u.data() - m_bytes.data();
      std::size_t end = begin + u.size();
      Plane_point p{finite_number(in, u), 0};
      if (!in.at_line_end())
      {
        const std::string_view v = in.word_on_line();
        p[1] = finite_number(in, v);
        end = v.data() - m_bytes.data() + v.size();
      }
      m_texture.push_back(p);
      m_places.push_back({begin, end});
    }
    else if (key == "f") { read_face(in); }
    if (!in.at_line_end()) { in.skip_line(); }
  }
  if (m_triangles.empty())
  {
    throw File_error(path + ": no face has texture coordinates; `meridian unwrap` makes them");
  }
}

void Texture_text::read_face(Scanner& in)
{
  std::vector<std::int32_t> corners, texture;
  bool has_all = true;
  for (std::string_view word = in.word_on_line(); !word.empty(); word = in.word_on_line())
  {
    const std::size_t slash = word.find('/');
    const std::string_view rest = slash == std::string_view::npos ? std::string_view() : word.substr(slash + 1);
    const std::string_view of_texture = rest.substr(0, rest.find('/'));
    corners.push_back(place_in(in, word.substr(0, slash), m_points.size(), "vertex"));
    if (of_texture.empty()) { has_all = false; }
    else { texture.push_back(place_in(in, of_texture, m_texture.size(), "texture vertex")); }
  }
  if (!has_all || corners.size() < 3)
  {
    ++m_faces_without;
    return;
  }
  for (std::size_t k = 2; k < corners.size(); ++k)
  {
    m_triangles.push_back({corners[0], corners[k - 1], corners[k]});
    m_texture_triangles.push_back({texture[0], texture[k - 1], texture[k]});
  }
}

std::string Texture_text::format(const std::vector<Plane_point>& texture) const
{
  std::vector<char> is_used(texture.size(), 0);
  for (const auto& t : m_texture_triangles)
    for (std::int32_t v : t) { is_used[v] = 1; }
  Text out;
  std::size_t done = 0;
  for (std::size_t i = 0; i < texture.size(); ++i)
  {
    if (!is_used[i]) { continue; }
    out << m_bytes.substr(done, m_places[i][0] - done) << texture[i][0] << ' ' << texture[i][1];
    done = m_places[i][1];
  }
  out << m_bytes.substr(done);
  return out.take();
}

} // namespace files
} // namespace meridian
