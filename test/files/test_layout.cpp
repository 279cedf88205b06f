#include "support/pipeline.h"
#include "support/unwrapped_samples.h"

#include "files/chart_borders.h"
#include "files/write_layout.h"

#include <meridian/base/Result_mesh.h>
#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

#include <regex>

using namespace meridian;
using namespace unwrapped;

namespace {

std::vector<double> even(const Result_mesh& m, double value = 1) { return std::vector<double>(m.faces.size(), value); }

// The numbers that a layout shows.
struct Number
{
  double x, y;
  std::string color;
  int number;
};
std::vector<Number> numbers(const std::string& svg)
{
  const std::size_t at = svg.find("<g class=\"numbers\"");
  const std::string part = svg.substr(at, svg.find("</g>", at) - at);
  static const std::regex form(
    "<text x=\"([-.0-9]+)\" y=\"([-.0-9]+)\" font-size=\"[.0-9]+\" fill=\"(#[0-9a-f]+)\">([0-9]+)</text>");
  std::vector<Number> found;
  for (std::sregex_iterator i(part.begin(), part.end(), form), end; i != end; ++i)
    found.push_back({std::stod((*i)[1]), std::stod((*i)[2]), (*i)[3], std::stoi((*i)[4])});
  BOOST_TEST(found.size() == count(part, "<text"));
  return found;
}

// How many seam paths a layout shows; each must be numbered twice, in one colour, from 1 on.
int numbered_paths(const std::string& svg)
{
  std::map<int, std::vector<std::string>> colors;
  for (const Number& n : numbers(svg)) { colors[n.number].push_back(n.color); }
  int expected = 1;
  for (const auto& [number, list] : colors)
  {
    BOOST_TEST(number == expected++);
    BOOST_TEST(list.size() == 2u);
    BOOST_TEST(list.front() == list.back());
  }
  BOOST_TEST(count(svg, "class=\"seam\"") == 2 * colors.size());
  return static_cast<int>(colors.size());
}

} // namespace

// Known answers: two halves meet in a circle; three slices of a ball in three lines; the faces of an octahedron in
// twelve edges.
BOOST_AUTO_TEST_CASE(paths_between_charts_are_as_long_as_can_be)
{
  const Triangle_surface octahedron = sample::sphere(0), ball = sample::sphere(3);
  const auto paths_of = [](const Result_mesh& m) {
    return numbered_paths(files::format_layout(m, random_texture(m, 1), even(m)));
  };
  BOOST_TEST(paths_of(opened_into_charts(octahedron, [](Index f) { return f / 4; })) == 1);
  BOOST_TEST(paths_of(opened_into_charts(octahedron, [](Index f) { return f; })) == 12);
  const auto slice = [&](Index f) {
    const auto& t = ball.triangles[f];
    const Point p = ball.points[t[0]] + ball.points[t[1]] + ball.points[t[2]];
    return p[0] > 0 && p[1] > 0 ? 0 : p[1] > 0 ? 1 : 2; // they meet along circles through the poles
  };
  BOOST_TEST(paths_of(opened_into_charts(ball, slice)) == 3);
  const Torus torus = opened_torus(6, 8);
  BOOST_TEST(numbered_paths(files::format_layout(torus.mesh, torus.texture, even(torus.mesh))) == 2);
}

// Theorem: seam paths run between the vertices where other than two sectors meet, or on the border of the surface.
// Every seam side is on one of them, opposite to its mate.
BOOST_AUTO_TEST_CASE(every_seam_path_is_numbered_once_on_each_side)
{
  std::vector<Triangle_surface> surfaces{sample::sphere(2),
                                         sample::plate(1),
                                         sample::plate(3),
                                         sample::torus(12, 9),
                                         sample::punctured(sample::sphere(3), {0, 1, 100}),
                                         sample::punctured(sample::torus(16, 12), {5, 100})};
  for (const Triangle_surface& s : surfaces)
  {
    const Result_mesh m = pipeline::run(sample::soup(s)).assembled.mesh;
    std::vector<int> degree(m.points.size());
    std::set<Index> on_border;
    std::map<std::pair<Index, Index>, Index> side;
    std::vector<Index> mate(3 * m.faces.size(), -1);
    const auto source = [&](Index h) { return m.faces[h / 3][h % 3]; };
    const auto target = [&](Index h) { return m.faces[h / 3][(h + 1) % 3]; };
    for (const auto& [a, b] : m.seams)
    {
      mate[a] = b;
      mate[b] = a;
      ++degree[base(m, source(a))];
      ++degree[base(m, target(a))];
    }
    for (Index h = 0; h < static_cast<Index>(mate.size()); ++h) { side[{source(h), target(h)}] = h; }
    std::size_t borders = 0;
    for (const auto& [ends, h] : side)
      if (mate[h] < 0 && !side.count({ends.second, ends.first}))
      {
        ++borders;
        for (Index v : {ends.first, ends.second}) { on_border.insert(base(m, v)); }
      }
    int ends = 0;
    for (Index v = 0; v < static_cast<Index>(degree.size()); ++v)
    {
      ends += degree[v] != 2 || on_border.count(v) ? degree[v] : 0;
    }
    std::size_t sides = 0;
    int paths = 0;
    for (const auto& path : files::find_chart_borders(m))
    {
      (path.mates.empty() ? borders : sides) -= path.sides.size();
      paths += !path.mates.empty();
      for (std::size_t i = 0; i < path.sides.size(); ++i)
      {
        if (i > 0) { BOOST_TEST(target(path.sides[i - 1]) == source(path.sides[i])); }
        if (path.mates.empty()) { BOOST_TEST(mate[path.sides[i]] == -1); }
        else { BOOST_TEST(mate[path.sides[i]] == path.mates[path.sides.size() - 1 - i]); }
        if (i > 0 && !path.mates.empty()) { BOOST_TEST(target(path.mates[i - 1]) == source(path.mates[i])); }
      }
    }
    BOOST_TEST(sides + m.seams.size() == 0u);
    BOOST_TEST(borders == 0u);
    BOOST_TEST(paths == ends / 2);
    const Texture texture = random_texture(m, 3);
    const std::string svg = files::format_layout(m, texture, even(m));
    BOOST_TEST(numbered_paths(svg) == ends / 2);
    BOOST_TEST(files::format_layout(m, texture, even(m)) == svg);
  }
}

// Known answer: the torus is a square, whose opposite sides have one number each at the middle, inside.
BOOST_AUTO_TEST_CASE(numbers_stand_inside_at_the_middle_of_their_path)
{
  const Torus torus = opened_torus(8, 8);
  std::map<int, std::vector<Number>> found;
  for (const Number& n : numbers(files::format_layout(torus.mesh, torus.texture, even(torus.mesh))))
  {
    found[n.number].push_back(n);
  }
  BOOST_REQUIRE(found.size() == 2u);
  for (auto& [number, pair] : found)
  {
    BOOST_REQUIRE(pair.size() == 2u);
    const bool is_across = std::abs(pair[0].x - 500) < 5; // one above and one below
    for (const Number& n : pair) { BOOST_TEST(std::abs((is_across ? n.x : n.y) - 500) < 5); }
    const double a = is_across ? pair[0].y : pair[0].x, b = is_across ? pair[1].y : pair[1].x;
    BOOST_TEST((std::min(a, b) > 2 && std::min(a, b) < 20 && std::max(a, b) < 998 && std::max(a, b) > 980));
  }
}

// Known answer: two decimals, downwards, and nothing that could be left out.
BOOST_AUTO_TEST_CASE(places_are_written_as_short_as_they_can_be)
{
  Result_mesh m;
  m.points.assign(3, {0, 0, 0});
  m.copy_of.assign(3, -1);
  m.faces = {{0, 1, 2}};
  const std::string svg = files::format_layout(m, {{0, 0}, {0.12345, 0}, {0.12335, 0.001}}, {1});
  BOOST_TEST(contains(svg, "\"#eeeeea\" d=\"M0 1000l123.45 0-.1-1z\"/>"));
  BOOST_TEST(contains(svg, "<path class=\"border\" d=\"M0 1000l123.45 0-.1-1-123.35 1\"/>"));
  BOOST_TEST(numbers(svg).empty());
}

// Known answer: 1 is grey; 4 and all above are one red, 1/4 and all below are one blue; each colour is one element.
BOOST_AUTO_TEST_CASE(faces_are_coloured_by_the_logarithm_of_their_distortion)
{
  const Torus torus = opened_torus(4, 5);
  const auto color = [&](double distortion) {
    const std::string svg = files::format_layout(torus.mesh, torus.texture, even(torus.mesh, distortion));
    const std::size_t at = svg.find("<path fill=\"");
    BOOST_TEST(count(svg, "<path fill=\"") == 1u);
    BOOST_TEST(count(svg.substr(at, svg.find("/>", at) - at), "M") == 40u);
    return svg.substr(at + 12, 7);
  };
  const double infinite = std::numeric_limits<double>::infinity();
  BOOST_TEST(color(1) == "#eeeeea");
  BOOST_TEST(color(4) == "#c81e28");
  BOOST_TEST(color(1e9) == color(4));
  BOOST_TEST(color(infinite) == color(4));
  BOOST_TEST(color(0.25) == "#1e4bbe");
  BOOST_TEST(color(0) == color(0.25));
  std::set<std::string> colors;
  for (int i = -12; i <= 12; ++i) { colors.insert(color(std::pow(4, i / 12.))); }
  BOOST_TEST(colors.size() == 25u);
}
