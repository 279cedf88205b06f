// Surfaces as files, and what is looked for in what was printed.
#ifndef MERIDIAN_TEST_WRITTEN_MESHES_H
#define MERIDIAN_TEST_WRITTEN_MESHES_H

#include "files/write_mesh.h"

#include <meridian/base/Result_mesh.h>
#include <meridian/surface/Triangle_surface.h>

#include <string>

namespace written {

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

inline std::string obj(const meridian::Triangle_surface& s)
{
  meridian::Result_mesh m;
  m.points = s.points;
  m.faces = s.triangles;
  return meridian::files::format_mesh("x.obj", m);
}

} // namespace written

#endif // MERIDIAN_TEST_WRITTEN_MESHES_H
