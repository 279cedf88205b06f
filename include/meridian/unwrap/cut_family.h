// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_CUT_FAMILY_H
#define MERIDIAN_UNWRAP_CUT_FAMILY_H

#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Triangle_surface.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianFamily
/// a cut graph of a family.
struct Family_member
{
  std::string name;    ///< what makes it different: field, preference, levels or method
  Cut_options options; ///< all that was chosen
  Cut cut;             ///< its cut
};

/*!
 * \ingroup PkgMeridianFamily
 *
 * cut graphs of one connected surface, all different, each found and recounted when it is asked for: an input range.
 *
 * The paper's point is that there is not one cut graph but a family (\cite patane2007, section 3). The first member is
 * the cut with the options given. Then fields, preferences, levels and methods change; then a harmonic field runs
 * between other and other pairs of vertices that are spread over the surface. A cut that was found before is left out;
 * a choice that does not suit the surface too.
 *
 * \code
 * for (const Family_member& member : Cut_family(surface, 16)) { ... member.cut.length ... }
 * \endcode
 */
class Cut_family
{
public:
  /// \param root the surface, which must outlive the family
  /// \param size how many members at most; there may be fewer
  /// \param options what all members share; by itself, curves are tightened
  /// \pre `root` is connected
  Cut_family(const Triangle_surface& root, int size, const Cut_options& options = Cut_options());
  Cut_family(Triangle_surface&& root, int size, const Cut_options& options = Cut_options()) = delete;

  /// the next member.
  /// \returns nothing after the last
  /// \throws Solver_error, Cancelled and Internal_error as `cut_to_disc()`; Invalid_input_error only from the first
  /// member
  std::optional<Family_member> next();

  /// an input iterator; members are found as it advances.
  class Iterator
  {
  public:
    /// \cond
    using iterator_category = std::input_iterator_tag;
    using value_type = Family_member;
    using difference_type = std::ptrdiff_t;
    using pointer = const Family_member*;
    using reference = const Family_member&;
    Iterator() = default;
    explicit Iterator(Cut_family* family) : m_family(family) { ++*this; }
    reference operator*() const { return *m_member; }
    pointer operator->() const { return &*m_member; }
    Iterator& operator++()
    {
      m_member = m_family->next();
      if (!m_member) { m_family = nullptr; }
      return *this;
    }
    void operator++(int) { ++*this; }
    bool operator==(const Iterator& i) const { return m_family == i.m_family; }
    bool operator!=(const Iterator& i) const { return !(*this == i); }
    /// \endcond

  private:
    Cut_family* m_family = nullptr;
    std::optional<Family_member> m_member;
  };
  /// \returns the member after the last one found
  Iterator begin() { return Iterator(this); }
  /// \returns what an iterator becomes after the last member
  Iterator end() { return Iterator(); }

private:
  // Changes the options for choice `i`. Returns its name.
  std::string choose(int i, Cut_options& o);

  // Pair `k` of spread vertices: (0, 2), (1, 2), (0, 3), ...
  std::pair<Index, Index> spread_pair(int k);

  void spread_to(const Closed_model& g, Index a);

  static std::vector<std::array<Point, 2>> seam_points(const Cut& cut);

  const Triangle_surface& m_root;
  int m_size, m_found = 0, m_choice = 0;
  Cut_options m_options;
  std::unique_ptr<Closed_model> m_graph;
  std::vector<Index> m_spread;    // nodes, each far from those before
  std::vector<double> m_distance; // of each node from the nearest of them
  std::set<std::vector<std::array<Point, 2>>> m_known;
};

/// \ingroup PkgMeridianFamily
/// \param costs of each cut: length, new vertices, and the negative of the smallest angle
/// \returns for each cut whether no other is at least as good in every respect and better in one: shorter, fewer new
///          vertices, a larger smallest angle. Of equal ones all are kept.
std::vector<char> find_best_cuts(const std::vector<std::array<double, 3>>& costs);

} // namespace meridian

#endif // MERIDIAN_UNWRAP_CUT_FAMILY_H
