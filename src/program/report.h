// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_REPORT_H
#define MERIDIAN_REPORT_H

#include "report_proof.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Verification.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/handles/Generators.h>
#include <meridian/handles/find_shortest_basis.h>
#include <meridian/surface/examine_surface.h>

namespace meridian {
namespace program {

// The parts of a report; the keys are those of the manual.
Json report_input(const std::string& file, const Polygon_soup& soup, const Examination& examination);
Json report_counts(const Surface_component& component);
Json report_cut(const Cut& cut, const Surface_component& component, const Cut_options& options);
void add_counts(Json& of_cut, const Component_count& count); // what was recounted
// `first_handle`: the number of its first pair.
Json report_generators(const Generators& generators, const Surface_component& component, const Curve_count& count,
                       const Generator_options& options, int first_handle);
Json report_basis(const Homology_basis& basis, const Surface_component& component, const Curve_count& count);

} // namespace program
} // namespace meridian

#endif // MERIDIAN_REPORT_H
