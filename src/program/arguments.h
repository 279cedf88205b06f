// SPDX-License-Identifier: GPL-3.0-or-later
// What the commands are told that cut something.
#ifndef MERIDIAN_ARGUMENTS_H
#define MERIDIAN_ARGUMENTS_H

#include "choices.h"
#include "commands.h"
#include "files/map_file.h"

#include <meridian/base/vectors.h>
#include <meridian/curves/contours.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/cut/join_generators.h>
#include <meridian/field/Field.h>
#include <meridian/field/edge_weights.h>
#include <meridian/map/Map_method.h>
#include <meridian/map/pack_charts.h>
#include <meridian/unwrap/compare_parameterizations.h>

#include <optional>
#include <string>
#include <vector>

namespace meridian {
namespace program {

// What the commands share that make something of a field.
struct Field_arguments : Common_arguments
{
  std::string mesh, out, view, curves;
  files::Map_format map = files::Map_format::JSON;
  std::vector<Index> minima, maxima; // vertices of the file
  bool has_direction = false, has_from = false, has_extrema = false;
  Weights weights = Weights::POSITIVE;
  Field field; // as it is made, without what the other options say
  Extrema extrema = Extrema::DISTANT;
  std::string values;
  int eigenfunction = 0; // 0: the genus + 1
  Index from = 0;        // where distances begin, or the loops of tree-cotree
  Prefer prefer = Prefer::GAUSSIAN_CURVATURE;
  std::string vertex_weights;
  Levels levels = Levels::SADDLE;
  std::vector<double> direction{0, 0, 1};
};

struct Cut_arguments : Field_arguments
{
  Index source = 0;
  bool has_source = false;
  Cut_method method; // as it is made
  Generator_join join = Generator_join::SURFACE;
  Link_domain links = Link_domain::SURFACE;
  bool bifurcations = false;
  std::optional<Tightening> tighten; // empty: as the command does by itself
  bool on_edges = false, refine_where_needed = false;
  int bases = 16;
  bool has_bases = false;
  int family = 0; // how many cuts; 0: one, as chosen
};

struct Unwrap_arguments : Cut_arguments // with a family, the best of its members
{
  std::vector<std::string> meshes, outs; // those of all; `mesh` and `out` are those of one
  Map_method parameterization = Map_method::SYMMETRIC_DIRICHLET;
  Map_border border = Map_border::FREE;
  bool has_border = false;
  double stretch_weight = 0;
  std::optional<double> max_stretch;                // 0: the shortest seams
  std::string layout, texture, distortion, doubled; // paths, or empty
  int geometry_image = 0;                           // pixels along a side, or 0
  int charts = 1;                                   // 0: as many as are needed
  std::string seams;                                // `uv`, `sharp:ANGLE`, a path, or empty
  std::optional<Chart_per> chart_per;
  std::string keep_out; // `red`, a path, or empty
  std::string pins;     // a path, or empty
  bool is_symmetric = false;
  Pack_options packing;
  bool has_padding = false;
};

struct Compare_arguments : Common_arguments
{
  std::string mesh;
  std::vector<std::string> cuts; // a result of `cut` or `unwrap`, or the number of a member of the family
  Map_weights weights = Map_weights::POSITIVE;
};

struct Generator_arguments : Field_arguments
{
  Basis basis = Basis::PAIRS;
  Longitudes longitudes = Longitudes::FLOW;
  Boundary_mode mode = Boundary_mode::CLOSED;
  bool no_tighten = false, complex = false;
};

int run_family(const Cut_arguments& arguments); // of `cut`

} // namespace program
} // namespace meridian

#endif // MERIDIAN_ARGUMENTS_H
