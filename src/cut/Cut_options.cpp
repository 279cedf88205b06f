// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/Cut_options.h>

#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/field/Field.h>
#include <meridian/handles/preference.h>
#include <meridian/surface/check_surface.h>

#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace meridian {

namespace {

void forbid(bool is_wrong, const std::string& message)
{
  if (is_wrong) { throw Invalid_input_error(message); }
}

template <class Part, class From, class To> void carry_part(const From& from, To& to)
{
  if constexpr (std::is_base_of_v<Part, From> && std::is_base_of_v<Part, To>)
  {
    static_cast<Part&>(to) = static_cast<const Part&>(from);
  }
}

// Takes over what two methods have in common.
template <class From, class To> void carry(const From& from, To& to)
{
  if constexpr (std::is_same_v<From, To>) { to = from; }
  else
  {
    carry_part<Field_options>(from, to);
    carry_part<Chosen_extrema>(from, to);
    carry_part<Meridian_options>(from, to);
    if constexpr (internal::Has_source<From>::value && internal::Has_source<To>::value) { to.source = from.source; }
  }
}

} // namespace

Weights weights_of(const Cut_method& method)
{
  return std::visit(
    [](const auto& m) {
      if constexpr (std::is_base_of_v<Field_options, std::decay_t<decltype(m)>>) { return weights_of(m.field); }
      else { return Harmonic_field().weights; }
    },
    method);
}

Tightening tightening_of(const Cut_options& o)
{
  if (o.tightening) { return *o.tightening; }
  const auto* contours = std::get_if<By_contours>(&o.method);
  const bool is_free = contours && !contours->preference && contours->levels == Levels::SADDLE
                       && o.link_domain == Link_domain::SURFACE && !o.links.bifurcations && o.links.source < 0
                       && !o.refine_where_needed;
  return is_free ? Tightening::GRAPH : Tightening::CURVES;
}

void check(const Cut_options& o)
{
  const std::string method = "method " + name_of(o.method);
  forbid(o.link_domain == Link_domain::PLANE && (o.links.bifurcations || o.on_edges),
         "links through the plane go without bifurcations, and not on edges alone");
  forbid(o.refine_where_needed && !o.on_edges, "edges are divided where needed only if edges alone are cut");
  forbid(o.refine_where_needed && o.tightening == Tightening::GRAPH,
         "edges are divided where needed only if the whole graph is not tightened");
  forbid(cuts_edges(o.method) && (o.links.source >= 0 || o.links.bifurcations || o.link_domain == Link_domain::PLANE),
         "methods that cut edges have no field, no meridians and no links; " + method + " is one of them");
  forbid(o.links.source >= 0 && o.tightening == Tightening::GRAPH,
         "links pass through a vertex only if the whole graph is not tightened, which would move them away from it");
  forbid(o.links.source >= 0 && o.on_edges && !moves_onto_edges(o.method),
         "links pass through a vertex only if not edges alone are cut with " + method);
  std::visit([](const auto& m) { check(m); }, o.method);
}

void check(const Triangle_surface& s, const Cut_options& options)
{
  check(options);
  check_surface(s);
  std::visit([&](const auto& m) { check(s, m); }, options.method);
  if (options.links.source != -1) { check_vertices(s, {options.links.source}, "the vertex for links to pass through"); }
}

Cut_options with_method(Cut_options o, Cut_method method)
{
  std::visit([](const auto& from, auto& to) { carry(from, to); }, o.method, method);
  o.method = std::move(method);
  if (o.on_edges && !moves_onto_edges(o.method)) { o.links.source = -1; }
  if (cuts_edges(o.method))
  {
    o.links = Link_options();
    o.link_domain = Link_domain::SURFACE;
  }
  return o;
}

} // namespace meridian
