// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/Field.h>

#include <meridian/base/exceptions.h>
#include <meridian/surface/check_surface.h>

namespace meridian {

void check(const Triangle_surface& s, const Field_options& options)
{
  check_vertices(s, options.minima, "the minima of a field");
  check_vertices(s, options.maxima, "the maxima of a field");
  if (options.minima.empty() != options.maxima.empty())
  {
    throw Invalid_input_error("minima and maxima of a field go together; give both or neither");
  }
  if (!options.values.empty()) { check_values(s, options.values, "the field"); }
}

} // namespace meridian
