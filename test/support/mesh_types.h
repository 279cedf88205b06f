// The kinds of meshes that tests of the rim are compiled for, one at a time: all at once take more memory than a
// compiler should.
#ifndef MERIDIAN_TEST_MESH_TYPES_H
#define MERIDIAN_TEST_MESH_TYPES_H

#include <meridian/mesh/internal/convert.h>
#include <meridian/surface/Triangle_surface.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>

#ifdef MERIDIAN_HAS_OPENMESH
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#endif
#ifdef MERIDIAN_ARCHETYPE
#include "support/Archetype_mesh.h"
#endif
#ifdef MERIDIAN_LINEAR_CELL_COMPLEX
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#endif

#include <boost/mpl/list.hpp>
#include <boost/property_map/property_map.hpp>

#include <map>
#include <memory>
#include <set>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
#ifdef MERIDIAN_HAS_OPENMESH
struct In_double : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
};
using Mesh_types = boost::mpl::list<OpenMesh::PolyMesh_ArrayKernelT<In_double>>;
#elif defined(MERIDIAN_ARCHETYPE)
using Mesh_types = boost::mpl::list<archetype::Mesh>;
#elif defined(MERIDIAN_LINEAR_CELL_COMPLEX)
using Complex_traits = CGAL::Linear_cell_complex_traits<3, Kernel>;
using Mesh_types =
  boost::mpl::list<CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, Complex_traits>::type>;
#elif defined(MERIDIAN_POLYHEDRON)
using Mesh_types = boost::mpl::list<CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_3>>;
#else
#define MERIDIAN_SURFACE_MESH
using Mesh_types = boost::mpl::list<Mesh>;
#endif

template <class TriangleMesh> constexpr double precision = 1e-12; // of points that are written
#ifdef MERIDIAN_HAS_OPENMESH
template <>
inline constexpr double precision<OpenMesh::PolyMesh_ArrayKernelT<In_double>> = 1e-6; // CGAL rounds to float there
#endif

template <class TriangleMesh> TriangleMesh build_mesh(const meridian::Triangle_surface& s)
{
  TriangleMesh tm;
  meridian::internal::build(s.points, s.triangles, tm);
  return tm;
}

// A property map of edges that anyone can make, kept by halfedges: an edge of a cell complex is less than itself,
// seen from the other side.
template <class TriangleMesh> class Edge_marks
{
public:
  using Edge = typename boost::graph_traits<TriangleMesh>::edge_descriptor;
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using key_type = Edge;
  using value_type = bool;
  using reference = bool;
  using category = boost::read_write_property_map_tag;

  explicit Edge_marks(const TriangleMesh& tm) : m_mesh(&tm), m_marks(std::make_shared<std::map<Halfedge, bool>>()) {}
  friend void put(const Edge_marks& map, Edge e, bool mark) { (*map.m_marks)[map.side(e)] = mark; }
  friend bool get(const Edge_marks& map, Edge e) { return map.m_marks->at(map.side(e)); }
  std::size_t size() const { return m_marks->size(); }
  // One halfedge of each edge that is marked.
  std::set<Halfedge> marked() const
  {
    std::set<Halfedge> sides;
    for (const auto& [h, mark] : *m_marks)
    {
      if (mark) { sides.insert(h); }
    }
    return sides;
  }
  Halfedge side(Edge e) const
  {
    const Halfedge h = halfedge(e, *m_mesh), o = opposite(h, *m_mesh);
    return o < h ? o : h;
  }

private:
  const TriangleMesh* m_mesh;
  std::shared_ptr<std::map<Halfedge, bool>> m_marks;
};

#endif // MERIDIAN_TEST_MESH_TYPES_H
