// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_CUT_TRAITS_H
#define MERIDIAN_CUT_CUT_TRAITS_H

#include <meridian/base/vectors.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/handles/preference.h>
#include <meridian/surface/Triangle_surface.h>

#include <type_traits>
#include <utility>
#include <variant>

namespace meridian {

/// \ingroup PkgMeridianCut
/// the model of `CutTraits` that the library uses where no other is given.
struct Default_cut_traits
{
  /// \param loop a loop and its saddle
  /// \returns its rate: `preference::gaussian_curvature()`
  double preference(const Loop_candidate& loop) const { return preference::gaussian_curvature(loop); }
  /// \param s the surface
  /// \param halfedge one of its halfedges
  /// \returns the length of the edge
  double edge_length(const Triangle_surface& s, Index halfedge) const { return s.length(halfedge); }
  /// \param low, high the field at the ends of an edge
  /// \param level a value between them
  /// \returns where it lies, linearly
  double crossing(double low, double high, double level) const { return (level - low) / (high - low); }
};

/// \ingroup PkgMeridianCut
/// \tparam Traits a model of `CutTraits`
/// \param options choices
/// \param traits what the method of these shall use, as far as it asks: for loops, for ways along edges, for crossings
/// \returns the choices with these
template <class Traits> Cut_options with_traits(Cut_options options, const Traits& traits)
{
  std::visit(
    [&](auto& method) {
      using Method = std::decay_t<decltype(method)>;
      if constexpr (std::is_base_of_v<Meridian_options, Method>)
      {
        method.preference = nullptr;
        if constexpr (!std::is_same_v<Traits, Default_cut_traits>) // its preference is the default
        {
          method.preference = [traits](const Loop_candidate& loop) { return traits.preference(loop); };
        }
        method.placement = [traits](double low, double high, double level) {
          return traits.crossing(low, high, level);
        };
      }
      if constexpr (std::is_same_v<By_tree_cotree, Method>)
      {
        method.metric = [traits](const Triangle_surface& s, Index h) { return traits.edge_length(s, h); };
      }
    },
    options.method);
  return options;
}

} // namespace meridian

#endif // MERIDIAN_CUT_CUT_TRAITS_H
