// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/check_surface.h>

#include <meridian/base/Union_find.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/list_elements.h>
#include <meridian/surface/measures.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace meridian {

void check_surface(const Triangle_surface& s)
{
  if (s.number_of_faces() == 0) { throw Invalid_input_error("the surface has no faces; there is nothing to cut"); }
  Union_find pieces(s.number_of_faces());
  Index number = s.number_of_faces();
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    if (s.opposite[h] > h) { number -= pieces.unite(s.face(h), s.face(s.opposite[h])); }
  }
  if (number == 1) { return; }
  std::vector<Index> first;
  for (Index f = 0; f < s.number_of_faces(); ++f)
  {
    if (pieces.find(f) == f) { first.push_back(f); }
  }
  throw Invalid_input_error(internal::list_elements("pieces make up the surface, with the faces", first)
                            + "; a surface is connected: take each piece on its own");
}

void check_fans(const Triangle_surface& s)
{
  std::vector<Index> corners(s.number_of_vertices(), 0);
  for (const auto& t : s.triangles)
  {
    for (Index v : t) { ++corners[v]; }
  }
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    if (corners[v] == 0)
    {
      throw Invalid_input_error("vertex " + std::to_string(v) + " belongs to no face; remove it");
    }
    s.for_each_outgoing(v, [&](Index) { --corners[v]; });
    if (corners[v] != 0)
    {
      throw Invalid_input_error("vertex " + std::to_string(v)
                                + " is pinched: its faces form several fans; divide it first");
    }
  }
}

void check_is_disc(const Triangle_surface& s)
{
  check_surface(s);
  const std::size_t loops = boundary_loops(s).size();
  const int handles = genus(s);
  if (loops != 1 || handles != 0)
  {
    throw Invalid_input_error("the surface is no disc: it has genus " + std::to_string(handles) + " and "
                              + std::to_string(loops) + (loops == 1 ? " boundary loop" : " boundary loops")
                              + "; cut it first");
  }
}

void check_vertices(const Triangle_surface& s, const std::vector<Index>& vertices, const char* what)
{
  for (Index v : vertices)
    if (v < 0 || v >= s.number_of_vertices())
      throw Invalid_input_error(std::string(what) + ": there is no vertex " + std::to_string(v) + "; the surface has "
                                + std::to_string(s.number_of_vertices()));
}

void check_values(const Triangle_surface& s, const std::vector<double>& values, const char* what)
{
  if (static_cast<Index>(values.size()) != s.number_of_vertices())
    throw Invalid_input_error(std::string(what) + " has " + std::to_string(values.size()) + " values for "
                              + std::to_string(s.number_of_vertices()) + " vertices; it needs one a vertex");
  const auto bad = std::find_if(values.begin(), values.end(), [](double x) { return !std::isfinite(x); });
  if (bad != values.end())
  {
    throw Invalid_input_error(std::string(what) + " is not finite at vertex " + std::to_string(bad - values.begin()));
  }
}

} // namespace meridian
