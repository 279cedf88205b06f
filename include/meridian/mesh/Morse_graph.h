// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_MORSE_GRAPH_H
#define MERIDIAN_MESH_MORSE_GRAPH_H

#include <meridian/field/critical_points.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graph_traits.hpp>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianFaceGraph
/// a vertex of a Morse-Smale complex.
template <class TriangleMesh> struct Morse_vertex
{
  /// of the mesh; of a saddle that was divided into simple ones, the nearest
  typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex{};
  Critical_kind kind = Critical_kind::SADDLE; ///< minimum, saddle or maximum
};

/// \ingroup PkgMeridianFaceGraph
/// a flow line from a saddle to a critical point.
template <class TriangleMesh> struct Morse_edge
{
  /// of the mesh
  using Point = typename boost::property_traits<
    typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type>::value_type;
  std::vector<Point> points; ///< from the saddle on
  double length = 0;         ///< in the unit of the points
  bool descends = true;      ///< whether it goes down from the saddle
};

/// \ingroup PkgMeridianFaceGraph
/// the quasi Morse-Smale complex of a field, as a graph that Boost's algorithms take. Its properties are bundled:
/// `graph[v].vertex`, `graph[e].points`.
template <class TriangleMesh>
using Morse_graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Morse_vertex<TriangleMesh>,
                                          Morse_edge<TriangleMesh>>;

} // namespace meridian

#endif // MERIDIAN_MESH_MORSE_GRAPH_H
