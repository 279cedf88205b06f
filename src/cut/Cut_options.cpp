// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/Cut_options.h>

#include <meridian/base/exceptions.h>
#include <meridian/surface/check_surface.h>

#include <string>

namespace meridian {

namespace {

void forbid(bool is_wrong, const std::string& message)
{
  if (is_wrong) { throw Invalid_input_error(message); }
}

bool has_from(Cut_method method) { return method == Cut_method::GEODESIC || method == Cut_method::TREE_COTREE; }

} // namespace

void check(const Cut_options& o)
{
  const bool is_of_edges = cuts_edges(o.method), has_values = !o.values.empty();
  const std::string method = std::string("method ") + name_of(o.method);
  forbid(o.join != Generator_join::SURFACE && o.method != Cut_method::GENERATORS,
         "a way to join pairs goes with method generators; " + method + " has no pairs");
  forbid(o.link_domain == Link_domain::PLANE && (o.links.bifurcations || o.on_edges),
         "links through the plane go without bifurcations, and not on edges alone");
  forbid(o.refine_where_needed && !o.on_edges, "edges are divided where needed only if edges alone are cut");
  forbid(o.refine_where_needed && o.tightening == Tightening::GRAPH,
         "edges are divided where needed only if the whole graph is not tightened");
  forbid((is_of_edges || o.method == Cut_method::GEODESIC) && has_values,
         method + " has a field of its own or none; leave out the values");
  forbid(o.source >= 0 && !has_from(o.method),
         "a vertex to begin at goes with method geodesic or tree-cotree, not with " + method);
  forbid(is_of_edges
           && (!o.minima.empty() || !o.maxima.empty() || o.links.source >= 0 || o.links.bifurcations
               || o.weights != Weights::POSITIVE || o.levels != Levels::SADDLE),
         "methods that cut edges have no field, no meridians and no links; " + method + " is one of them");
  forbid(o.links.source >= 0 && o.tightening == Tightening::GRAPH,
         "links pass through a vertex only if the whole graph is not tightened, which would move them away from it");
  forbid(o.links.source >= 0 && o.on_edges && (o.method == Cut_method::GENERATORS || o.method == Cut_method::MORSE),
         "links pass through a vertex only if not edges alone are cut with " + method);
  forbid(o.bases < 1, std::to_string(o.bases) + " base points were asked for; one is the least");
}

void check(const Triangle_surface& s, const Cut_options& options)
{
  check(options);
  check_surface(s);
  check(s, static_cast<const Field_options&>(options));
  if (options.source != -1) { check_vertices(s, {options.source}, "the vertex to begin at"); }
  if (options.links.source != -1) { check_vertices(s, {options.links.source}, "the vertex for links to pass through"); }
}

Cut_options with_method(Cut_options o, Cut_method method)
{
  o.method = method;
  if (method != Cut_method::GENERATORS) { o.join = Generator_join::SURFACE; }
  if (!has_from(method)) { o.source = -1; }
  if (cuts_edges(method) || method == Cut_method::GEODESIC) { o.values.clear(); }
  if (o.on_edges && (method == Cut_method::GENERATORS || method == Cut_method::MORSE)) { o.links.source = -1; }
  if (cuts_edges(method))
  {
    o.minima.clear();
    o.maxima.clear();
    o.links = Link_options();
    o.weights = Weights::POSITIVE;
    o.levels = Levels::SADDLE;
  }
  return o;
}

} // namespace meridian
