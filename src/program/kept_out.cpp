// SPDX-License-Identifier: GPL-3.0-or-later
#include "kept_out.h"

#include "field_arguments.h"
#include "files/formats.h"
#include "files/read_values.h"

#include <meridian/cut/keep_out.h>

#include <algorithm>
#include <sstream>

namespace meridian {
namespace program {

namespace {

// Of each point of the file, whether it is marked.
std::vector<char> find_marked_points(const Unwrap_arguments& a, const Loaded_mesh& loaded)
{
  std::vector<char> is_marked;
  if (names_file_of_kept_out(a))
  {
    for (double weight : files::read_values(a.keep_out, loaded.soup.points.size())) { is_marked.push_back(weight > 0); }
    return is_marked;
  }
  if (loaded.attributes.colours.empty())
  {
    throw files::File_error(a.mesh + ": its vertices have no colours, which --keep-out red needs; OBJ and PLY files "
                            + "may have them");
  }
  constexpr double much = 0.5; // more red than other colours
  for (const Point& c : loaded.attributes.colours) { is_marked.push_back(c[0] - std::max(c[1], c[2]) > much); }
  return is_marked;
}

} // namespace

std::vector<std::vector<Index>> find_kept_out(const Unwrap_arguments& a, const Loaded_mesh& loaded)
{
  std::vector<std::vector<Index>> all(loaded.examination.components.size());
  if (a.keep_out.empty()) { return all; }
  const std::vector<char> is_marked = find_marked_points(a, loaded);
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const Surface_component& c = loaded.examination.components[i];
    for (Index f = 0; f < c.surface.number_of_faces(); ++f)
    {
      const auto& t = c.surface.triangles[f];
      const bool is_inside =
        std::all_of(t.begin(), t.end(), [&](Index v) { return is_marked[point_of(loaded, c, v)]; });
      if (is_inside) { all[i].push_back(f); }
    }
  }
  return all;
}

std::vector<std::string> missed_kept_out(const std::vector<Unwrap_options>& options, const std::vector<Cut>& cuts,
                                         const std::vector<Surface_component>& components)
{
  std::vector<std::string> missed;
  for (std::size_t i = 0; i < cuts.size(); ++i)
  {
    const std::vector<Index>& faces = options[i].keep_out;
    if (faces.empty()) { continue; }
    const double length = seam_length_inside(cuts[i].surface, mark_faces(components[i].surface, faces));
    if (!(length > 0)) { continue; }
    std::ostringstream line;
    line << "component " << i << ": seams go over faces to keep out of, " << faces.size() << ", for a length of "
         << components[i].unit * length << " of " << components[i].unit * cuts[i].length
         << ": they enclose a handle or a boundary, or lie between all that is cut";
    missed.push_back(line.str());
  }
  return missed;
}

} // namespace program
} // namespace meridian
