// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_RESULT_ASSEMBLE_RESULT_H
#define MERIDIAN_RESULT_ASSEMBLE_RESULT_H

#include <meridian/base/Result_mesh.h>
#include <meridian/cut/cut_to_disc.h>
#include <meridian/handles/find_shortest_basis.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/proof/verify_generators.h>
#include <meridian/surface/examine_surface.h>

namespace meridian {

/// \ingroup PkgMeridianResults
/// a result, and where the vertices of each component stand in it.
struct Assembled_result
{
  Result_mesh mesh;
  /// for each component, of each vertex of its refined surface, and then of each copy
  std::vector<std::vector<Index>> place;
};

namespace internal {

// An origin on a component, in terms of the file.
inline Result_origin file_origin(const Origin& o, const Surface_component& c, Index points,
                                 const std::vector<Index>& added)
{
  const auto vertex = [&](Index v) {
    return c.vertex_of[v] < points ? c.vertex_of[v] : added[c.vertex_of[v] - points];
  };
  Result_origin r;
  switch (o.kind)
  {
  case Origin::VERTEX: r.index = {vertex(o.index[0]), -1}; break;
  case Origin::EDGE:
  {
    const Index v = vertex(o.index[0]), w = vertex(o.index[1]);
    r.kind = Result_origin::EDGE;
    r.index = {std::min(v, w), std::max(v, w)};
    r.weight = {v < w ? o.weight[0] : 1 - o.weight[0], 0, 0};
    break;
  }
  case Origin::FACE:
    r.kind = Result_origin::FACE;
    r.index = {c.triangle_of[o.index[0]], -1};
    r.weight = o.weight;
    if (c.is_flipped[o.index[0]]) { std::swap(r.weight[1], r.weight[2]); }
    break;
  }
  return r;
}

} // namespace internal

namespace internal {

// A refined component, and how it was taken apart.
struct Result_part
{
  const Refined_surface& surface;
  const Opened_surface& opened;
};

inline Assembled_result assemble_parts(const Polygon_soup& soup, const Examination& examination,
                                       const std::vector<Result_part>& cuts)
{
  Assembled_result result;
  Result_mesh& r = result.mesh;
  const Index n = static_cast<Index>(soup.points.size());
  Index new_vertices = 0, new_faces = 0, triangles = 0;
  for (const Result_part& cut : cuts)
  {
    new_vertices += static_cast<Index>(cut.surface.origins.size());
    new_faces += cut.surface.number_of_faces();
  }
  std::vector<std::array<Index, 3>> corners;
  for_each_triangle(soup, [&](Index, Index, Index a, Index b, Index c) {
    corners.push_back({a, b, c});
    ++triangles;
  });

  // Vertices: the file's, new ones by component, fans of pinched vertices, copies by component.
  const Index added = static_cast<Index>(examination.added_vertex_of.size());
  Index next_new = n, next_copy = n + new_vertices + added;
  r.origin.resize(n + new_vertices + added);
  r.copy_of.assign(n + new_vertices + added, -1);
  for (Index v = 0; v < n; ++v) { r.origin[v].index = {v, -1}; }
  for (Index i = 0; i < added; ++i)
  {
    r.copy_of[n + new_vertices + i] = examination.added_vertex_of[i];
    r.origin[n + new_vertices + i].index = {examination.added_vertex_of[i], -1};
  }
  auto& place = result.place;
  place.resize(cuts.size());
  for (std::size_t i = 0; i < cuts.size(); ++i)
  {
    const Refined_surface& s = cuts[i].surface;
    const Surface_component& c = examination.components[i];
    for (Index v : c.vertex_of) { place[i].push_back(v < n ? v : v + new_vertices); }
    for (const Origin& o : s.origins)
    {
      r.origin[next_new] = internal::file_origin(o, c, n, examination.added_vertex_of);
      place[i].push_back(next_new++);
    }
    for (Index v : cuts[i].opened.copy_of)
    {
      const Index original = place[i][v], first = r.copy_of[original] < 0 ? original : r.copy_of[original];
      r.copy_of.push_back(first);
      r.origin.push_back(r.origin[first]);
      place[i].push_back(next_copy++);
    }
  }
  for (const Result_origin& o : r.origin)
    r.points.push_back(position_of(o, soup.points, [&](Index t) -> const std::array<Index, 3>& { return corners[t]; }));

  // Faces, sorted by the triangle they are part of.
  std::vector<Index> begin(triangles + 1, 0);
  for (std::size_t i = 0; i < cuts.size(); ++i)
    for (Index f : cuts[i].surface.face_of) { ++begin[examination.components[i].triangle_of[f] + 1]; }
  for (Index t = 0; t < triangles; ++t) { begin[t + 1] += begin[t]; }
  r.faces.resize(new_faces);
  r.face_of.resize(new_faces);
  r.component_of.resize(new_faces);
  for (std::size_t i = 0; i < cuts.size(); ++i)
  {
    const Surface_component& c = examination.components[i];
    std::vector<Index> face_place;
    for (std::size_t f = 0; f < cuts[i].opened.triangles.size(); ++f)
    {
      const Index root = cuts[i].surface.face_of[f], to = begin[c.triangle_of[root]]++;
      const auto& t = cuts[i].opened.triangles[f];
      r.faces[to] = {place[i][t[0]], place[i][t[1]], place[i][t[2]]};
      r.face_of[to] = c.polygon_of[root];
      r.component_of[to] = static_cast<Index>(i);
      face_place.push_back(to);
    }
    for (const auto& seam : cuts[i].opened.seams)
    {
      const Index a = 3 * face_place[seam[0] / 3] + seam[0] % 3, b = 3 * face_place[seam[1] / 3] + seam[1] % 3;
      r.seams.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(r.seams.begin(), r.seams.end());
  return result;
}

// One surface as a file that holds nothing else.
inline Polygon_soup soup_of(const Triangle_surface& root)
{
  Polygon_soup soup;
  soup.points = root.points;
  for (const auto& t : root.triangles) { soup.add_polygon(t.data(), 3); }
  return soup;
}
inline Examination examination_of(const Triangle_surface& root)
{
  Examination examination;
  examination.components.resize(1);
  Surface_component& c = examination.components.front();
  c.vertex_of.resize(root.number_of_vertices());
  c.triangle_of.resize(root.number_of_faces());
  std::iota(c.vertex_of.begin(), c.vertex_of.end(), Index(0));
  std::iota(c.triangle_of.begin(), c.triangle_of.end(), Index(0));
  c.polygon_of = c.triangle_of;
  c.is_flipped.assign(root.number_of_faces(), 0);
  return examination;
}

} // namespace internal

/*!
 * \ingroup PkgMeridianResults
 *
 * puts the discs of all components back into one mesh in the order of the input.
 *
 * \param soup the input
 * \param examination what `examine_surface()` made of it
 * \param cuts the cut of each component
 *
 * \returns the opened mesh. The parts of a face stand where the face stood.
 * \par Complexity
 * Linear.
 */
inline Assembled_result assemble_result(const Polygon_soup& soup, const Examination& examination,
                                        const std::vector<Disc_cut>& cuts)
{
  std::vector<internal::Result_part> parts;
  for (const Disc_cut& cut : cuts) { parts.push_back({cut.surface, cut.opened}); }
  return internal::assemble_parts(soup, examination, parts);
}

/*!
 * \ingroup PkgMeridianResults
 *
 * puts refined components back into one mesh in the order of the input, with nothing taken apart.
 *
 * \tparam Curves `Generators` or `Homology_basis`
 * \param soup the input
 * \param examination what `examine_surface()` made of it
 * \param all those of each component
 *
 * \returns the refined mesh. The parts of a face stand where the face stood.
 * \par Complexity
 * Linear.
 */
template <class Curves>
Assembled_result assemble_refined(const Polygon_soup& soup, const Examination& examination,
                                  const std::vector<Curves>& all)
{
  std::vector<Opened_surface> whole(all.size());
  std::vector<internal::Result_part> parts;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    whole[i].triangles = all[i].surface.triangles;
    parts.push_back({all[i].surface, whole[i]});
  }
  return internal::assemble_parts(soup, examination, parts);
}

namespace internal {

inline Result_curve name_curve(const std::string& name, const std::vector<Index>& path, const std::vector<Index>& place)
{
  Result_curve c{name, {}, {}};
  for (Index v : path) { c.points.push_back(place[v]); }
  c.points.push_back(c.points.front());
  return c;
}

template <class Curves>
void name_boundaries(const std::vector<Curves>& all, const Assembled_result& assembled,
                     std::vector<Result_curve>& curves)
{
  int number = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const auto& loop : boundary_loops(all[i].surface))
    {
      std::vector<Index> path;
      for (Index h : loop) { path.push_back(all[i].surface.source(h)); }
      curves.push_back(name_curve("boundary_" + std::to_string(number++), path, assembled.place[i]));
    }
}

} // namespace internal

/// \ingroup PkgMeridianResults
/// \returns the curves of all components as they are written: the pairs, numbered through, then all boundary loops
/// \param all the generators of each component
/// \param assembled their mesh
inline std::vector<Result_curve> name_curves(const std::vector<Generators>& all, const Assembled_result& assembled)
{
  std::vector<Result_curve> curves;
  int handle = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const Generator_pair& pair : all[i].pairs)
    {
      const std::string number = std::to_string(handle++);
      curves.push_back(internal::name_curve("meridian_" + number, pair.meridian.vertices, assembled.place[i]));
      curves.push_back(internal::name_curve("longitude_" + number, pair.longitude.vertices, assembled.place[i]));
      if (pair.longitude.method != Curve_method::FLOW) { continue; }
      for (const auto& [v, value] : pair.longitude.field) { curves.back().field.emplace(assembled.place[i][v], value); }
    }
  internal::name_boundaries(all, assembled, curves);
  return curves;
}

/// \ingroup PkgMeridianResults
/// \returns the loops of all components, numbered through, then all boundary loops
/// \param all the basis of each component
/// \param assembled their mesh
inline std::vector<Result_curve> name_curves(const std::vector<Homology_basis>& all, const Assembled_result& assembled)
{
  std::vector<Result_curve> curves;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const Generator_curve& loop : all[i].loops)
      curves.push_back(
        internal::name_curve("loop_" + std::to_string(curves.size()), loop.vertices, assembled.place[i]));
  internal::name_boundaries(all, assembled, curves);
  return curves;
}

/*!
 * \ingroup PkgMeridianResults
 *
 * \returns the recount of a cut that was made without a file: the surface and the disc as plain arrays, given to
 *          `verify_cut()`
 * \param root the surface that was cut
 * \param cut its cut
 */
inline Verification verify_cut(const Triangle_surface& root, const Disc_cut& cut)
{
  const Polygon_soup soup = internal::soup_of(root);
  return verify_cut(soup, assemble_result(soup, internal::examination_of(root), std::vector<Disc_cut>{cut}).mesh);
}

/*!
 * \ingroup PkgMeridianResults
 *
 * \returns the recount of curves that were found without a file
 * \tparam Curves `Generators` or `Homology_basis`
 * \param root the surface
 * \param found its curves
 */
template <class Curves> Generator_verification verify_generators(const Triangle_surface& root, const Curves& found)
{
  const Polygon_soup soup = internal::soup_of(root);
  const std::vector<Curves> all{found};
  const Assembled_result assembled = assemble_refined(soup, internal::examination_of(root), all);
  return verify_generators(soup, assembled.mesh, name_curves(all, assembled));
}

} // namespace meridian

#endif // MERIDIAN_RESULT_ASSEMBLE_RESULT_H
