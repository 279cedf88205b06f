// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/handles/Generators.h>

namespace meridian {

const char* name_of(Curve_method method)
{
  switch (method)
  {
  case Curve_method::CONTOUR: return "contour";
  case Curve_method::FLOW: return "flow";
  case Curve_method::ARC: return "arc";
  }
  return "";
}

const char* name_of(Loop_class c)
{
  switch (c)
  {
  case Loop_class::HANDLE: return "handle";
  case Loop_class::TUNNEL: return "tunnel";
  case Loop_class::NEITHER: return "neither";
  case Loop_class::UNKNOWN: return "unknown";
  }
  return "";
}

double total_length(const Generators& generators)
{
  double sum = 0;
  for (const Generator_pair& pair : generators.pairs) { sum += pair.meridian.length + pair.longitude.length; }
  return sum;
}

} // namespace meridian
