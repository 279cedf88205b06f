// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_INTERNAL_WITH_MAPS_H
#define MERIDIAN_MESH_INTERNAL_WITH_MAPS_H

#include <meridian/handles/preference.h>
#include <meridian/mesh/parameters.h>

#include <type_traits>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

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
  read(get_parameter(np, internal_np::field_map),
       [&](std::vector<double> values) { options.values = std::move(values); });
  read(get_parameter(np, internal_np::vertex_weight_map),
       [&](std::vector<double> values) { options.preference = preference::low_weight(std::move(values)); });
  return options;
}

} // namespace internal

} // namespace meridian

#endif // MERIDIAN_MESH_INTERNAL_WITH_MAPS_H
