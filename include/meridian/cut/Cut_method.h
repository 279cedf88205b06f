// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_CUT_METHOD_H
#define MERIDIAN_CUT_CUT_METHOD_H

#include <meridian/base/choices.h>
#include <meridian/cut/By_contours.h>
#include <meridian/cut/By_distance.h>
#include <meridian/cut/By_flow_lines.h>
#include <meridian/cut/By_generators.h>
#include <meridian/cut/By_own_method.h>
#include <meridian/cut/By_removing_faces.h>
#include <meridian/cut/By_tree_cotree.h>
#include <meridian/field/edge_weights.h>

#include <type_traits>
#include <variant>

namespace meridian {

/// \ingroup PkgMeridianCut
/// what cuts the handles, with what one may choose about it.
///
/// A method is a type with
/// - `names`, a static `Choice_name`, by which reports and the program's options know it;
/// - `cuts_edges`: whether it finds a whole cut graph of edges, so that there are no links and no field;
/// - `moves_onto_edges`: whether its curves can be moved onto edges one by one, where only edges shall be cut;
/// - `cut_handles(Cut_job&) const`, which cuts.
///
/// To add one is to write its file and its line here. `By_own_method` takes one that is not of the library.
using Cut_method = std::variant<By_contours, By_generators, By_flow_lines, By_distance, By_tree_cotree,
                                By_removing_faces, By_own_method>;

namespace internal {

// Whether a method begins at a vertex that one may name, its `source`.
template <class Method, class = void> struct Has_source : std::false_type
{};
template <class Method> struct Has_source<Method, std::void_t<decltype(Method::source)>> : std::true_type
{};

} // namespace internal

/// \ingroup PkgMeridianCut
/// \param method the method
/// \returns whether it cuts edges alone: it has no field, no meridians and no links
inline bool cuts_edges(const Cut_method& method)
{
  return std::visit([](const auto& m) { return m.cuts_edges; }, method);
}

/// \ingroup PkgMeridianCut
/// \param method the method
/// \returns whether its curves can be moved onto edges one by one
inline bool moves_onto_edges(const Cut_method& method)
{
  return std::visit([](const auto& m) { return m.moves_onto_edges; }, method);
}

/// \ingroup PkgMeridianCut
/// \param method the method
/// \returns the weights that it solves its field with; those of `Harmonic_field` where it has none
Weights weights_of(const Cut_method& method);

} // namespace meridian

#endif // MERIDIAN_CUT_CUT_METHOD_H
