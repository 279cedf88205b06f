// What CGAL's Surface_mesh_topology says of the generators: none is contractible, and the two of a pair are not freely
// homotopic.
#include "support/sample_surfaces.h"

#include "files/read_mesh.h"

#include <meridian/base/vectors.h>
#include <meridian/handles/Generators.h>
#include <meridian/handles/find_generators.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/examine_surface.h>

#include <CGAL/Curves_on_surface_topology.h>
#include <CGAL/Path_on_surface.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>

using namespace meridian;

namespace {

int failures = 0;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

void ask(const std::string& name, const Triangle_surface& s)
{
  const Generators g = find_generators(s);
  Mesh mesh;
  for (const Point& p : g.surface.points) { mesh.add_vertex({p[0], p[1], p[2]}); }
  using Vertex = Mesh::Vertex_index;
  for (const auto& t : g.surface.triangles) { mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2])); }
  CGAL::Surface_mesh_topology::Curves_on_surface_topology<Mesh> topology(mesh);
  const auto path = [&](const std::vector<Index>& loop) {
    CGAL::Surface_mesh_topology::Path_on_surface<Mesh> p(mesh);
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      p.push_back(mesh.halfedge(Vertex(loop[i]), Vertex(loop[(i + 1) % loop.size()])));
    }
    return p;
  };
  int contractible = 0, homotopic = 0;
  for (const auto& pair : g.pairs)
  {
    const auto meridian = path(pair.meridian.vertices), longitude = path(pair.longitude.vertices);
    contractible += topology.is_contractible(meridian) + topology.is_contractible(longitude);
    homotopic += topology.are_freely_homotopic(meridian, longitude);
  }
  std::cout << name << ": " << g.pairs.size() << " pairs, " << contractible << " contractible curves, " << homotopic
            << " homotopic pairs\n";
  failures += contractible + homotopic > 0;
}

} // namespace

int main()
{
  ask("torus", sample::torus(20, 12));
  ask("plate of genus 4", sample::plate(4, 3));
  ask("dumbbell", sample::dumbbell(12));
  int meshes = 0;
  if (const char* corpus = std::getenv("MERIDIAN_CORPUS"); corpus && *corpus)
    for (const char* file : {"eight.off", "anchor.off", "couplingdown.off", "turbine.off.gz", "5Torus.obj.gz",
                             "eiffel_tower.obj.gz", "shrec07_105.off.gz", "casting.off.gz", "botijo.off.gz",
                             "fertility_input.off.gz", "kitten.obj.gz", "buddha_half.obj.gz", "soccerball.obj.gz"})
    {
      const Examination e = examine_surface(files::read_mesh((std::filesystem::path(corpus) / file).string()));
      ask(file, e.components.front().surface);
      ++meshes;
    }
  std::cout << meshes << " meshes of the corpus, " << failures << " failures\n";
  return failures == 0 ? 0 : 1;
}
