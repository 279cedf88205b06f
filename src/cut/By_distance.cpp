// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/By_distance.h>

#include <meridian/base/exceptions.h>
#include <meridian/cut/internal/cut_along_contours.h>
#include <meridian/surface/check_surface.h>

namespace meridian {

namespace {

Field_options field_of(const By_distance& method) { return {method, Distance_field{method.source}}; }

} // namespace

void check(const By_distance& method) { check(field_of(method)); }

void check(const Triangle_surface& s, const By_distance& method) { check(s, field_of(method)); }

void By_distance::cut_handles(Cut_job& job) const { internal::cut_along_contours(job, field_of(*this), *this); }

} // namespace meridian
