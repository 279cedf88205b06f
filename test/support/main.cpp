#define BOOST_TEST_MODULE meridian
#include <boost/test/unit_test.hpp>
