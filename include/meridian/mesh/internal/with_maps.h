// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_INTERNAL_WITH_MAPS_H
#define MERIDIAN_MESH_INTERNAL_WITH_MAPS_H

#include <meridian/base/exceptions.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/field/Field.h>
#include <meridian/handles/preference.h>
#include <meridian/mesh/parameters.h>

#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace meridian {

namespace internal {

// The part of options that a property map is for, or of the method that they choose.
template <class Part, class Options> Part& part_of(Options& options, const char*) { return options; }
template <class Part> Part& part_of(Cut_options& options, const char* map)
{
  return std::visit(
    [&](auto& method) -> Part& {
      if constexpr (std::is_base_of_v<Part, std::decay_t<decltype(method)>>) { return method; }
      else { throw Invalid_input_error(std::string(map) + " would be ignored by method " + name_of(options.method)); }
    },
    options.method);
}

// Options with what property maps say: a field, and weights that meridians keep away from.
template <class Options, class TriangleMesh, class NamedParameters>
Options with_maps(Options options, const TriangleMesh& tm, const NamedParameters& np)
{
  using CGAL::parameters::get_parameter;
  const auto read = [&](const auto& map, const auto& use) {
    if_given(map, [&](const auto& given) {
      std::vector<double> values;
      for (auto v : vertices(tm)) { values.push_back(get(given, v)); }
      use(std::move(values));
    });
  };
  read(get_parameter(np, internal_np::field_map), [&](std::vector<double> values) {
    part_of<Field_options>(options, "field_map").field = Given_field{std::move(values)};
  });
  read(get_parameter(np, internal_np::vertex_weight_map), [&](std::vector<double> values) {
    part_of<Meridian_options>(options, "vertex_weight_map").preference = preference::low_weight(std::move(values));
  });
  return options;
}

} // namespace internal

} // namespace meridian

#endif // MERIDIAN_MESH_INTERNAL_WITH_MAPS_H
