// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/Cut_options.h>

namespace meridian {

const char* name_of(Cut_method method)
{
  switch (method)
  {
  case Cut_method::CONTOURS: return "contours";
  case Cut_method::GENERATORS: return "generators";
  case Cut_method::MORSE: return "morse";
  case Cut_method::GEODESIC: return "geodesic";
  case Cut_method::TREE_COTREE: return "tree-cotree";
  case Cut_method::GEOMETRY_IMAGE: return "geometry-image";
  }
  return "";
}

} // namespace meridian
