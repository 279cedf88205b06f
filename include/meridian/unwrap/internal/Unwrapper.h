// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_INTERNAL_UNWRAPPER_H
#define MERIDIAN_UNWRAP_INTERNAL_UNWRAPPER_H

#include <meridian/base/vectors.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/measures.h>
#include <meridian/unwrap/Unwrapping.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

class Unwrapper
{
public:
  Unwrapper(const Triangle_surface& root, const Unwrap_options& options);

  Unwrapping run();

private:
  // The record that a step belongs to.
  using Steps = std::vector<Unwrap_step> Unwrapping::*;

  // Whether a map of the kind that is asked for unfolds what a cut lets unfold, and whether the best map is one.
  bool may_unfold() const;
  bool has_unfolded() const;

  // The L2 stretch that extensions of the cut are for.
  double wanted_stretch() const;

  // Cuts, extends the cut as a plan says, and maps.
  void cut_and_map();
  void map(Unwrapping& u);

  // The same for one of several. Returns why it has no map, or nothing.
  std::string try_to_map(Unwrapping& u);

  double cost(const Unwrapping& u) const;
  // Fewer flipped faces first, then the lower cost.
  bool is_better(const Unwrapping& u) const
  {
    return std::make_pair(u.map.flipped.size(), cost(u)) < std::make_pair(m_best.map.flipped.size(), cost(m_best));
  }
  // Fewer flipped faces first, then the lower stretch: by a part of what is still too much, which is larger if none
  // was asked for.
  bool is_worthwhile(const Unwrapping& u) const;

  // Takes over an unwrapping, but keeps the record of the search.
  void take(Unwrapping&& u);
  // Notes one, and takes it if it is good. Returns whether it is.
  bool judge(const std::string& name, Unwrapping&& u, Steps steps, bool is_good);
  // Notes one that has no map. Returns false.
  bool note_failure(const std::string& name, const Unwrapping& u, Steps steps, const std::string& reason);
  // Recounts a cut.
  void check_cut(const std::string& name, const Unwrapping& u) const;

  void search_family();

  // Other links between the same meridians, as long as one of them is better.
  void vary_links();
  bool try_links(const std::string& name, const Cut_options& options);
  bool try_extension(const std::vector<Index>& vertices);
  bool try_variation(const std::string& name, Unwrapping&& u);

  // Whether the best map is of no use: faces are flipped, or a part of the surface shrank to almost nothing in a map
  // that could unfold.
  bool is_useless() const;

  // Extends the cut of the best map as long as that is worthwhile: to such parts first, then to where plans say.
  void extend();

  // The square of an L2 stretch less 1: as was expected of a disc, and as its map has it.
  struct Expectation
  {
    double expected, measured;
  };
  // Vertices of the disc of the best cut that the cut should reach. What is known of discs so far brings what is
  // expected into line; the last is this disc's, if it has a map. What is expected then becomes less by a factor of the
  // boldness at least.
  std::vector<Index> plan(const Triangle_surface& disc, std::vector<Expectation>& known, double boldness) const;
  // Of each face of the disc of the best cut, whether seams go around it.
  std::vector<char> kept_out_of_best() const;
  // Vertices where the best map stretches most and seams may go.
  std::vector<Index> stretched_vertices(std::size_t most) const;
  // Extends the cut to regions of high stretch, as long as one of a few is worthwhile: for maps into a polygon.
  void extend_one_by_one();

  // The best cut, extended to some vertices. Returns the parents of faces that are new.
  std::vector<Index> extend_best(const std::vector<Index>& vertices, Unwrapping& u);
  // Extends the cut to some vertices. Returns whether that was worthwhile.
  bool extend_to(const std::vector<Index>& vertices);
  // The same to some vertices of faces that are flipped or all but vanish: each time to the one deepest inside the
  // disc, until none is a quarter as deep as the first.
  bool extend_to_useless();

  // Goes on from the best map, whose cut was extended to that of `u`. Returns whether that gave a map.
  bool go_on_from_best(Unwrapping& u, const std::vector<Index>& parents);

  static std::string name_of_extension(const std::vector<Index>& vertices);

  static constexpr double useless_stretch = 100, fair_stretch = 2;
  const Triangle_surface& m_root;
  Unwrap_options m_options;
  const std::vector<char> m_kept_out; // of each face of the root, whether seams go around it; empty: around none
  const double m_area;
  Cut_options m_chosen;
  Unwrapping m_best;
  std::size_t m_extended = 0; // vertices that the cut was extended to
};

} // namespace internal

} // namespace meridian

#endif // MERIDIAN_UNWRAP_INTERNAL_UNWRAPPER_H
