// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_paths.h"
#include "cut.h"
#include "files/map_file.h"
#include "files/write_mesh.h"

#include <meridian/base/exceptions.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/unwrap/cut_family.h>

#include <iomanip>
#include <iostream>
#include <sstream>

namespace meridian {
namespace program {

namespace {

// The path with a number before its ending: disc.obj.gz, 7 -> disc_07.obj.gz.
std::string numbered(const std::string& path, std::size_t number)
{
  if (path.empty()) { return path; }
  const std::size_t name = path.find_last_of("/\\") + 1;
  const std::size_t end = files::is_packed(path) ? path.size() - 3 : path.size(), dot = path.rfind('.', end - 1);
  std::ostringstream text;
  text << '_' << std::setw(2) << std::setfill('0') << number;
  return std::string(path).insert(dot == std::string::npos || dot < name ? end : dot, text.str());
}

struct Row
{
  std::string name, file;
  double length;
  std::size_t new_vertices;
  double smallest_angle;
};

// No file of any member may be another's, or the input.
void check_family_paths(const Cut_arguments& arguments)
{
  std::vector<std::string> written{arguments.report};
  for (int i = 0; i < arguments.family; ++i)
    for (const std::string& path : {arguments.out, arguments.curves, arguments.view})
    {
      written.push_back(numbered(path, i));
      if (path == arguments.out) { written.push_back(files::map_path(written.back(), arguments.map)); }
    }
  check_paths(files_read_for(arguments), written);
}

Row measure(const std::string& name, const std::string& file, const Cut_result& result)
{
  Row row{name, file, result.length, 0, std::numeric_limits<double>::infinity()};
  for (const Cut& cut : result.cuts)
  {
    row.new_vertices += cut.surface.origins.size();
    row.smallest_angle = std::min(row.smallest_angle, cut.smallest_angle_after * 180 / std::acos(-1.));
  }
  return row;
}

Json report_member(const Row& row, const Cut_result& result)
{
  return {{"name", row.name},
          {"file", row.file},
          {"length", row.length},
          {"new_vertices", row.new_vertices},
          {"smallest_angle", row.smallest_angle},
          {"components", result.components},
          {"failures", result.verification.failures},
          {"verified", static_cast<bool>(result.verification)}};
}

void print_table(const std::vector<Row>& rows, const std::vector<char>& is_best)
{
  std::cout << "      length  new vertices  smallest angle\n";
  for (std::size_t i = 0; i < rows.size(); ++i)
    std::cout << std::setw(12) << rows[i].length << std::setw(14) << rows[i].new_vertices << std::setw(15)
              << std::setprecision(3) << rows[i].smallest_angle << std::setprecision(6) << (is_best[i] ? " * " : "   ")
              << rows[i].file << ": " << rows[i].name << '\n';
}

std::vector<char> find_best_rows(const std::vector<Row>& rows)
{
  std::vector<std::array<double, 3>> costs;
  for (const Row& row : rows)
  {
    costs.push_back({row.length, static_cast<double>(row.new_vertices), -row.smallest_angle});
  }
  return find_best_cuts(costs);
}

Cut_result conclude_members(const Loaded_mesh& loaded, const std::vector<Family_member>& members, Terminal& terminal)
{
  std::vector<Cut> cuts;
  std::vector<Cut_options> used;
  for (const Family_member& member : members)
  {
    cuts.push_back(member.cut);
    used.push_back(member.options);
  }
  return conclude_cut(loaded, std::move(cuts), used, terminal);
}

// Goes on to the next cut of every component. Returns whether there was one.
bool advance(std::vector<Cut_family>& families, std::vector<Family_member>& current, Terminal& terminal)
{
  bool is_new = false;
  for (std::size_t i = 0; i < families.size(); ++i)
  {
    terminal.begin_component(i, families.size());
    auto member = families[i].next();
    if (!member) { continue; } // a component with fewer cuts keeps its last
    is_new = true;
    current[i] = std::move(*member);
  }
  return is_new;
}

} // namespace

int run_family(const Cut_arguments& arguments)
{
  files::check_writable_format(arguments.out);
  check_cut_arguments(arguments);
  check_family_paths(arguments);
  Terminal terminal(arguments.quiet);
  const Loaded_mesh loaded = load_mesh(arguments);
  const auto& components = loaded.examination.components;
  const std::vector<Cut_options> options = cut_options(arguments, loaded, terminal);
  std::vector<Cut_family> families;
  std::size_t largest = 0;
  for (std::size_t i = 0; i < components.size(); ++i)
  {
    families.emplace_back(components[i].surface, arguments.family, options[i]);
    if (components[i].surface.number_of_faces() > components[largest].surface.number_of_faces()) { largest = i; }
  }
  files::Output_files out;
  std::vector<Row> rows;
  Json members = Json::array();
  bool is_verified = true;
  std::vector<Family_member> current(components.size());
  while (static_cast<int>(rows.size()) < arguments.family)
  {
    if (!advance(families, current, terminal)) { break; }
    const Cut_result result = conclude_members(loaded, current, terminal);
    Cut_arguments paths = arguments;
    for (std::string* path : {&paths.out, &paths.curves, &paths.view}) { *path = numbered(*path, rows.size()); }
    Row row = measure(current[largest].name, paths.out, result);
    members.push_back(report_member(row, result));
    for (const std::string& failure : result.verification.failures)
    {
      std::cerr << "meridian: " << row.name << " not verified: " << failure << '\n';
    }
    if (result.verification) { add_cut(out, paths, loaded, result); }
    is_verified = is_verified && result.verification;
    rows.push_back(std::move(row));
  }
  const std::vector<char> is_best = find_best_rows(rows);
  for (std::size_t i = 0; i < rows.size(); ++i) { members[i]["best"] = static_cast<bool>(is_best[i]); }
  const Json report{{"meridian", MERIDIAN_VERSION},
                    {"input", report_input(arguments.mesh, loaded.soup, loaded.examination)},
                    {"family", members},
                    {"seconds", {{"read", loaded.seconds_reading}, {"examine", loaded.seconds_examining}}},
                    {"verified", is_verified}};
  if (!arguments.report.empty()) { out.add(arguments.report, format_report(report)); }
  commit(out);
  terminal.clear();
  if (!arguments.quiet)
  {
    for (const std::string& repair : loaded.examination.repairs) { std::cout << "note: " << repair << '\n'; }
    print_table(rows, is_best);
    std::cout << (is_verified ? "verified: " : "NOT all verified: ") << rows.size()
              << " different cuts; * no other is as good in every respect\n";
  }
  return is_verified ? VERIFIED : NOT_VERIFIED;
}

} // namespace program
} // namespace meridian
