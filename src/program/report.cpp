// SPDX-License-Identifier: GPL-3.0-or-later
#include "report.h"

#include <meridian/base/Bounding_box.h>
#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Progress_observer.h>
#include <meridian/base/Verification.h>
#include <meridian/base/names.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/field/Field.h>
#include <meridian/handles/Generators.h>
#include <meridian/handles/find_shortest_basis.h>
#include <meridian/surface/examine_surface.h>

#include <array>
#include <cstddef>

namespace meridian {
namespace program {

namespace {

double degrees(double radians) { return radians * 180 / std::acos(-1.); }

double length_of(const Cut& cut, const std::vector<Index>& path, bool closed)
{
  double sum = 0;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < path.size(); ++i)
    sum += distance(cut.surface.points[path[i]], cut.surface.points[path[(i + 1) % path.size()]]);
  return sum;
}

} // namespace

Json report_input(const std::string& file, const Polygon_soup& soup, const Examination& examination)
{
  std::int64_t edges = 0, faces = 0;
  for (const auto& c : examination.components)
  {
    edges += c.surface.number_of_edges();
    faces += c.surface.number_of_faces();
  }
  return {{"file", file},
          {"vertices", soup.points.size()},
          {"edges", edges},
          {"faces", faces},
          {"repairs", examination.repairs}};
}

Json report_counts(const Surface_component& c)
{
  return {{"vertices", c.surface.number_of_vertices()},
          {"edges", c.surface.number_of_edges()},
          {"faces", c.surface.number_of_faces()},
          {"euler_characteristic", c.euler_characteristic()},
          {"genus", c.genus()},
          {"boundary_loops", c.boundary_loops}};
}

namespace {

Json report_field(const Field_summary& f, Weights weights)
{
  Json field{{"kind", f.field_kind},          {"weights", name_of(weights)},    {"mode", "closed"},
             {"minima", f.counts.minima},     {"maxima", f.counts.maxima},      {"saddles", f.counts.saddles},
             {"counted_on", "closed model"},  {"order_sweeps", f.order_rounds}, {"order_numbered", f.order_numbered},
             {"flat_regions", f.flat_regions}};
  if (!f.solver.empty()) { field["solver"] = f.solver; }
  return field;
}

Json report_seconds(const Stage_times& times)
{
  Json seconds = Json::object();
  for (const auto& [stage, s] : times) { seconds[name_of(stage)] = s; }
  return seconds;
}

} // namespace

Json report_cut(const Cut& cut, const Surface_component& component, const Cut_options& options)
{
  Json r = report_counts(component);
  r["field"] = report_field(cut, weights_of(options.method));
  std::array<Json, number_of<Curve_kind>> curves;
  for (Json& of_kind : curves) { of_kind = Json::array(); }
  for (const Named_curve& c : cut.curves)
  {
    Json& list = curves[static_cast<std::size_t>(c.kind)];
    list.push_back({{"length", component.unit * length_of(cut, c.vertices, c.is_closed)}});
    if (c.kind != Curve_kind::MERIDIAN) { continue; }
    list.back()["saddle"] = component.vertex_of[c.saddle];
    if (list.size() <= cut.choices.size())
    {
      list.back()["genus_after"] = cut.choices[list.size() - 1].genus_after;
      list.back()["components_after"] = cut.choices[list.size() - 1].components_after;
    }
  }
  const auto of_kind = [&](Curve_kind kind) -> const Json& { return curves[static_cast<std::size_t>(kind)]; };
  r["cut"] = {{"method", name_of(options.method)},
              {"edges", cut.opened.seams.size()},
              {"length", component.unit * cut.length},
              {"connected", false}, // these three as they are recounted
              {"euler_characteristic", 0},
              {"boundary_loops", 0},
              {"meridians", of_kind(Curve_kind::MERIDIAN)},
              {"longitudes", of_kind(Curve_kind::LONGITUDE).size()},
              {"flow_lines", of_kind(Curve_kind::FLOW_LINE).size()},
              {"links", of_kind(Curve_kind::LINK)},
              {"paths", of_kind(Curve_kind::PATH)},
              {"arcs", of_kind(Curve_kind::ARC)},
              {"seams", of_kind(Curve_kind::SEAM)},
              {"tightening", name_of(cut.tightening)},
              {"length_found", component.unit * cut.length_found},
              {"on_edges", options.on_edges},
              {"link_domain", cut.links_in_plane ? "plane" : "surface"},
              {"new_vertices", cut.surface.origins.size()},
              {"smallest_angle_before", degrees(cut.smallest_angle_before)},
              {"smallest_angle_after", degrees(cut.smallest_angle_after)}};
  if (!cut.link_note.empty()) { r["cut"]["link_note"] = cut.link_note; }
  r["seconds"] = report_seconds(cut.seconds);
  return r;
}

void add_counts(Json& of_cut, const Component_count& count)
{
  of_cut["cut"]["connected"] = count.discs == 1;
  of_cut["cut"]["euler_characteristic"] = count.disc_euler_characteristic;
  of_cut["cut"]["boundary_loops"] = count.disc_boundary_loops;
}

namespace {

// Where a pair lies, in the unit of the file.
struct Pair_place
{
  Json low, high, centre;
};

Pair_place locate(const Generators& g, const Generator_pair& pair, double unit)
{
  Bounding_box<Point> box(g.surface.points[pair.meridian.vertices.front()]);
  Point sum{0, 0, 0};
  double weight = 0;
  for (const Generator_curve* c : {&pair.meridian, &pair.longitude})
    for (std::size_t i = 0; i < c->vertices.size(); ++i)
    {
      const Point &p = g.surface.points[c->vertices[i]],
                  &q = g.surface.points[c->vertices[(i + 1) % c->vertices.size()]];
      box.add(p);
      const double l = distance(p, q);
      sum = sum + (l / 2) * (p + q);
      weight += l;
    }
  const auto in_file = [&](const Point& p) { return Json{unit * p[0], unit * p[1], unit * p[2]}; };
  return {in_file(box.low), in_file(box.high), in_file(weight > 0 ? (1 / weight) * sum : box.low)};
}

// What pairs and loops have in common; `Curves` is `Generators` or `Homology_basis`.
template <class Curves> void add_curve_counts(Json& r, const Curves& found, const Curve_count& count)
{
  r["intersection_matrix"] = report_intersections(count);
  r["is_basis"] = count.is_basis;
  r["new_vertices"] = found.surface.origins.size();
  r["smallest_angle_before"] = degrees(found.smallest_angle_before);
  r["smallest_angle_after"] = degrees(found.smallest_angle_after);
  r["seconds"] = report_seconds(found.seconds);
}

} // namespace

Json report_generators(const Generators& g, const Surface_component& component, const Curve_count& count,
                       const Generator_options& options, int first_handle)
{
  Json r = report_counts(component);
  r["field"] = report_field(g, weights_of(options.field));
  const auto curve = [&](const Generator_curve& c) {
    return Json{{"length", component.unit * c.length},
                {"length_found", component.unit * c.length_found},
                {"saddle", c.saddle < 0 ? Json() : Json(component.vertex_of[c.saddle])},
                {"method", name_of(c.method)},
                {"was_flow", c.was_flow},
                {"class", name_of(c.loop_class)},
                {"edges", c.vertices.size()}};
  };
  Json pairs = Json::array();
  for (const Generator_pair& pair : g.pairs)
  {
    const Pair_place place = locate(g, pair, component.unit);
    pairs.push_back({{"handle", first_handle++},
                     {"meridian", curve(pair.meridian)},
                     {"longitude", curve(pair.longitude)},
                     {"class", name_of(pair.meridian.loop_class)},
                     {"bounding_box", {place.low, place.high}},
                     {"centre", place.centre}});
  }
  if (options.is_open && g.boundary_loops > 0)
  {
    r["field"]["mode"] = "open";
    r["field"]["counted_on"] = "surface with its boundary filled";
    r["field"]["meridian_loops"] = g.loops;
    r["field"]["meridian_arcs"] = g.arcs;
  }
  r["field"]["morse_smale"] = g.is_morse_smale;
  r["field"]["saddle_connections"] = g.saddle_connections;
  r["generators"] = pairs;
  add_curve_counts(r, g, count);
  return r;
}

Json report_basis(const Homology_basis& b, const Surface_component& component, const Curve_count& count)
{
  Json r = report_counts(component);
  Json loops = Json::array();
  double length = 0;
  for (const Generator_curve& c : b.loops)
  {
    loops.push_back({{"length", component.unit * c.length},
                     {"length_found", component.unit * c.length_found},
                     {"edges", c.vertices.size()}});
    length += component.unit * c.length;
  }
  r["basis"] = {{"loops", loops}, {"length", length}};
  add_curve_counts(r, b, count);
  return r;
}

} // namespace program
} // namespace meridian
