// What every test includes, compiled once.
#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <meridian/cut/cut_to_disc.h>
#include <meridian/surface/examine_surface.h>
