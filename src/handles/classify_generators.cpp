// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/handles/classify_generators.h>

#include <meridian/base/Stage_runner.h>
#include <meridian/base/vectors.h>
#include <meridian/handles/internal/linking.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <future>
#include <utility>
#include <vector>

namespace meridian {

bool does_self_intersect(const Triangle_surface& s)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  mesh.reserve(s.points.size(), 3 * s.triangles.size() / 2, s.triangles.size());
  using Vertex = CGAL::Surface_mesh<Kernel::Point_3>::Vertex_index;
  for (const Point& p : s.points) { mesh.add_vertex({p[0], p[1], p[2]}); }
  for (const auto& t : s.triangles)
  {
    if (CGAL::collinear(mesh.point(Vertex(t[0])), mesh.point(Vertex(t[1])), mesh.point(Vertex(t[2])))) { return true; }
    // two edges with the same ends
    if (!mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2])).is_valid()) { return true; }
  }
  return CGAL::Polygon_mesh_processing::does_self_intersect(mesh);
}

namespace {

Loop_class class_of(const internal::Sides& s)
{
  return s.inside ? Loop_class::HANDLE : s.outside ? Loop_class::TUNNEL : Loop_class::NEITHER;
}

std::future<bool> begin_search(const Triangle_surface& root)
{
  return std::async(std::launch::async, [&root] { return does_self_intersect(root); });
}

std::vector<Loop_class> classify(const Triangle_surface& root, const std::vector<std::vector<Index>>& walks,
                                 std::future<bool> meets_itself)
{
  std::vector<Loop_class> classes(walks.size(), Loop_class::UNKNOWN);
  const std::vector<internal::Sides> sides = internal::find_bounding_sides(root, walks);
  if (meets_itself.get() || sides.empty()) { return classes; }
  std::transform(sides.begin(), sides.end(), classes.begin(), class_of);
  return classes;
}

} // namespace

std::vector<Loop_class> classify_loops(const Triangle_surface& root, const std::vector<std::vector<Index>>& walks)
{
  if (walks.empty() || !boundary_loops(root).empty())
  {
    return std::vector<Loop_class>(walks.size(), Loop_class::UNKNOWN);
  }
  return classify(root, walks, begin_search(root));
}

void classify_generators(const Triangle_surface& root, Generators& generators, Progress_observer* observer)
{
  if (generators.pairs.empty() || generators.boundary_loops > 0) { return; }
  classify_generators(root, generators, begin_search(root), observer);
}

void classify_generators(const Triangle_surface& root, Generators& generators, std::future<bool> meets_itself,
                         Progress_observer* observer)
{
  if (generators.pairs.empty() || generators.boundary_loops > 0) { return; }
  const Stage_runner run{observer, generators.seconds};
  run(Stage::CLASSIFY, [&] {
    std::vector<Generator_curve*> curves;
    std::vector<std::vector<Index>> walks;
    for (Generator_pair& pair : generators.pairs)
      for (Generator_curve* c : {&pair.meridian, &pair.longitude})
      {
        curves.push_back(c);
        walks.push_back(internal::walk_on_root(root, generators.surface, c->vertices));
      }
    const std::vector<Loop_class> classes = classify(root, walks, std::move(meets_itself));
    for (std::size_t i = 0; i < curves.size(); ++i) { curves[i]->loop_class = classes[i]; }
  });
}

} // namespace meridian
