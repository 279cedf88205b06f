// Strips of faces and the shortest ways through them.
#include "support/sample_surfaces.h"

#include <meridian/base/Stage_runner.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/contours.h>
#include <meridian/curves/place_crossings.h>
#include <meridian/curves/project_contours.h>
#include <meridian/curves/sleeve.h>
#include <meridian/field/order_surface.h>
#include <meridian/surface/Triangle_surface.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

using namespace meridian;
using namespace meridian::internal;

namespace {

// The strips of the loops of all saddles.
std::vector<std::vector<Index>> strips_of(const Triangle_surface& s)
{
  const Ordered_surface m = order_surface(s, {}, run_unwatched);
  const std::vector<Contour> loops = trace_saddle_loops(m);
  std::vector<const Contour*> contours;
  for (const Contour& c : loops) { contours.push_back(&c); }
  std::vector<std::vector<Index>> strips;
  for (const auto& curve : project_crossings(s, m, contours))
  {
    auto& strip = strips.emplace_back();
    for (const Piece_crossing& x : curve) { strip.push_back(x.halfedge); }
  }
  return strips;
}

} // namespace

// A closed curve that bends at the same corner in each of three turns is the tight loop of its strip, wherever that is
// said to begin; what does not goes through five.
BOOST_AUTO_TEST_CASE(a_tight_loop_is_the_same_wherever_its_strip_begins)
{
  int tight = 0, others = 0;
  for (unsigned seed : {1u, 2u, 3u})
  {
    const Triangle_surface s = sample::noisy(sample::plate(4, 2), 0.3, seed);
    for (const auto& strip : strips_of(s))
    {
      std::size_t turns = 0;
      const auto fraction = pull_closed(s, strip, turns).fraction;
      BOOST_TEST(fraction.size() == strip.size());
      others += turns > 3;
      for (std::size_t begin = 1; begin < strip.size(); ++begin)
      {
        std::vector<Index> turned(strip.begin() + begin, strip.end());
        turned.insert(turned.end(), strip.begin(), strip.begin() + begin);
        std::size_t other_turns = 0;
        const auto other = pull_closed(s, turned, other_turns).fraction;
        if (turns > 3 || other_turns > 3) { continue; }
        ++tight;
        for (std::size_t i = 0; i < strip.size(); ++i)
        {
          BOOST_TEST(std::abs(other[i] - fraction[(begin + i) % strip.size()]) < 1e-9);
        }
      }
    }
  }
  BOOST_TEST(tight > 0);
  BOOST_TEST(others > 0);
}
