// Measures generators. `measure_generators stability`: how far they move when a surface is sampled, numbered or
// disturbed otherwise. `measure_generators lengths MESH...`: their lengths beside those of other constructions on the
// same mesh.
#include "files/read_mesh.h"
#include "support/implicit_surfaces.h"

#include <meridian/base/vectors.h>
#include <meridian/handles/Generators.h>
#include <meridian/handles/find_generators.h>
#include <meridian/handles/find_shortest_basis.h>
#include <meridian/proof/verify_generators.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/examine_surface.h>

#include <cstdio>
#include <cstring>
#include <queue>
#include <set>

using namespace meridian;

namespace {

// The mean distance of a curve from the nearest of some others.
double away(const Refined_surface& s, const std::vector<Index>& curve, const Refined_surface& other,
            const std::vector<const std::vector<Index>*>& curves)
{
  double best = 1e300;
  for (const auto* c : curves)
  {
    double sum = 0;
    for (Index v : curve)
    {
      double nearest = 1e300;
      for (std::size_t i = 0; i < c->size(); ++i)
      {
        const Point a = other.points[(*c)[i]], ab = other.points[(*c)[(i + 1) % c->size()]] - a, av = s.points[v] - a;
        const double t = dot(ab, ab) > 0 ? std::min(std::max(dot(av, ab) / dot(ab, ab), 0.), 1.) : 0;
        nearest = std::min(nearest, distance(s.points[v], a + t * ab));
      }
      sum += nearest;
    }
    best = std::min(best, sum / static_cast<double>(curve.size()));
  }
  return best;
}

int measure_stability()
{
  const Triangle_surface s = sample::bitorus_with_tiny_handle(96);
  double edge = 0;
  for (Index h = 0; h < s.number_of_halfedges(); ++h) { edge += s.length(h) / s.number_of_halfedges(); }
  const Generators first = find_generators(s);
  std::vector<const std::vector<Index>*> meridians, longitudes;
  for (const auto& pair : first.pairs)
  {
    meridians.push_back(&pair.meridian.vertices);
    longitudes.push_back(&pair.longitude.vertices);
  }
  const double size = std::sqrt(area(s));
  std::printf("bi-torus with a tiny handle, %d faces, square root of the area %.3f, mean edge %.4f\n\n",
              s.number_of_faces(), size, edge);
  std::printf("| surface | faces | length of all pairs | change | meridians move | longitudes move | shortest pair | "
              "verified |\n|---|---|---|---|---|---|---|---|\n");
  int bad = 0;
  const auto row = [&](const char* name, const Triangle_surface& t) {
    const Generators g = find_generators(t);
    double m = 0, l = 0, shortest = 1e300;
    for (const auto& pair : g.pairs)
    {
      m = std::max(m, away(g.surface, pair.meridian.vertices, first.surface, meridians));
      l = std::max(l, away(g.surface, pair.longitude.vertices, first.surface, longitudes));
      shortest = std::min(shortest, pair.meridian.length + pair.longitude.length);
    }
    const bool good = verify_generators(t, g) && g.genus == first.genus;
    bad += !good;
    std::printf("| %s | %d | %.4f | %+.1f %% | %.2f %% | %.2f %% | %.3f | %s |\n", name, t.number_of_faces(),
                total_length(g), 100 * (total_length(g) / total_length(first) - 1), 100 * m / size, 100 * l / size,
                shortest, good ? "yes" : "NO");
  };
  row("as it is", s);
  row("subdivided", sample::subdivided(s));
  row("noise of a tenth of an edge", sample::noisy(s, 0.1 * edge, 1));
  row("renumbered", sample::renumbered(s, 1));
  row("coarser", sample::bitorus_with_tiny_handle(72));
  row("mirrored", sample::mirrored(s));
  row("irregular sampling", sample::bitorus_with_tiny_handle(96, true));
  return bad;
}

// A tree of shortest paths: for each node its distance and the step before it, an edge's number and a node.
struct Tree
{
  std::vector<double> distance;
  std::vector<std::pair<Index, Index>> before;
};
template <class Neighbors> Tree shortest_paths(Index nodes, Index root, const Neighbors& for_each_neighbor)
{
  Tree tree{std::vector<double>(nodes, 1e300), std::vector<std::pair<Index, Index>>(nodes, {-1, -1})};
  std::priority_queue<std::pair<double, Index>, std::vector<std::pair<double, Index>>,
                      std::greater<std::pair<double, Index>>>
    queue;
  tree.distance[root] = 0;
  queue.emplace(0., root);
  while (!queue.empty())
  {
    const double d = queue.top().first;
    const Index a = queue.top().second;
    queue.pop();
    if (d > tree.distance[a]) { continue; }
    for_each_neighbor(a, [&](Index b, Index edge, double length) {
      if (!(d + length < tree.distance[b])) { return; }
      tree.distance[b] = d + length;
      tree.before[b] = {edge, a};
      queue.emplace(d + length, b);
    });
  }
  return tree;
}

// The length of the loop of an edge between two nodes of a tree, without the way to the root that both share.
double loop_length(const Tree& tree, Index a, Index b, double edge)
{
  std::set<Index> above;
  for (Index c = a; c >= 0; c = tree.before[c].second) { above.insert(c); }
  Index meet = b;
  while (!above.count(meet)) { meet = tree.before[meet].second; }
  return edge + tree.distance[a] + tree.distance[b] - 2 * tree.distance[meet];
}

// Pairs of a tree and a cotree (Eppstein 2003): shortest paths through faces, between the middles of their edges, and
// among the edges that these do not cross shortest paths of vertices; each edge in neither gives two loops. The best of
// several roots.
double tree_cotree_pairs(const Triangle_surface& s)
{
  const Closed_model g = make_closed_model(s);
  const auto centre = [&](Index f) {
    return (1. / 3) * (s.points[s.triangles[f][0]] + s.points[s.triangles[f][1]] + s.points[s.triangles[f][2]]);
  };
  const auto step = [&](Index h) {
    const Point middle = s.point_on(h, 0.5);
    return distance(centre(s.face(h)), middle) + distance(middle, centre(s.face(s.opposite[h])));
  };
  double best = 1e300;
  for (int i = 0; i < 8; ++i)
  {
    const Index base = static_cast<Index>(static_cast<std::int64_t>(s.number_of_faces()) * i / 8);
    const Tree dual = shortest_paths(s.number_of_faces(), base, [&](Index f, const auto& reach) {
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        if (s.opposite[h] >= 0) { reach(s.face(s.opposite[h]), s.edge(h), step(h)); }
      }
    });
    std::vector<char> is_crossed(s.number_of_halfedges(), 0);
    for (const auto& [edge, f] : dual.before)
    {
      if (edge >= 0) { is_crossed[edge] = 1; }
    }
    const Tree tree = shortest_paths(g.number_of_nodes, g.node[s.triangles[base][0]], [&](Index a, const auto& reach) {
      for (Index k = g.begin[a]; k < g.begin[a + 1]; ++k)
        if (!is_crossed[s.edge(g.halfedge[k])])
        {
          reach(g.neighbor[k], s.edge(g.halfedge[k]), s.length(g.halfedge[k]));
        }
    });
    for (const auto& [edge, a] : tree.before)
    {
      if (edge >= 0) { is_crossed[edge] = 1; }
    }
    double sum = 0;
    for (Index h = 0; h < s.number_of_halfedges(); ++h)
      if (s.opposite[h] > h && !is_crossed[s.edge(h)])
        sum += loop_length(dual, s.face(h), s.face(s.opposite[h]), step(h))
               + loop_length(tree, g.node[s.source(h)], g.node[s.target(h)], s.length(h));
    best = std::min(best, sum);
  }
  return best;
}

int measure_lengths(int count, char** meshes)
{
  std::printf("| mesh | genus | pairs | flow and arc, not tightened | tree and cotree | shortest basis "
              "|\n|---|---|---|---|---|---|\n");
  int bad = 0;
  for (int i = 0; i < count; ++i)
  {
    const Examination e = examine_surface(files::read_mesh(meshes[i]), true);
    double pairs = 0, loose = 0, trees = 0, basis = 0;
    int genus = 0;
    for (const auto& c : e.components)
    {
      if (c.genus() == 0) { continue; }
      genus += c.genus();
      Generator_options options;
      options.tighten = false;
      const Generators g = find_generators(c.surface);
      const Homology_basis b = find_shortest_basis(c.surface);
      bad += !verify_generators(c.surface, g) + !verify_generators(c.surface, b);
      pairs += c.unit * total_length(g);
      loose += c.unit * total_length(find_generators(c.surface, options));
      for (const auto& loop : b.loops) { basis += c.unit * loop.length; }
      trees += c.unit * tree_cotree_pairs(c.surface);
    }
    const char* name = std::strrchr(meshes[i], '/') ? std::strrchr(meshes[i], '/') + 1 : meshes[i];
    std::printf("| %s | %d | %.5g | %.5g | %.5g | %.5g |\n", name, genus, pairs, loose, trees, basis);
    std::fflush(stdout);
  }
  return bad;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc > 2 && std::strcmp(argv[1], "lengths") == 0) { return measure_lengths(argc - 2, argv + 2); }
  if (argc > 1 && std::strcmp(argv[1], "stability") == 0) { return measure_stability(); }
  std::fprintf(stderr, "measure_generators stability | lengths MESH...\n");
  return 64;
}
