// The weakest mesh that the functions on meshes take: what CGAL's concepts ask for and nothing else. Descriptors can be
// compared and copied; there are no indices, no hash, no internal property maps but that of points, and no copies.
#ifndef MERIDIAN_TEST_ARCHETYPE_MESH_H
#define MERIDIAN_TEST_ARCHETYPE_MESH_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <deque>
#include <functional>
#include <utility>
#include <vector>

namespace archetype {

// A handle of one kind, known by the address of what it stands for.
template <class Item> class Handle
{
public:
  Handle() = default;
  bool operator==(const Handle& other) const { return m_item == other.m_item; }
  bool operator!=(const Handle& other) const { return m_item != other.m_item; }
  bool operator<(const Handle& other) const { return std::less<const Item*>()(m_item, other.m_item); }

private:
  friend class Mesh;
  explicit Handle(Item* item) : m_item(item) {}
  Item* m_item = nullptr;
};

struct Vertex_item;
struct Halfedge_item;
struct Face_item;
using Vertex = Handle<Vertex_item>;
using Halfedge = Handle<Halfedge_item>;
using Face = Handle<Face_item>;
using Kernel = CGAL::Simple_cartesian<double>;

// An edge, seen from one of its sides, as CGAL's `is_valid_halfedge_graph()` wants it; both are the same edge.
class Edge
{
public:
  Edge() = default;
  bool operator==(const Edge& other) const { return m_first == other.m_first; }
  bool operator!=(const Edge& other) const { return m_first != other.m_first; }
  bool operator<(const Edge& other) const { return m_first < other.m_first; }

private:
  friend class Mesh;
  Edge(Halfedge side, Halfedge first) : m_side(side), m_first(first) {}
  Halfedge m_side, m_first;
};

struct Vertex_item
{
  Halfedge halfedge;
  Kernel::Point_3 point;
};
struct Halfedge_item
{
  Halfedge next, prev, opposite;
  Vertex target;
  Face face;
};
struct Face_item
{
  Halfedge halfedge;
};

class Mesh
{
public:
  Mesh() = default;
  Mesh(const Mesh&) = delete;
  Mesh& operator=(const Mesh&) = delete;
  Mesh(Mesh&&) = default;

  Halfedge next(Halfedge h) const { return h.m_item->next; }
  Halfedge prev(Halfedge h) const { return h.m_item->prev; }
  Halfedge opposite(Halfedge h) const { return h.m_item->opposite; }
  Vertex target(Halfedge h) const { return h.m_item->target; }
  Face face(Halfedge h) const { return h.m_item->face; }
  Edge edge(Halfedge h) const { return {h, std::min(h, h.m_item->opposite)}; }
  Halfedge halfedge(Vertex v) const { return v.m_item->halfedge; }
  Halfedge halfedge(Edge e) const { return e.m_side; }
  Halfedge halfedge(Face f) const { return f.m_item->halfedge; }
  Kernel::Point_3& point(Vertex v) const { return v.m_item->point; }

  void set_next(Halfedge h, Halfedge next)
  {
    h.m_item->next = next;
    next.m_item->prev = h;
  }
  void set_target(Halfedge h, Vertex v) { h.m_item->target = v; }
  void set_face(Halfedge h, Face f) { h.m_item->face = f; }
  void set_halfedge(Vertex v, Halfedge h) { v.m_item->halfedge = h; }
  void set_halfedge(Face f, Halfedge h) { f.m_item->halfedge = h; }

  Vertex add_vertex() { return add(m_vertex_items, vertices); }
  Face add_face() { return add(m_face_items, faces); }
  Edge add_edge()
  {
    const Halfedge h = add(m_halfedge_items, halfedges), o = add(m_halfedge_items, halfedges);
    h.m_item->opposite = o;
    o.m_item->opposite = h;
    edges.push_back(edge(h));
    return edges.back();
  }

  std::vector<Vertex> vertices;
  std::vector<Halfedge> halfedges;
  std::vector<Edge> edges;
  std::vector<Face> faces;

private:
  template <class Item> Handle<Item> add(std::deque<Item>& items, std::vector<Handle<Item>>& handles)
  {
    items.emplace_back();
    handles.push_back(Handle<Item>(&items.back()));
    return handles.back();
  }

  std::deque<Vertex_item> m_vertex_items;
  std::deque<Halfedge_item> m_halfedge_items;
  std::deque<Face_item> m_face_items;
};

// The functions of HalfedgeGraph and FaceGraph.
inline Halfedge next(Halfedge h, const Mesh& m) { return m.next(h); }
inline Halfedge prev(Halfedge h, const Mesh& m) { return m.prev(h); }
inline Halfedge opposite(Halfedge h, const Mesh& m) { return m.opposite(h); }
inline Vertex target(Halfedge h, const Mesh& m) { return m.target(h); }
inline Vertex source(Halfedge h, const Mesh& m) { return m.target(m.opposite(h)); }
inline Vertex target(Edge e, const Mesh& m) { return m.target(m.halfedge(e)); }
inline Vertex source(Edge e, const Mesh& m) { return source(m.halfedge(e), m); }
inline Edge edge(Halfedge h, const Mesh& m) { return m.edge(h); }
inline Face face(Halfedge h, const Mesh& m) { return m.face(h); }
inline Halfedge halfedge(Vertex v, const Mesh& m) { return m.halfedge(v); }
inline Halfedge halfedge(Edge e, const Mesh& m) { return m.halfedge(e); }
inline Halfedge halfedge(Face f, const Mesh& m) { return m.halfedge(f); }
inline std::pair<Halfedge, bool> halfedge(Vertex u, Vertex v, const Mesh& m)
{
  const Halfedge first = m.halfedge(v);
  if (first == Halfedge()) { return {first, false}; }
  Halfedge h = first;
  do {
    if (source(h, m) == u) { return {h, true}; }
    h = m.opposite(m.next(h));
  } while (h != first);
  return {Halfedge(), false};
}

// The ranges of VertexListGraph, HalfedgeListGraph, EdgeListGraph and FaceListGraph.
template <class T> using Range = CGAL::Iterator_range<typename std::vector<T>::const_iterator>;
inline Range<Vertex> vertices(const Mesh& m) { return {m.vertices.begin(), m.vertices.end()}; }
inline Range<Halfedge> halfedges(const Mesh& m) { return {m.halfedges.begin(), m.halfedges.end()}; }
inline Range<Edge> edges(const Mesh& m) { return {m.edges.begin(), m.edges.end()}; }
inline Range<Face> faces(const Mesh& m) { return {m.faces.begin(), m.faces.end()}; }
inline std::size_t num_vertices(const Mesh& m) { return m.vertices.size(); }
inline std::size_t num_halfedges(const Mesh& m) { return m.halfedges.size(); }
inline std::size_t num_edges(const Mesh& m) { return m.edges.size(); }
inline std::size_t num_faces(const Mesh& m) { return m.faces.size(); }

// The functions of MutableFaceGraph that add and change. Nothing is ever removed.
inline Vertex add_vertex(Mesh& m) { return m.add_vertex(); }
inline Edge add_edge(Mesh& m) { return m.add_edge(); }
inline Face add_face(Mesh& m) { return m.add_face(); }
inline void set_next(Halfedge h, Halfedge next, Mesh& m) { m.set_next(h, next); }
inline void set_target(Halfedge h, Vertex v, Mesh& m) { m.set_target(h, v); }
inline void set_face(Halfedge h, Face f, Mesh& m) { m.set_face(h, f); }
inline void set_halfedge(Vertex v, Halfedge h, Mesh& m) { m.set_halfedge(v, h); }
inline void set_halfedge(Face f, Halfedge h, Mesh& m) { m.set_halfedge(f, h); }

// Its points.
struct Point_map
{
  using key_type = Vertex;
  using value_type = Kernel::Point_3;
  using reference = const Kernel::Point_3&;
  using category = boost::read_write_property_map_tag;
  const Mesh* mesh = nullptr;
  friend reference get(const Point_map& map, Vertex v) { return map.mesh->point(v); }
  friend void put(const Point_map& map, Vertex v, const value_type& p) { map.mesh->point(v) = p; }
};
inline Point_map get(CGAL::vertex_point_t, const Mesh& m) { return {&m}; }
inline Kernel::Point_3 get(CGAL::vertex_point_t, const Mesh& m, Vertex v) { return m.point(v); }
inline void put(CGAL::vertex_point_t, Mesh& m, Vertex v, const Kernel::Point_3& p) { m.point(v) = p; }

} // namespace archetype

namespace boost {

template <> struct graph_traits<archetype::Mesh>
{
  struct traversal_category : vertex_list_graph_tag, edge_list_graph_tag
  {};
  using directed_category = undirected_tag;
  using edge_parallel_category = disallow_parallel_edge_tag;
  using vertex_descriptor = archetype::Vertex;
  using halfedge_descriptor = archetype::Halfedge;
  using edge_descriptor = archetype::Edge;
  using face_descriptor = archetype::Face;
  using vertex_iterator = std::vector<vertex_descriptor>::const_iterator;
  using halfedge_iterator = std::vector<halfedge_descriptor>::const_iterator;
  using edge_iterator = std::vector<edge_descriptor>::const_iterator;
  using face_iterator = std::vector<face_descriptor>::const_iterator;
  using degree_size_type = std::size_t;
  using vertices_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using halfedges_size_type = std::size_t;
  using faces_size_type = std::size_t;
  static vertex_descriptor null_vertex() { return {}; }
  static halfedge_descriptor null_halfedge() { return {}; }
  static face_descriptor null_face() { return {}; }
};
template <> struct graph_traits<const archetype::Mesh> : graph_traits<archetype::Mesh>
{};
template <> struct property_map<archetype::Mesh, CGAL::vertex_point_t>
{
  using type = archetype::Point_map;
  using const_type = archetype::Point_map;
};

} // namespace boost

namespace CGAL {

template <> struct graph_has_property<archetype::Mesh, CGAL::vertex_point_t> : CGAL::Tag_true
{};

} // namespace CGAL

#endif // MERIDIAN_TEST_ARCHETYPE_MESH_H
