// Measures cut graphs: what each method gives, and how far that moves when the surface changes. Every answer is
// recounted before its row is printed. Rows are separated by tabs, the first names the columns, "-" stands for what was
// not measured.
#include "files/read_mesh.h"
#include "support/implicit_surfaces.h"

#include <meridian/base/Progress_observer.h>
#include <meridian/base/Verification.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/cut/cut_to_disc.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/examine_surface.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/seam_paths.h>
#include <meridian/unwrap/cut_family.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>

using namespace meridian;

namespace {

constexpr double degrees = 180 / sample::pi;
using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

double mean_edge(const Triangle_surface& s)
{
  double sum = 0;
  for (Index h = 0; h < s.number_of_halfedges(); ++h) { sum += s.length(h); }
  return sum / s.number_of_halfedges();
}

double median(std::vector<double> v)
{
  std::sort(v.begin(), v.end());
  return v.empty() ? 0 : (v[(v.size() - 1) / 2] + v[v.size() / 2]) / 2;
}

// Ends a run after some time.
struct Time_limit : Progress_observer
{
  explicit Time_limit(double s) : seconds(s) {}
  bool go_further() override { return seconds_since(begin) < seconds; }
  double seconds;
  Clock::time_point begin = Clock::now();
};

struct Mesh
{
  std::string name;
  Triangle_surface surface;
  int genus, boundary_loops;
};

Mesh make_mesh(std::string name, Triangle_surface s)
{
  const int loops = static_cast<int>(boundary_loops(s).size());
  const int characteristic = s.number_of_vertices() - s.number_of_edges() + s.number_of_faces();
  return {std::move(name), std::move(s), (2 - characteristic - loops) / 2, loops};
}

// The component of a file that has the most faces.
Mesh read_largest_component(const char* path)
{
  Examination e = examine_surface(files::read_mesh(path), true);
  const auto fewer = [](const auto& a, const auto& b) {
    return a.surface.number_of_faces() < b.surface.number_of_faces();
  };
  const char* slash = std::strrchr(path, '/');
  return make_mesh(slash ? slash + 1 : path,
                   std::move(std::max_element(e.components.begin(), e.components.end(), fewer)->surface));
}

// A cut graph as a shape in space.
struct Shape
{
  double length = 0; // over the square root of the area
  // in degrees: the mean, over the inner vertices of all paths, of the angle between one segment and the next
  double turning = 0;
  double turning_per_size = 0; // in degrees: the sum of these angles, over the length
  // in degrees: the mean of how much the path turns within the surface: half the difference of the angles beside it
  double bend = 0;
};

double bend_at(const Refined_surface& s, Index before, Index v, Index after)
{
  double left = 0, around = 0;
  s.for_each_outgoing(v, [&](Index h) { around += corner_angle(s, h); });
  for (Index h = s.find_halfedge(v, after); s.target(h) != before; h = s.turn_left(h)) { left += corner_angle(s, h); }
  return std::abs(left - around / 2);
}

Shape measure_shape(const Triangle_surface& root, const Cut& cut)
{
  Shape shape;
  shape.length = cut.length / std::sqrt(area(root));
  double sum = 0, bends = 0;
  int angles = 0;
  const auto& p = cut.surface.points;
  for (const auto& path : seam_paths(cut.surface))
    for (std::size_t i = 1; i + 1 < path.size(); ++i, ++angles)
    {
      const Point in = p[path[i]] - p[path[i - 1]], out = p[path[i + 1]] - p[path[i]];
      sum += std::atan2(norm(cross(in, out)), dot(in, out));
      bends += bend_at(cut.surface, path[i - 1], path[i], path[i + 1]);
    }
  shape.turning = angles > 0 ? degrees * sum / angles : 0;
  shape.bend = angles > 0 ? degrees * bends / angles : 0;
  shape.turning_per_size = shape.length > 0 ? degrees * sum / shape.length : 0;
  return shape;
}

// One way to cut a surface.
struct Way
{
  Cut_method method;
  Tightening tightening;
  bool on_edges = false;
  int bases = 16;
  Cut_options options() const
  {
    Cut_options o;
    o.method = method;
    if (auto* tree_cotree = std::get_if<By_tree_cotree>(&o.method)) { tree_cotree->bases = bases; }
    o.tightening = tightening;
    o.on_edges = on_edges;
    return o;
  }
  std::string name() const // two columns
  {
    return name_of(method) + (bases == 1 ? ", one base\t" : "\t") + name_of(tightening)
           + (on_edges ? ", on edges" : "");
  }
};

struct Attempt
{
  std::optional<Cut> cut;
  double seconds = 0;  // the median of three if it takes less than one
  std::string verdict; // "yes", or why there is no cut
  bool is_wrong = false, is_late = false;
};

Attempt attempt(const Triangle_surface& s, const Way& way, double limit, int runs)
{
  Attempt a;
  try
  {
    std::vector<double> seconds;
    for (int i = 0; i < runs && (i == 0 || seconds.front() < 1); ++i)
    {
      Time_limit time_limit(limit);
      Cut_options options = way.options();
      options.observer = &time_limit;
      a.cut = cut_to_disc(s, options);
      seconds.push_back(seconds_since(time_limit.begin));
    }
    a.seconds = median(seconds);
    const Verification recount = verify_cut(s, *a.cut);
    a.verdict = recount ? "yes" : "WRONG: " + recount.failures.front();
  }
  catch (const Cancelled&)
  {
    a.is_late = true, a.verdict = "took more than " + std::to_string(static_cast<int>(limit)) + " s";
  }
  catch (const Invalid_input_error& e)
  {
    a.verdict = std::string("refused: ") + e.what();
  }
  catch (const Solver_error& e)
  {
    a.verdict = std::string("not solved: ") + e.what();
  }
  catch (const Internal_error& e)
  {
    a.verdict = std::string("WRONG: ") + e.what();
  }
  a.is_wrong = a.verdict.rfind("WRONG", 0) == 0;
  if (a.verdict != "yes") { a.cut.reset(); }
  return a;
}

void print_mesh(const Mesh& m)
{
  std::printf("%s\t%d\t%d\t%d", m.name.c_str(), m.surface.number_of_faces(), m.genus, m.boundary_loops);
}

const Way all_ways[] = {
  {By_contours(), Tightening::NONE},        {By_contours(), Tightening::CURVES},
  {By_contours(), Tightening::GRAPH},       {By_contours(), Tightening::CURVES, true},
  {By_contours(), Tightening::GRAPH, true}, {By_generators(), Tightening::NONE},
  {By_generators(), Tightening::CURVES},    {By_generators(), Tightening::GRAPH},
  {By_flow_lines(), Tightening::NONE},      {By_flow_lines(), Tightening::GRAPH}, // flow lines stay as they are
  {By_distance(), Tightening::NONE},        {By_distance(), Tightening::CURVES},
  {By_distance(), Tightening::GRAPH},       {By_tree_cotree(), Tightening::NONE},
  {By_tree_cotree(), Tightening::GRAPH}, // there are no meridians
  {By_removing_faces(), Tightening::NONE},  {By_removing_faces(), Tightening::GRAPH},
};

int measure_methods(const std::vector<Mesh>& meshes, double limit)
{
  std::printf("mesh\tfaces\tgenus\tloops\tmethod\ttightening\tseconds\tlength\tturning\tturning_per_size\tbend\tnew_"
              "vertices\tsmallest_angle\tverified\n");
  int wrong = 0;
  for (const Mesh& mesh : meshes)
  {
    bool is_late = false; // where the graph of one method is not tightened in time, those of the others are left out
    for (const Way& way : all_ways)
    {
      Attempt a;
      if (is_late && way.tightening == Tightening::GRAPH) { a.verdict = "left out, as with contours it took too long"; }
      else { a = attempt(mesh.surface, way, limit, 3); }
      is_late =
        is_late
        || (a.is_late && std::holds_alternative<By_contours>(way.method) && way.tightening == Tightening::GRAPH);
      wrong += a.is_wrong;
      print_mesh(mesh);
      std::printf("\t%s", way.name().c_str());
      if (a.cut)
      {
        const Shape shape = measure_shape(mesh.surface, *a.cut);
        std::printf("\t%.3g\t%.4g\t%.3g\t%.4g\t%.3g\t%zu\t%.3g", a.seconds, shape.length, shape.turning,
                    shape.turning_per_size, shape.bend, a.cut->surface.origins.size(),
                    degrees * a.cut->smallest_angle_after);
      }
      else { std::printf("\t-\t-\t-\t-\t-\t-\t-"); }
      std::printf("\t%s\n", a.verdict.c_str());
      std::fflush(stdout);
    }
  }
  return wrong;
}

// The shortest of a family, and how many there are.
struct Shortest
{
  std::optional<Family_member> member;
  int members = 0, wrong = 0;
  std::string note = "-";
};

Shortest find_shortest_member(const Triangle_surface& s, Tightening tightening, Time_limit& time_limit)
{
  Shortest best;
  Cut_options options;
  options.tightening = tightening;
  options.observer = &time_limit;
  Cut_family family(s, 16, options);
  while (best.wrong < 3) try
    {
      std::optional<Family_member> member = family.next();
      if (!member) { break; }
      ++best.members;
      if (!best.member || member->cut.length < best.member->cut.length) { best.member = std::move(member); }
    }
    catch (const Cancelled&)
    {
      best.note = "ended by the time limit";
      break;
    }
    catch (const Internal_error& e)
    {
      best.note = std::string("WRONG: ") + e.what();
      ++best.wrong;
    }
    catch (const std::exception& e)
    {
      best.note = e.what();
      break;
    }
  return best;
}

int measure_families(const std::vector<Mesh>& meshes, double limit)
{
  std::printf("mesh\tfaces\tgenus\tloops\ttightening\tmembers\tseconds\tlength\tturning\tturning_per_size\tturning_"
              "tree_cotree\tturning_geometry_image\t"
              "ratio_tree_cotree\tratio_geometry_image\tper_size_ratio_tree_cotree\tper_size_ratio_geometry_image\t"
              "bend\tbend_ratio_tree_cotree\tbend_ratio_geometry_image\tshortest\tnote\n");
  int wrong = 0;
  for (const Mesh& mesh : meshes)
  {
    Shape plain[2];
    for (int i = 0; i < 2; ++i)
    {
      const Attempt a =
        attempt(mesh.surface,
                {i == 0 ? Cut_method(By_tree_cotree()) : Cut_method(By_removing_faces()), Tightening::NONE}, limit, 1);
      wrong += a.is_wrong;
      if (a.cut) { plain[i] = measure_shape(mesh.surface, *a.cut); }
    }
    for (Tightening tightening : {Tightening::CURVES, Tightening::GRAPH})
    {
      Time_limit time_limit(limit);
      const Shortest best = find_shortest_member(mesh.surface, tightening, time_limit);
      wrong += best.wrong;
      print_mesh(mesh);
      std::printf("\t%s\t%d\t%.3g", name_of(tightening), best.members, seconds_since(time_limit.begin));
      const Shape shape = best.member ? measure_shape(mesh.surface, best.member->cut) : Shape();
      std::printf("\t%.4g\t%.3g\t%.4g\t%.3g\t%.3g", shape.length, shape.turning, shape.turning_per_size,
                  plain[0].turning, plain[1].turning);
      for (double Shape::*angle : {&Shape::turning, &Shape::turning_per_size})
        for (const Shape& p : plain) { std::printf("\t%.3f", shape.*angle / p.*angle); }
      std::printf("\t%.3g", shape.bend);
      for (const Shape& p : plain) { std::printf("\t%.3f", shape.bend / p.bend); }
      std::printf("\t%s\t%s\n", best.member ? best.member->name.c_str() : "-", best.note.c_str());
      std::fflush(stdout);
    }
  }
  return wrong;
}

using Segments = std::vector<std::array<Point, 2>>;
Segments segments_of(const Triangle_surface& s, const Cut& cut)
{
  Segments segments;
  for (const auto& seam : cut.opened.seams)
  {
    segments.push_back({s.points[cut.surface.source(seam[0])], s.points[cut.surface.target(seam[0])]});
  }
  return segments;
}

// The mean distance of the middles of some segments from others, each counting by its length.
double mean_distance(const Segments& from, const Segments& to)
{
  double sum = 0, length = 0;
  for (const auto& [p, q] : from)
  {
    double nearest = 1e300;
    for (const auto& [a, b] : to)
    {
      const Point ab = b - a, am = 0.5 * (p + q) - a;
      const double t = dot(ab, ab) > 0 ? std::min(std::max(dot(am, ab) / dot(ab, ab), 0.), 1.) : 0;
      nearest = std::min(nearest, norm(am - t * ab));
    }
    sum += distance(p, q) * nearest, length += distance(p, q);
  }
  return length > 0 ? sum / length : 0;
}
double distance_between(const Segments& a, const Segments& b)
{
  return (mean_distance(a, b) + mean_distance(b, a)) / 2;
}

// A surface that was changed, and how it was turned.
struct Changed
{
  const char* change;
  Triangle_surface surface;
  double a = 0, b = 0;
};

// The places of a cut of a changed surface, turned back.
Segments segments_turned_back(const Changed& changed, const Cut& cut)
{
  Triangle_surface points;
  points.points = cut.surface.points;
  return segments_of(sample::rotated(sample::rotated(std::move(points), 0, -changed.b), -changed.a, 0), cut);
}

std::vector<Changed> change(const Triangle_surface& s)
{
  std::vector<Changed> all;
  for (const auto& [a, b] :
       {std::pair<double, double>{0.3, 0.7}, {1.1, 2}, {2.5, 0.4}, {sample::pi / 2, 0.1}, {0, 1.3}})
    all.push_back({"rotated", sample::rotated(s, a, b), a, b});
  for (unsigned seed = 1; seed <= 5; ++seed) { all.push_back({"renumbered", sample::renumbered(s, seed)}); }
  all.push_back({"subdivided", sample::subdivided(s)});
  for (unsigned seed = 1; seed <= 5; ++seed) { all.push_back({"noise", sample::noisy(s, 0.1 * mean_edge(s), seed)}); }
  return all;
}

// The bi-torus with a tiny handle at one of six places on the outside of its rings.
Triangle_surface bitorus_with_handle_at(int cells, int place)
{
  const double side = place % 2 == 0 ? 1 : -1, angle = place / 2 - 1;
  const auto distance_from = [=](const Point& p) {
    const double x = side * p[0] - 1.05, turned_x = std::cos(angle) * x + std::sin(angle) * p[1],
                 turned_y = std::cos(angle) * p[1] - std::sin(angle) * x;
    return sample::blend(sample::bitorus_distance(p),
                         sample::ring({p[2] - 0.32, turned_x - 0.8, turned_y}, 0.14, 0.055), 0.04);
  };
  return sample::isosurface(distance_from, 2.4, cells);
}

const Way stable_ways[] = {
  {By_contours(), Tightening::NONE},
  {By_contours(), Tightening::CURVES},
  {By_contours(), Tightening::GRAPH},
  {By_distance(), Tightening::CURVES},
  {By_tree_cotree(), Tightening::NONE, false, 1},
  {By_tree_cotree(), Tightening::NONE},
  {By_tree_cotree(), Tightening::GRAPH},
  {By_removing_faces(), Tightening::NONE},
  {By_removing_faces(), Tightening::GRAPH},
};

// How much cuts changed, in percent: their length, and their place over the square root of the area.
struct Moves
{
  std::vector<double> length, place;
  int missing = 0;
};

void print_moves(const char* surface, int faces, const char* change, const Way& way, const Moves& m)
{
  std::printf("%s\t%d\t%s\t%s\t%zu\t%d", surface, faces, change, way.name().c_str(), m.length.size(), m.missing);
  std::vector<double> sizes;
  for (double d : m.length) { sizes.push_back(std::abs(d)); }
  std::printf("\t%.3f", median(sizes));
  for (const auto* values : {&m.length, &m.place})
  {
    if (values->empty())
    {
      std::printf("\t-\t-\t-");
      continue;
    }
    std::printf("\t%.3f\t%.3f\t%.3f", median(*values), *std::min_element(values->begin(), values->end()),
                *std::max_element(values->begin(), values->end()));
  }
  std::printf("\n");
  std::fflush(stdout);
}

using All_moves = std::map<std::pair<std::string, const Way*>, Moves>; // of many surfaces, by change and way

int measure_changes(const char* name, const Triangle_surface& s, const std::vector<Changed>& all,
                    std::vector<All_moves*> together)
{
  int wrong = 0;
  for (const Way& way : stable_ways)
  {
    const Attempt first = attempt(s, way, 1e9, 1);
    wrong += first.is_wrong;
    std::vector<std::pair<std::string, Moves>> moves;
    for (const Changed& changed : all)
    {
      if (moves.empty() || moves.back().first != changed.change) { moves.push_back({changed.change, {}}); }
      const Attempt then = attempt(changed.surface, way, 1e9, 1);
      wrong += then.is_wrong;
      const bool is_cut = first.cut && then.cut;
      const double away =
        is_cut ? distance_between(segments_of(first.cut->surface, *first.cut), segments_turned_back(changed, *then.cut))
               : 0;
      std::vector<Moves*> counted{&moves.back().second};
      for (All_moves* t : together) { counted.push_back(&(*t)[{changed.change, &way}]); }
      for (Moves* m : counted)
      {
        if (!is_cut)
        {
          ++m->missing;
          continue;
        }
        m->length.push_back(100 * (then.cut->length / first.cut->length - 1));
        m->place.push_back(100 * away / std::sqrt(area(s)));
      }
    }
    for (const auto& [change, m] : moves) { print_moves(name, s.number_of_faces(), change.c_str(), way, m); }
  }
  return wrong;
}

int measure_stability(int cells)
{
  std::printf("surface\tfaces\tchange\tmethod\ttightening\truns\tmissing\tlength_size\tlength_median\tlength_"
              "min\tlength_max\tplace_median\tplace_min\tplace_max\n");
  const Triangle_surface bitorus = sample::bitorus(cells), fine = sample::bitorus(3 * cells / 2),
                         plate = sample::plate(3, cells / 4);
  const Triangle_surface rings = sample::noisy(sample::three_rings(cells), 0.02, 7),
                         noisy_plate = sample::noisy(plate, 0.5 * mean_edge(plate), 7);
  All_moves moves, moves_without_symmetry;
  int wrong = 0;
  const auto measure = [&](const char* name, const Triangle_surface& s, bool is_symmetric) {
    std::vector<All_moves*> together{&moves};
    if (!is_symmetric) { together.push_back(&moves_without_symmetry); }
    wrong += measure_changes(name, s, change(s), together);
  };
  measure("bi-torus", bitorus, true);
  measure("pot", sample::teapot(cells), true);
  measure("irregular torus", sample::irregular_torus(cells), true);
  measure("noisy plate", noisy_plate, false);
  measure("three rings, noisy", rings, false);
  std::vector<Changed> handles;
  for (int place = 0; place < 6; ++place)
  {
    handles.push_back({"tiny handle", bitorus_with_handle_at(3 * cells / 2, place)});
  }
  // where the grid is too coarse for it
  const auto has_none = [](const Changed& c) { return sample::euler_characteristic(c.surface) != -4; };
  handles.erase(std::remove_if(handles.begin(), handles.end(), has_none), handles.end());
  wrong += measure_changes("bi-torus, fine", fine, handles, {&moves});
  for (const auto& [key, m] : moves) { print_moves("all", 0, key.first.c_str(), *key.second, m); }
  for (const auto& [key, m] : moves_without_symmetry)
  {
    print_moves("all without symmetry", 0, key.first.c_str(), *key.second, m);
  }
  return wrong;
}

} // namespace

int main(int argc, char** argv)
{
  const std::string what = argc > 1 ? argv[1] : "";
  const int cells = argc > 2 ? std::atoi(argv[2]) : 48; // with "stability"
  if (what == "stability" && argc <= 3 && cells >= 16) { return measure_stability(cells) > 0; }
  if (what == "methods" || what == "families")
  {
    const bool has_limit = argc > 3 && std::strcmp(argv[2], "--limit") == 0;
    const double limit = has_limit ? std::atof(argv[3]) : 300;
    std::vector<Mesh> meshes;
    for (int i = has_limit ? 4 : 2; i < argc; ++i) { meshes.push_back(read_largest_component(argv[i])); }
    if (meshes.empty()) { meshes.push_back(make_mesh("bi-torus", sample::bitorus(24))); }
    return (what == "methods" ? measure_methods : measure_families)(meshes, limit) > 0;
  }
  std::fprintf(
    stderr,
    "measure_cuts methods | families [--limit SECONDS] [MESH...]\nmeasure_cuts stability [CELLS, 16 or more]\n");
  return 64;
}
