// Oracles of distances: CGAL's exact shortest paths, and its heat method.
#ifndef MERIDIAN_TEST_CGAL_DISTANCES_H
#define MERIDIAN_TEST_CGAL_DISTANCES_H

#include <meridian/surface/Triangle_surface.h>

#include <vector>

std::vector<double> exact_distance(const meridian::Triangle_surface& s, meridian::Index source);
std::vector<double> cgal_distance(const meridian::Triangle_surface& s, meridian::Index source);

#endif // MERIDIAN_TEST_CGAL_DISTANCES_H
