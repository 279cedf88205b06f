// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/base/Progress_observer.h>

namespace meridian {

const char* name_of(Stage stage)
{
  switch (stage)
  {
  case Stage::EXTREMA: return "extrema";
  case Stage::FIELD: return "field";
  case Stage::ORDER: return "order";
  case Stage::CONTOURS: return "contours";
  case Stage::MERIDIANS: return "meridians";
  case Stage::FLOW: return "flow";
  case Stage::LONGITUDES: return "longitudes";
  case Stage::TIGHTEN: return "tighten";
  case Stage::INSERT: return "insert";
  case Stage::CLASSIFY: return "classify";
  case Stage::LINKS: return "links";
  case Stage::SHORTEN: return "shorten";
  case Stage::OPEN: return "open";
  case Stage::PARAMETERIZE: return "parameterize";
  case Stage::VERIFY: return "verify";
  }
  return "";
}

} // namespace meridian
