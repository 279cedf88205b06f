// SPDX-License-Identifier: GPL-3.0-or-later
#include "arguments.h"
#include "check_paths.h"
#include "cut.h"
#include "files/read_result.h"
#include "memory.h"
#include "options.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Verification.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/map/distortion.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/result/discs_of.h>
#include <meridian/result/recount.h>
#include <meridian/surface/examine_surface.h>
#include <meridian/unwrap/compare_parameterizations.h>
#include <meridian/unwrap/cut_family.h>

#include <iostream>
#include <memory>

namespace meridian {
namespace program {

namespace {

// The discs of one cut, one a component; a failure of its recount is noted.
std::vector<Cut_disc> read_cut(const std::string& name, const Polygon_soup& soup, const Examination& examination,
                               std::vector<std::string>& failures)
{
  std::vector<Cut_disc> discs;
  const bool is_number = !name.empty() && name.size() < 4 && name.find_first_not_of("0123456789") == std::string::npos;
  if (!is_number)
  {
    const files::Result_files result = files::read_result(name);
    if (result.kind == files::Result_kind::GENERATORS)
    {
      throw Invalid_input_error(name
                                + ": generators are not taken apart into discs; give a result of `cut` or `unwrap`");
    }
    const Verification recount = verify_cut(soup, result.mesh);
    for (const std::string& failure : recount.failures) { failures.push_back(name + ": " + failure); }
    if (!recount) { return discs; }
    return cut_discs_of(soup, examination, result.mesh);
  }
  const int member = std::stoi(name);
  for (const Surface_component& c : examination.components)
  {
    Cut_family family(c.surface, member + 1); // recounts its members
    std::optional<Family_member> last;
    int found = 0;
    while (auto next = family.next())
    {
      last = std::move(next);
      ++found;
    }
    if (!last) { throw Internal_error("compare: a family is empty"); }
    if (found <= member && examination.components.size() == 1)
    {
      throw Usage_error("--cut " + name + ": the family has " + std::to_string(found) + " members");
    }
    discs.push_back(cut_disc_of(c.surface, last->cut)); // a component with fewer cuts keeps its last
  }
  return discs;
}

Json report_distortion(const Distortion& d, Index flipped)
{
  return {{"flipped", flipped},
          {"stretch_l2", d.stretch_l2},
          {"stretch_linf", d.stretch_linf},
          {"angle", d.angle * 180 / std::acos(-1.)},
          {"area", d.area},
          {"conformal", d.conformal},
          {"areal", d.areal}};
}

int run_compare(const Compare_arguments& arguments)
{
  std::vector<std::string> read{arguments.mesh};
  for (const std::string& cut : arguments.cuts)
  {
    const std::vector<std::string> of_cut = files_of_result(cut);
    read.insert(read.end(), of_cut.begin(), of_cut.end());
  }
  check_paths(read, {arguments.report});
  const Polygon_soup soup = files::read_mesh(arguments.mesh);
  reserve_memory_of_blas();
  const Examination examination = examine_surface(soup, arguments.repair);
  std::vector<std::string> failures;
  const auto first = read_cut(arguments.cuts[0], soup, examination, failures),
             second = read_cut(arguments.cuts[1], soup, examination, failures);
  Json components = Json::array();
  for (std::size_t i = 0; i < examination.components.size() && failures.empty(); ++i)
  {
    const Surface_component& component = examination.components[i];
    const Map_comparison c = compare_parameterizations(component.surface, first[i], second[i], arguments.weights);
    if (!(c.bound <= c.variation))
    {
      failures.push_back("component " + std::to_string(i) + ": the lower bound is larger than the variation");
    }
    Json r = report_counts(component);
    r["untouched"] = c.untouched.size();
    r["variation"] = component.unit * c.variation;
    r["bound"] = component.unit * c.bound;
    r["relative_variation"] = c.relative_variation;
    r["relative_bound"] = c.relative_bound;
    r["norm"] = c.norm;
    r["residual"] = {c.residual[0], c.residual[1]};
    r["maps"] = {report_distortion(c.distortion[0], c.flipped[0]), report_distortion(c.distortion[1], c.flipped[1])};
    components.push_back(r);
    if (arguments.quiet) { continue; }
    std::cout << "component " << i << ": " << c.untouched.size() << " of " << component.surface.number_of_vertices()
              << " vertices are touched by neither cut\n";
    if (!c.untouched.empty())
      std::cout << "  variation " << component.unit * c.variation << ", at least " << component.unit * c.bound
                << "; root mean square over the diameter " << c.relative_variation << '\n';
    for (int k = 0; k < 2; ++k)
      std::cout << "  " << arguments.cuts[k] << ": L2 stretch " << c.distortion[k].stretch_l2 << ", angle "
                << c.distortion[k].angle * 180 / std::acos(-1.) << " degrees, area " << c.distortion[k].area
                << ", flipped faces " << c.flipped[k] << '\n';
  }
  if (!arguments.report.empty())
  {
    files::Output_files out;
    out.add(arguments.report, format_report({{"meridian", MERIDIAN_VERSION},
                                             {"input", report_input(arguments.mesh, soup, examination)},
                                             {"cuts", arguments.cuts},
                                             {"weights", name_of(arguments.weights)},
                                             {"components", components},
                                             {"failures", failures},
                                             {"verified", failures.empty()}}));
    commit(out);
  }
  for (const std::string& failure : failures) { std::cerr << "meridian: not verified: " << failure << '\n'; }
  return failures.empty() ? VERIFIED : NOT_VERIFIED;
}

} // namespace

Command add_compare(CLI::App& app)
{
  const auto a = std::make_shared<Compare_arguments>();
  CLI::App* command = app.add_subcommand(
    "compare", "compare the maps into the plane that two cuts of a mesh lead to, and bound their variation from below");
  command->add_option("MESH", a->mesh, "the mesh file")->required();
  command
    ->add_option("--cut", a->cuts,
                 "a result of `cut` or `unwrap`, or the number of a member of the family (0 to 999); given twice")
    ->required()
    ->expected(2)
    ->type_name("CUT");
  add_choice(*command, "--weights", a->weights, "of the linear map into a circle");
  command->add_flag("--repair", a->repair, repair_help);
  add_common_options(*command, *a);
  return {command, [a] { return run_compare(*a); }};
}

} // namespace program
} // namespace meridian
