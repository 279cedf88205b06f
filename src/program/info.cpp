// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_paths.h"
#include "commands.h"
#include "files/Output_files.h"
#include "memory.h"
#include "options.h"
#include "report.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/surface/examine_surface.h>

#include <iostream>
#include <memory>
#include <new>

namespace meridian {
namespace program {

namespace {

// As many components as a person wants to read, then a sum.
void print(const std::string& mesh, const Polygon_soup& soup, const Examination& e)
{
  constexpr std::size_t shown = 20;
  std::cout << mesh << ": " << soup.points.size() << " vertices, " << soup.number_of_polygons() << " faces, "
            << e.components.size() << (e.components.size() == 1 ? " component\n" : " components\n");
  int genus = 0, loops = 0;
  for (std::size_t i = 0; i < e.components.size(); ++i)
  {
    const Surface_component& c = e.components[i];
    genus += c.genus();
    loops += c.boundary_loops;
    if (i >= shown) { continue; }
    std::cout << "  component " << i << ": V " << c.surface.number_of_vertices() << ", E "
              << c.surface.number_of_edges() << ", F " << c.surface.number_of_faces() << ", Euler characteristic "
              << c.euler_characteristic() << ", genus " << c.genus() << ", boundary loops " << c.boundary_loops << '\n';
  }
  if (e.components.size() > shown) { std::cout << "  ... and " << e.components.size() - shown << " more components\n"; }
  if (e.components.size() > 1) { std::cout << "  together: genus " << genus << ", boundary loops " << loops << '\n'; }
  for (const std::string& repair : e.repairs) { std::cout << "  note: " << repair << '\n'; }
}

int run_info(const Info_arguments& arguments)
{
  check_paths(arguments.meshes, {arguments.report});
  int status = VERIFIED;
  Json reports = Json::array();
  for (const std::string& mesh : arguments.meshes) try
    {
      const Polygon_soup soup = files::read_mesh(mesh);
      const Examination examination = examine_surface(soup, arguments.repair);
      if (!arguments.quiet) { print(mesh, soup, examination); }
      Json components = Json::array();
      for (const auto& c : examination.components) { components.push_back(report_counts(c)); }
      reports.push_back(
        {{"meridian", MERIDIAN_VERSION}, {"input", report_input(mesh, soup, examination)}, {"components", components}});
    }
    catch (const std::exception& e) // the others are still counted
    {
      const bool has_no_memory = dynamic_cast<const std::bad_alloc*>(&e) != nullptr;
      const std::string text = has_no_memory ? not_enough_memory : e.what();
      const std::string message = text.compare(0, mesh.size(), mesh) == 0 ? text : mesh + ": " + text;
      std::cerr << "meridian: " << message << '\n';
      reports.push_back({{"meridian", MERIDIAN_VERSION}, {"input", {{"file", mesh}}}, {"error", message}});
      status = UNUSABLE_INPUT;
    }
  if (!arguments.report.empty())
  {
    files::Output_files out;
    out.add(arguments.report, format_report(reports.size() == 1 ? reports.front() : reports));
    commit(out);
  }
  return status;
}

} // namespace

Command add_info(CLI::App& app)
{
  const auto a = std::make_shared<Info_arguments>();
  CLI::App* command = app.add_subcommand("info", "count what meshes are: components, boundary loops, genus, defects");
  command->add_option("MESH", a->meshes, "mesh files")->required();
  command->add_flag("--repair", a->repair, repair_help);
  add_common_options(*command, *a);
  return {command, [a] { return run_info(*a); }};
}

} // namespace program
} // namespace meridian
