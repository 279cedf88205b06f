// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_REPORT_PROOF_H
#define MERIDIAN_REPORT_PROOF_H

#include <meridian/base/Verification.h>

#include <nlohmann/json.hpp>

#include <string>

namespace meridian {
namespace program {

using Json = nlohmann::ordered_json;

// The parts of a report that tell of a recount; they read nothing of the construction.
Json report_counts(const Component_count& count);
// "symplectic", or the rows.
Json report_intersections(const Curve_count& count);
std::string format_report(const Json& report);

} // namespace program
} // namespace meridian

#endif // MERIDIAN_REPORT_PROOF_H
