// SPDX-License-Identifier: GPL-3.0-or-later
#include "report.h"

namespace meridian {
namespace program {

namespace {

const char* name_of(Weights weights)
{
  switch (weights)
  {
  case Weights::POSITIVE: return "positive";
  case Weights::MEAN_VALUE: return "mean-value";
  case Weights::COTANGENT: return "cotangent";
  }
  return "";
}

double degrees(double radians) { return radians * 180 / std::acos(-1.); }

double length_of(const Disc_cut& cut, const std::vector<Index>& path, bool closed)
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
  return {{"file", file}, {"vertices", soup.points.size()}, {"edges", edges}, {"faces", faces}, {"repairs", examination.repairs}};
}

Json report_counts(const Surface_component& c)
{
  return {{"vertices", c.surface.number_of_vertices()}, {"edges", c.surface.number_of_edges()}, {"faces", c.surface.number_of_faces()},
          {"euler_characteristic", c.euler_characteristic()}, {"genus", c.genus()}, {"boundary_loops", c.boundary_loops}};
}

Json report_counts(const Component_count& c)
{
  return {{"vertices", c.vertices}, {"edges", c.edges}, {"faces", c.faces},
          {"euler_characteristic", c.euler_characteristic}, {"genus", c.genus}, {"boundary_loops", c.boundary_loops}};
}

Json report_cut(const Disc_cut& cut, const Surface_component& component, const Component_count& count, const Cut_options& options)
{
  Json r = report_counts(component);
  const bool has_field = !cut.field.empty();
  r["field"] = {{"kind", has_field ? "harmonic" : "none"}, {"weights", name_of(options.weights)}, {"mode", "closed"},
                {"minima", cut.counts.minima}, {"maxima", cut.counts.maxima}, {"saddles", cut.counts.saddles},
                {"counted_on", "closed model"}, {"order_sweeps", cut.order_rounds}, {"order_numbered", cut.order_numbered},
                {"flat_regions", cut.flat_regions}};
  Json meridians = Json::array(), links = Json::array();
  for (std::size_t i = 0; i < cut.meridians.size(); ++i)
    meridians.push_back({{"length", component.unit * length_of(cut, cut.meridians[i], true)}, {"saddle", component.vertex_of[cut.saddles[i]]},
                         {"genus_after", cut.choices[i].genus_after}, {"components_after", cut.choices[i].components_after}});
  for (const auto& link : cut.links) { links.push_back({{"length", component.unit * length_of(cut, link, false)}}); }
  r["cut"] = {{"edges", cut.opened.seams.size()}, {"length", component.unit * cut.length}, {"connected", count.discs == 1},
              {"euler_characteristic", count.disc_euler_characteristic}, {"boundary_loops", count.disc_boundary_loops},
              {"meridians", meridians}, {"links", links}, {"link_domain", cut.links_in_plane ? "plane" : "surface"},
              {"new_vertices", cut.surface.origins.size()}, {"smallest_angle_before", degrees(cut.smallest_angle_before)},
              {"smallest_angle_after", degrees(cut.smallest_angle_after)}};
  if (!cut.link_note.empty()) { r["cut"]["link_note"] = cut.link_note; }
  Json seconds = Json::object();
  for (const auto& [stage, s] : cut.seconds) { seconds[name_of(stage)] = s; }
  r["seconds"] = seconds;
  return r;
}

std::string format_report(const Json& report) { return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

} // namespace program
} // namespace meridian
