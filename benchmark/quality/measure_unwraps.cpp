// What texture coordinates are like: `meridian unwrap` with several options, as whole processes.
// usage: measure_unwraps PROGRAM [S...] MESH..., where each S is an L2 stretch to ask for, besides the default, charts
// as they are needed and the shortest seams, and "thorns" stands for a torus with two of them
//
// Rows are separated by tabs, the first names the columns. Everything but counts of charts and of vertices reached is
// measured on the file that was written. Each is recounted by `meridian verify`, and overlaps of faces are counted here
// by exact signs, pair by pair; a row that does not hold ends with what is wrong, and the exit status is 1.
#include "../child_process.h"
#include "support/sample_surfaces.h"

#include <meridian/base/vectors.h>
#include <meridian/map/planar_map.h>

#include <CGAL/box_intersection_d.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace {

using namespace meridian;
namespace fs = std::filesystem;

// An OBJ file with texture coordinates, as triangles. A polygon that is written has a convex image.
struct Textured
{
  std::vector<Point> points;
  std::vector<Plane_point> texture;
  std::vector<std::array<Index, 3>> faces, texture_faces;
};

Textured read(const fs::path& path)
{
  Textured t;
  std::ifstream in(path);
  for (std::string line, word; std::getline(in, line);)
  {
    std::istringstream words(line);
    words >> word;
    if (word == "v")
    {
      Point p;
      words >> p[0] >> p[1] >> p[2];
      t.points.push_back(p);
    }
    else if (word == "vt")
    {
      Plane_point p;
      words >> p[0] >> p[1];
      t.texture.push_back(p);
    }
    else if (word == "f")
    {
      std::vector<std::array<Index, 2>> corners;
      for (std::array<Index, 2> c; words >> word && std::sscanf(word.c_str(), "%d/%d", &c[0], &c[1]) == 2;)
      {
        corners.push_back({c[0] - 1, c[1] - 1});
      }
      for (std::size_t k = 1; k + 1 < corners.size(); ++k)
      {
        const std::array<std::array<Index, 2>, 3> fan{corners[0], corners[k], corners[k + 1]};
        t.faces.push_back({fan[0][0], fan[1][0], fan[2][0]});
        t.texture_faces.push_back({fan[0][1], fan[1][1], fan[2][1]});
      }
    }
  }
  return t;
}

// Whether a side of one triangle has all of the other on its right.
bool are_parted(const std::array<Plane_point, 3>& a, const std::array<Plane_point, 3>& b)
{
  for (int k = 0; k < 3; ++k)
  {
    const auto is_right = [&](const Plane_point& p) { return orientation_of(a[k], a[(k + 1) % 3], p) <= 0; };
    if (std::all_of(b.begin(), b.end(), is_right)) { return true; }
  }
  return false;
}

// Pairs of faces whose insides meet, and faces that are not counterclockwise.
std::size_t count_overlaps(const Textured& t)
{
  using Box = CGAL::Box_intersection_d::Box_d<double, 2, CGAL::Box_intersection_d::ID_FROM_BOX_ADDRESS>;
  struct Face_box : Box
  {
    std::array<Plane_point, 3> corners;
  };
  std::vector<Face_box> boxes;
  std::size_t wrong = 0;
  for (const auto& f : t.texture_faces)
  {
    Face_box box;
    box.corners = {t.texture[f[0]], t.texture[f[1]], t.texture[f[2]]};
    for (Plane_point p : box.corners) { box.extend(p.data()); }
    wrong += orientation_of(box.corners[0], box.corners[1], box.corners[2]) <= 0;
    boxes.push_back(box);
  }
  std::vector<const Face_box*> pointers;
  for (const Face_box& b : boxes) { pointers.push_back(&b); }
  CGAL::box_self_intersection_d(pointers.begin(), pointers.end(), [&](const Face_box* a, const Face_box* b) {
    wrong += !are_parted(a->corners, b->corners) && !are_parted(b->corners, a->corners);
  });
  return wrong;
}

struct Measures
{
  double l2 = 0, dirichlet = 0, angle = 0, area = 0, filled = 0, surface = 0;
};

double corner_angle(const Point& at, const Point& to, const Point& other)
{
  return std::atan2(norm(cross(to - at, other - at)), dot(to - at, other - at));
}

// Of the whole file, at the scale at which image and surface have one area.
Measures measure(const Textured& t)
{
  double surface = 0, image = 0, stretch = 0, growth = 0, angles = 0;
  std::vector<std::array<double, 2>> areas;
  for (std::size_t f = 0; f < t.faces.size(); ++f)
  {
    std::array<Point, 3> p, q;
    for (int k = 0; k < 3; ++k)
    {
      p[k] = t.points[t.faces[f][k]];
      q[k] = {t.texture[t.texture_faces[f][k]][0], t.texture[t.texture_faces[f][k]][1], 0};
    }
    // |J|^2 of the map between two triangles, times twice the area of the first: cotangents and squares of sides
    const auto squares = [](const std::array<Point, 3>& from, const std::array<Point, 3>& to) {
      double sum = 0;
      for (int k = 0; k < 3; ++k)
      {
        const Point a = from[(k + 1) % 3] - from[k], b = from[(k + 2) % 3] - from[k],
                    side = to[(k + 1) % 3] - to[(k + 2) % 3];
        sum += dot(a, b) / norm(cross(a, b)) * dot(side, side);
      }
      return sum;
    };
    const double a = norm(cross(p[1] - p[0], p[2] - p[0])) / 2, b = norm(cross(q[1] - q[0], q[2] - q[0])) / 2;
    for (int k = 0; k < 3; ++k)
    {
      angles += std::abs(corner_angle(p[k], p[(k + 1) % 3], p[(k + 2) % 3])
                         - corner_angle(q[k], q[(k + 1) % 3], q[(k + 2) % 3]));
    }
    surface += a;
    image += b;
    areas.push_back({a, b});
    if (!(a > 0)) { continue; }
    growth += squares(p, q) / 2;
    stretch += a / b * squares(q, p) / 2; // |J^-1|^2 times the area on the surface
  }
  const double scale = image / surface;
  Measures m{std::sqrt(stretch * scale / (2 * surface)),
             (growth / scale + stretch * scale) / surface,
             angles / (3 * t.faces.size()) * 180 / std::acos(-1.),
             0,
             image,
             surface};
  for (const auto& [a, b] : areas) { m.area += std::abs(a / surface - b / image); }
  return m;
}

fs::path write_thorny_torus(const fs::path& folder)
{
  const fs::path path = folder / "thorns.off";
  const Triangle_surface s = sample::thorny_torus(8);
  std::ofstream out(path);
  out.precision(17);
  out << "OFF\n" << s.number_of_vertices() << ' ' << s.number_of_faces() << " 0\n";
  for (const Point& p : s.points) { out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n'; }
  for (const auto& t : s.triangles) { out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n'; }
  return path;
}

// Prints a row; returns whether all of it holds.
bool measure_mesh(const std::string& program, const fs::path& folder, const fs::path& mesh,
                  const std::vector<std::string>& options)
{
  const fs::path out = folder / "out.obj", report = folder / "report.json";
  std::vector<std::string> words{program, "unwrap", mesh, "-o", out, "--report", report, "--quiet"};
  words.insert(words.end(), options.begin(), options.end());
  const Child child = run_program(words);
  std::string asked;
  for (const std::string& o : options) { asked += (asked.empty() ? "" : " ") + o; }
  std::printf("%s\t%s\t", mesh.filename().c_str(), asked.empty() ? "-" : asked.c_str());
  if (child.status != 0 && child.status != 2)
  {
    std::printf("WRONG: status %d\n", child.status);
    return false;
  }
  const auto json = nlohmann::json::parse(std::ifstream(report));
  if (!json["failures"].empty())
  {
    std::printf("WRONG: %s\n", json["failures"].dump().c_str());
    return false;
  }
  const Textured textured = read(out);
  const Measures m = measure(textured);
  double length = 0, highest = 0;
  int reached = 0, charts = 0;
  for (const auto& c : json["components"])
  {
    length += c["cut"]["length"].get<double>();
    reached += c["parameterization"]["extended_to"].get<int>();
    charts += c["parameterization"]["charts"].get<int>();
    highest = std::max(highest, c["parameterization"]["stretch_l2"].get<double>());
  }
  std::printf("%zu\t%d\t%d\t%.2f\t%.4f\t%.4f\t%.3f\t%.2f\t%.3f\t%.2f\t%.2f\t%.0f\t%s", textured.faces.size(), charts,
              reached, length / std::sqrt(m.surface), m.l2, highest, m.dirichlet, m.angle, m.area, m.filled,
              child.cost.seconds, child.cost.megabytes, child.status == 0 ? "yes" : "missed");
  const std::size_t overlaps = count_overlaps(textured);
  const bool is_verified = run_program({program, "verify", mesh, out, "--quiet"}).status == 0;
  if (overlaps > 0) { std::printf("\tWRONG: %zu overlaps", overlaps); }
  if (!is_verified) { std::printf("\tWRONG: not verified"); }
  std::printf("\n");
  std::fflush(stdout);
  return overlaps == 0 && is_verified;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 3)
  {
    std::fprintf(stderr, "usage: measure_unwraps PROGRAM [S...] MESH...\n");
    return 64;
  }
  std::string folder = (fs::temp_directory_path() / "measure-unwraps-XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr) { return 1; }
  std::printf("mesh\toptions\tfaces\tcharts\treached\tseams\tL2\tworst L2\tDirichlet\tangle\tarea\tfilled\tCPU "
              "s\tMB\tverified\n");
  std::fflush(stdout);
  bool is_right = true;
  std::vector<std::vector<std::string>> choices{{}, {"--charts", "auto"}, {"--shortest-seams"}};
  for (int i = 2; i < argc; ++i)
  {
    char* end = nullptr;
    std::strtod(argv[i], &end);
    if (*end == 0)
    {
      choices.push_back({"--max-stretch", argv[i]});
      continue;
    }
    const fs::path mesh = argv[i] == std::string("thorns") ? write_thorny_torus(folder) : fs::path(argv[i]);
    for (const auto& options : choices) { is_right = measure_mesh(argv[1], folder, mesh, options) && is_right; }
  }
  fs::remove_all(folder);
  return is_right ? 0 : 1;
}
