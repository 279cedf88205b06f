// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_ARGUMENTS_H
#define MERIDIAN_FIELD_ARGUMENTS_H

#include "arguments.h"
#include "files/Mesh_attributes.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/contours.h>
#include <meridian/field/Field.h>
#include <meridian/handles/preference.h>
#include <meridian/surface/examine_surface.h>

#include <string>
#include <vector>

namespace meridian {
namespace program {

// The paths of files that all of these commands read.
std::vector<std::string> files_read_for(const Field_arguments& arguments);

// Throws as `check_paths()` does for the files of all commands, and Usage_error if options do not go together.
void check_arguments(const Field_arguments& arguments);

// Throws Usage_error if no face of the mesh has the vertex that an option names.
void check_vertex(const char* option, Index vertex, const Examination& examination);

// The mesh as it was read, and what it is.
struct Loaded_mesh
{
  Polygon_soup soup;
  files::Mesh_attributes attributes; // if asked for
  Examination examination;
  std::vector<double> values, vertex_weights; // one a vertex of the file, if options name them
  double seconds_reading, seconds_examining;
};

// Reads and examines the mesh, and checks the vertices that options name. Signals are heeded once it is read.
Loaded_mesh load_mesh(const Field_arguments& arguments, bool with_attributes = false);

// The vertex of the file that a vertex of a component is.
Index point_of(const Loaded_mesh& loaded, const Surface_component& component, Index vertex);

// Those of the vertices of the file that lie on a component, in its numbers.
Index find_local(Index vertex, const Surface_component& component); // or -1
std::vector<Index> find_local(const std::vector<Index>& vertices, const Surface_component& component);

// What options say about the field of one component, given by its number, and about its meridians. Vertices of the file
// that the component does not have are left to the others.
Field_options field_options(const Field_arguments& arguments, const Loaded_mesh& loaded, std::size_t place);
Meridian_options meridian_options(const Field_arguments& arguments, const Loaded_mesh& loaded, std::size_t place);

} // namespace program
} // namespace meridian

#endif // MERIDIAN_FIELD_ARGUMENTS_H
