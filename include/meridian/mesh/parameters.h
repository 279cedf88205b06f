// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_PARAMETERS_H
#define MERIDIAN_MESH_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <type_traits>

// The table of this package's named parameters. NAME is what a caller writes, NAME_t the tag the library looks up.
#define MERIDIAN_FOR_EACH_PARAMETER(X) \
  X(cut_options) X(generator_options) X(unwrap_options) X(field_map) X(vertex_weight_map)

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
} // namespace parameters

#undef MERIDIAN_FOR_EACH_PARAMETER

namespace internal {

// Does the pack hold nothing but the tags in `Allowed`? CGAL ignores a parameter that a function does not read; here it
// is a compile error.
template <class... Allowed, class T, class Tag, class Base>
constexpr bool uses_only(const CGAL::Named_function_parameters<T, Tag, Base>*)
{
  constexpr bool known = std::is_same_v<Tag, CGAL::internal_np::all_default_t> || (std::is_same_v<Tag, Allowed> || ...);
  if constexpr (std::is_same_v<Base, CGAL::internal_np::No_property>) { return known; }
  else { return known && uses_only<Allowed...>(static_cast<const Base*>(nullptr)); }
}

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_MESH_PARAMETERS_H
