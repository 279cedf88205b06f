// SPDX-License-Identifier: GPL-3.0-or-later
// A second recount of results from their files, in exact numbers, which shares no line with the library's.
#ifndef MERIDIAN_TEST_RECOUNT_H
#define MERIDIAN_TEST_RECOUNT_H

#include <string>
#include <vector>

namespace recount {

// What is wrong with a result: an OBJ file and its map in JSON, beside it, for an input in OFF or OBJ. Nothing if it is
// what it claims to be.
std::vector<std::string> failures_of(const std::string& input, const std::string& result);

} // namespace recount

#endif // MERIDIAN_TEST_RECOUNT_H
