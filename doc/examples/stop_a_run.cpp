// Ends a run from outside, as a button of a window does, and shows how far it is.
#include "make_torus.h"

#include <meridian/cut_to_disc.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <atomic>
#include <functional>
#include <iostream>
#include <thread>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// What a window would have. The run asks `go_further()` between its steps, in its own thread.
struct Window : meridian::Progress_observer
{
  std::atomic<bool> is_pressed{false}, has_started{false};
  void stage_started(meridian::Stage stage) override
  {
    std::cout << name_of(stage) << '\n';
    has_started = true;
    while (!is_pressed) { std::this_thread::yield(); } // the mesh is small: give the button time
  }
  bool go_further() override { return !is_pressed; }
};

int main()
{
  Mesh mesh = make_torus<Mesh>();
  const auto before = mesh.number_of_vertices();
  Window window;
  std::thread button([&] {
    while (!window.has_started) { std::this_thread::yield(); }
    window.is_pressed = true;
  });
  try
  {
    meridian::cut_to_disc(mesh, meridian::parameters::visitor(std::ref(window)));
  }
  catch (const meridian::Cancelled& e)
  {
    std::cout << e.what() << '\n';
  }
  button.join();
  std::cout << (mesh.number_of_vertices() == before ? "the mesh is as it was\n" : "the mesh was changed\n");
}
