// Writes the surfaces of the manual's figures as OBJ files into a folder, and those that stand beside the paper's table
// 1.
#include "support/implicit_surfaces.h"

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

#include <fstream>
#include <iostream>

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::cerr << "write_figure_surfaces FOLDER\n";
    return 64;
  }
  const auto write = [&](const std::string& name, const meridian::Triangle_surface& s) {
    std::ofstream out(std::string(argv[1]) + "/" + name + ".obj");
    for (const auto& p : s.points) { out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n'; }
    for (const auto& t : s.triangles) { out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n'; }
  };
  write("torus", sample::torus(60, 30, 1.5, 0.6));
  write("irregular-torus", sample::irregular_torus(40));
  write("bitorus-coarse", sample::bitorus(20));
  write("bitorus", sample::bitorus(40));
  write("bitorus-fine", sample::bitorus(80));
  write("tiny-handle", sample::bitorus_with_tiny_handle(96));
  write("pot", sample::teapot(56));
  write("three-rings", sample::three_rings(60));
  // As many vertices as the paper's, to a few percent, and the same genus.
  write("table-figure-1", sample::rings(4, 1.4, 117));
  write("table-figure-7", sample::irregular_torus(40));
  write("table-figure-11ab",
        sample::isosurface([](const sample::Point& p) { return sample::ring(p, 1.5, 0.55); }, 2.4, 80));
  write("table-figure-11gh", sample::bitorus(120));
  write("table-figure-12", sample::teapot(43));
}
