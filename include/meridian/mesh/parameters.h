// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_PARAMETERS_H
#define MERIDIAN_MESH_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <type_traits>

// The table of this package's named parameters. NAME is what a caller writes, NAME_t the tag the library looks up.
// clang-format off
#define MERIDIAN_FOR_EACH_PARAMETER(X) \
  X(cut_options) X(generator_options) X(basis_options) X(tighten_options) X(unwrap_options) X(map_options) \
  X(laplacian_weights) X(field_map) X(vertex_weight_map) X(vertex_field_map) X(vertex_origin_map) X(face_origin_map) \
  X(morse_graph) X(cut_traits) X(curve_output_iterator)
// Those of CGAL's that may stand anywhere in the chain: what a caller writes, and CGAL's tag.
#define MERIDIAN_FOR_EACH_CGAL_PARAMETER(X) \
  X(vertex_point_map, vertex_point_t) \
  X(geom_traits, geom_traits_t) \
  X(edge_is_constrained_map, edge_is_constrained_t) \
  X(vertex_is_constrained_map, vertex_is_constrained_t) \
  X(sparse_linear_solver, sparse_linear_solver_t) \
  X(visitor, visitor_t) \
  X(vertex_to_vertex_output_iterator, vertex_to_vertex_output_iterator_t) \
  X(face_to_face_output_iterator, face_to_face_output_iterator_t)
// clang-format on

namespace meridian {

namespace internal_np {
#define MERIDIAN_TAG(NAME) enum NAME##_t{NAME};
MERIDIAN_FOR_EACH_PARAMETER(MERIDIAN_TAG)
#undef MERIDIAN_TAG
} // namespace internal_np

/// \ingroup PkgMeridianParameters
/// a CGAL parameter pack that also knows this package's names: `parameters::cut_options(o)`. What a function does not
/// use is a compile error.
template <class T, class Tag, class Base = CGAL::internal_np::No_property>
struct Parameters : CGAL::Named_function_parameters<T, Tag, Base>
{
  /// what CGAL sees.
  using Pack = CGAL::Named_function_parameters<T, Tag, Base>;
  using Pack::Pack;
#define MERIDIAN_MEMBER(NAME) \
  template <class K> Parameters<K, internal_np::NAME##_t, Pack> NAME(const K& k) const \
  { \
    return Parameters<K, internal_np::NAME##_t, Pack>(k, *this); \
  }
  MERIDIAN_FOR_EACH_PARAMETER(MERIDIAN_MEMBER)
#undef MERIDIAN_MEMBER
#define MERIDIAN_MEMBER(NAME, TAG) \
  template <class K> Parameters<K, CGAL::internal_np::TAG, Pack> NAME(const K& k) const \
  { \
    return Parameters<K, CGAL::internal_np::TAG, Pack>(k, *this); \
  }
  MERIDIAN_FOR_EACH_CGAL_PARAMETER(MERIDIAN_MEMBER)
#undef MERIDIAN_MEMBER
};

/// \ingroup PkgMeridianParameters
/// the functions that begin a chain of parameters.
namespace parameters {
#define MERIDIAN_FUNCTION(NAME) \
  template <class K> Parameters<K, internal_np::NAME##_t> NAME(const K& k) \
  { \
    return Parameters<K, internal_np::NAME##_t>(k); \
  }
MERIDIAN_FOR_EACH_PARAMETER(MERIDIAN_FUNCTION)
#undef MERIDIAN_FUNCTION
#define MERIDIAN_FUNCTION(NAME, TAG) \
  template <class K> Parameters<K, CGAL::internal_np::TAG> NAME(const K& k) \
  { \
    return Parameters<K, CGAL::internal_np::TAG>(k); \
  }
MERIDIAN_FOR_EACH_CGAL_PARAMETER(MERIDIAN_FUNCTION)
#undef MERIDIAN_FUNCTION
} // namespace parameters

#undef MERIDIAN_FOR_EACH_PARAMETER
#undef MERIDIAN_FOR_EACH_CGAL_PARAMETER

namespace internal {

template <class T, class Tag, class Base> std::true_type is_pack(const CGAL::Named_function_parameters<T, Tag, Base>*);
std::false_type is_pack(const void*);

// Whether a type is a sequence of named parameters.
template <class T>
constexpr bool is_named_parameters = decltype(is_pack(static_cast<std::decay_t<T>*>(nullptr)))::value;

// Calls `use` with a map that was given.
template <class Map, class Use> void if_given(const Map& map, const Use& use)
{
  if constexpr (!std::is_same_v<Map, CGAL::internal_np::Param_not_found>) { use(map); }
}

// Does the pack hold nothing but the tags in `Allowed`? CGAL ignores a parameter that a function does not read; here it
// is a compile error.
template <class... Allowed, class T, class Tag, class Base>
constexpr bool uses_only(const CGAL::Named_function_parameters<T, Tag, Base>*)
{
  constexpr bool known = std::is_same_v<Tag, CGAL::internal_np::all_default_t> || (std::is_same_v<Tag, Allowed> || ...);
  if constexpr (std::is_same_v<Base, CGAL::internal_np::No_property>) { return known; }
  else { return known && uses_only<Allowed...>(static_cast<const Base*>(nullptr)); }
}

// Refuses named parameters that a function does not use, where it is compiled.
template <class... Allowed, class NamedParameters> constexpr void check_parameters(const NamedParameters&)
{
  static_assert(uses_only<Allowed...>(static_cast<const NamedParameters*>(nullptr)),
                "this function was given a named parameter that it does not use");
}

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_MESH_PARAMETERS_H
