// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/internal/symmetric.h>

#include <meridian/base/Bounding_box.h>
#include <meridian/base/exceptions.h>
#include <meridian/map/distortion.h>
#include <meridian/map/planar_map.h>
#include <meridian/surface/open_along.h>
#include <meridian/surface/pieces.h>
#include <meridian/surface/seams.h>
#include <meridian/unwrap/internal/first_cut.h>
#include <meridian/unwrap/unwrap_surface.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace meridian {

namespace internal {

namespace {

// What is on one side of the plane. Its line joins faces to their images alone, so there are two sides.
Surface_piece half_of(const Triangle_surface& root, const Mirror& mirror)
{
  Refined_surface s(root);
  flag_seam(s, mirror.line);
  return pieces_of(surface_of(s, open_along(s))).front();
}

// The longest stretch of the plane's line along the border of a chart, as halfedges of the root, but no more than half
// of the border. `whole`: the halfedge of the root that each of the disc is.
template <class Whole>
std::vector<Index> longest_stretch(const Triangle_surface& disc, const std::vector<char>& is_line, const Whole& whole)
{
  std::vector<Index> best;
  double longest = 0;
  for (const auto& loop : boundary_loops(disc))
  {
    const std::size_t n = loop.size();
    double border = 0;
    for (Index h : loop) { border += disc.length(h); }
    std::size_t first = 0; // behind what is no line, if anything is not
    while (first < n && is_line[whole(loop[first])]) { ++first; }
    std::vector<Index> stretch;
    double length = 0;
    bool is_full = false;
    for (std::size_t i = 0; i < n; ++i)
    {
      const Index h = loop[(first + i) % n];
      if (!is_line[whole(h)])
      {
        stretch.clear();
        length = 0;
        is_full = false;
        continue;
      }
      is_full = is_full || length + disc.length(h) > border / 2;
      if (is_full) { continue; }
      length += disc.length(h);
      stretch.push_back(whole(h));
      if (length > longest)
      {
        longest = length;
        best = stretch;
      }
    }
  }
  return best;
}

// The seams of one half and their images, and the plane's line but for what joins the halves.
class Symmetric_seams
{
public:
  Symmetric_seams(const Triangle_surface& root, const Unwrap_options& options, const Mirror& mirror)
    : m_root(root), m_mirror(mirror), m_is_seam(root.number_of_halfedges(), 0), m_is_line(m_is_seam)
  {
    for (Index h : mirror.line) { m_is_line[h] = m_is_line[root.opposite[h]] = 1; }
    m_is_seam = m_is_line;
    add(half_of(root, mirror), options);
  }

  // All seams; if `is_joined`, without those along which halves can stay together.
  std::vector<Index> find(bool is_joined) const
  {
    std::vector<char> is_seam = m_is_seam;
    for (Index h : m_joints)
    {
      if (is_joined) { is_seam[h] = is_seam[m_root.opposite[h]] = 0; }
    }
    std::vector<Index> seams;
    for (Index h = 0; h < m_root.number_of_halfedges(); ++h)
    {
      if (is_seam[h] && h < m_root.opposite[h]) { seams.push_back(h); }
    }
    return seams;
  }

private:
  void add(const Surface_piece& piece, const Unwrap_options& options)
  {
    Unwrap_options o = options;
    o.is_symmetric = false;
    o.cut.on_edges = true;
    o.charts = options.charts > 1 ? (options.charts + 1) / 2 : options.charts;
    const Unwrapping half = unwrap_surface(piece.surface, o);
    const auto whole = [&](Index h) { return halfedge_of_whole(piece, h); };
    for (Index h = 0; h < half.cut.surface.number_of_halfedges(); ++h)
    {
      if (half.cut.surface.seam[h]) { add_seam(whole(h)); }
    }
    if (options.charts != 1) { return; }
    const std::vector<Index> joint = longest_stretch(half.disc, m_is_line, whole);
    m_joints.insert(m_joints.end(), joint.begin(), joint.end());
  }

  void add_seam(Index h)
  {
    for (Index g : {h, m_mirror.halfedge[h]}) { m_is_seam[g] = m_is_seam[m_root.opposite[g]] = 1; }
  }

  const Triangle_surface& m_root;
  const Mirror& m_mirror;
  std::vector<char> m_is_seam, m_is_line; // of each halfedge
  std::vector<Index> m_joints;
};

// The vertex of the disc that is the image of each; nothing if seams are not those of their images.
std::vector<Index> images_of(const Mirror& mirror, const Triangle_surface& disc)
{
  std::vector<Index> image(disc.number_of_vertices(), -1);
  if (disc.number_of_halfedges() != static_cast<Index>(mirror.halfedge.size())) { return {}; }
  for (Index h = 0; h < disc.number_of_halfedges(); ++h)
  {
    const Index v = disc.target(mirror.halfedge[h]); // its faces are those of the root, in their order
    Index& known = image[disc.source(h)];
    if (known >= 0 && known != v) { return {}; }
    known = v;
  }
  return image;
}

// Vertices of each chart.
std::vector<std::vector<Index>> vertices_of_charts(const Unwrapping& u)
{
  std::vector<std::vector<Index>> of_chart(u.charts);
  std::vector<char> is_known(u.disc.number_of_vertices(), 0);
  for (std::size_t f = 0; f < u.disc.triangles.size(); ++f)
    for (Index v : u.disc.triangles[f])
    {
      if (!std::exchange(is_known[v], 1)) { of_chart[u.chart_of.empty() ? 0 : u.chart_of[f]].push_back(v); }
    }
  return of_chart;
}

Bounding_box<Plane_point> box_of(const std::vector<Index>& vertices, const std::vector<Plane_point>& at)
{
  Bounding_box<Plane_point> box(at[vertices.front()]);
  for (Index v : vertices) { box.add(at[v]); }
  return box;
}

// Moves the points of a chart that is its own image to the middle between them and their reflected images, in the axis
// for which that is least.
void reflect_in_itself(const std::vector<Index>& vertices, const std::vector<Index>& image,
                       std::vector<Plane_point>& at)
{
  Plane_point mean{0, 0};
  for (Index v : vertices) { mean = mean + at[v]; }
  mean = (1. / static_cast<double>(vertices.size())) * mean;
  double along = 0, across = 0;
  for (Index v : vertices)
  {
    const Plane_point p = at[v] - mean, q = at[image[v]] - mean;
    along += p[0] * q[0] - p[1] * q[1];
    across += p[0] * q[1] + p[1] * q[0];
  }
  const double length = std::hypot(along, across), c = length > 0 ? along / length : 1,
               s = length > 0 ? across / length : 0;
  std::vector<Plane_point> middle;
  for (Index v : vertices)
  {
    const Plane_point q = at[image[v]] - mean;
    middle.push_back(0.5 * (at[v] + mean + Plane_point{c * q[0] + s * q[1], s * q[0] - c * q[1]}));
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) { at[vertices[i]] = middle[i]; }
}

bool is_simple_everywhere(const Triangle_surface& disc, const std::vector<Plane_point>& at)
{
  const auto loops = boundary_loops(disc);
  return std::all_of(loops.begin(), loops.end(), [&](const std::vector<Index>& halfedges) {
    std::vector<Index> loop;
    for (Index h : halfedges) { loop.push_back(disc.source(h)); }
    return is_roomy(loop, at);
  });
}

} // namespace

bool make_maps_symmetric(const Mirror& mirror, Unwrapping& u)
{
  const std::vector<Index> image = images_of(mirror, u.disc);
  if (image.empty()) { return false; }
  const auto of_chart = vertices_of_charts(u);
  std::vector<Index> chart_of(u.disc.number_of_vertices(), 0);
  for (std::size_t i = 0; i < of_chart.size(); ++i)
    for (Index v : of_chart[i]) { chart_of[v] = static_cast<Index>(i); }
  std::vector<Plane_point> at = u.map.at;
  for (std::size_t i = 0; i < of_chart.size(); ++i)
  {
    const auto other = static_cast<std::size_t>(chart_of[image[of_chart[i].front()]]);
    if (other == i) { reflect_in_itself(of_chart[i], image, at); }
    if (other <= i) { continue; }
    const auto here = box_of(of_chart[i], at), there = box_of(of_chart[other], at); // where it goes
    for (Index v : of_chart[i])
    {
      at[image[v]] = {there.low[0] + here.high[0] - at[v][0], there.low[1] + at[v][1] - here.low[1]};
    }
  }
  if (find_flipped_faces(u.disc.triangles, at).size() > u.map.flipped.size()
      || (u.map.is_one_to_one && !is_simple_everywhere(u.disc, at)))
  {
    return false;
  }
  u.map.at = std::move(at);
  u.map.flipped = find_flipped_faces(u.disc.triangles, u.map.at);
  u.map.faces = measure_faces(u.disc.points, u.disc.triangles, u.map.at);
  u.map.distortion = measure_distortion(u.disc.points, u.disc.triangles, u.map.at, u.map.faces);
  return true;
}

void check_symmetric(const Unwrap_options& options)
{
  if (!options.seams.empty() || !options.keep_out.empty() || options.family != 1 || options.stretch_weight > 0
      || options.image_size > 0)
  {
    throw Invalid_input_error("a symmetric unwrapping has seams of its own: none are given, no faces are kept out of, "
                              "cuts are not compared, and there is no geometry image");
  }
  if (!completes_seams(options.cut))
  {
    throw Invalid_input_error(
      "a symmetric unwrapping is cut by contours and links over the surface, of which the graph "
      "is not tightened");
  }
}

Unwrapping unwrap_symmetric(const Triangle_surface& root, const Unwrap_options& options, const Mirror& mirror)
{
  const Symmetric_seams seams(root, options, mirror);
  Unwrap_options o = options;
  o.is_symmetric = false;
  o.cut.on_edges = true;
  o.charts = 1;
  o.max_stretch = {};
  const double wanted = options.max_stretch.value_or(0);
  Unwrapping best;
  for (const bool is_joined : {true, false})
  {
    if (!is_joined && seams.find(false) == o.seams) { break; } // nothing can be joined
    o.seams = seams.find(is_joined);
    Unwrapping u = unwrap_surface(root, o);
    u.is_symmetric = make_maps_symmetric(mirror, u);
    const auto fault = [](const Unwrapping& x) { return std::make_pair(!x.is_symmetric, x.map.distortion.stretch_l2); };
    if (is_joined || fault(u) < fault(best)) { best = std::move(u); }
    if (best.is_symmetric && (!(wanted > 0) || best.map.distortion.stretch_l2 <= wanted)) { break; }
  }
  return best;
}

} // namespace internal

} // namespace meridian
