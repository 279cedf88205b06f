// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/result/name_curves.h>

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace meridian {

namespace {

Result_curve name_curve(const std::string& name, const std::vector<Index>& path, const std::vector<Index>& place)
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

// A field by the vertices of the input; none where two fans of one vertex have values of their own.
std::map<std::int32_t, double> field_on_input(const std::map<Index, double>& field, const Assembled_result& assembled,
                                              const std::vector<Index>& place)
{
  std::map<std::int32_t, double> values;
  for (const auto& [v, value] : field)
  {
    const Index copied = assembled.mesh.copy_of[place[v]];
    const auto [known, is_new] = values.emplace(copied < 0 ? place[v] : copied, value);
    if (!is_new && (known->second < value || known->second > value)) { return {}; }
  }
  return values;
}

} // namespace

std::vector<Result_curve> name_curves(const std::vector<Generators>& all, const Assembled_result& assembled)
{
  std::vector<Result_curve> curves;
  int handle = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const Generator_pair& pair : all[i].pairs)
    {
      const std::string number = std::to_string(handle++);
      curves.push_back(name_curve("meridian_" + number, pair.meridian.vertices, assembled.place[i]));
      curves.push_back(name_curve("longitude_" + number, pair.longitude.vertices, assembled.place[i]));
      if (pair.longitude.method != Curve_method::FLOW) { continue; }
      curves.back().field = field_on_input(pair.longitude.field, assembled, assembled.place[i]);
    }
  name_boundaries(all, assembled, curves);
  return curves;
}

std::vector<Result_curve> name_curves(const std::vector<Homology_basis>& all, const Assembled_result& assembled)
{
  std::vector<Result_curve> curves;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const Generator_curve& loop : all[i].loops)
      curves.push_back(name_curve("loop_" + std::to_string(curves.size()), loop.vertices, assembled.place[i]));
  name_boundaries(all, assembled, curves);
  return curves;
}

} // namespace meridian
