// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_INTERNAL_CHART_DIVIDER_H
#define MERIDIAN_UNWRAP_INTERNAL_CHART_DIVIDER_H

#include <meridian/base/Progress_observer.h>
#include <meridian/base/vectors.h>
#include <meridian/map/Parameterization.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/pieces.h>
#include <meridian/unwrap/Unwrapping.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace meridian {
namespace internal {

// Cuts a surface and divides it into charts. What a chart will look like is known from unfolding it, which is much
// cheaper than a map: what it stretches by itself calls for a longer cut, where it overlaps itself it is divided.
class Chart_divider
{
public:
  Chart_divider(const Triangle_surface& root, const Unwrap_options& options);

  Unwrapping run();

private:
  struct Chart
  {
    Surface_piece piece; // of the opened surface
    double area = 0;
    std::vector<std::array<Index, 2>> apart = {}; // faces that overlap where it is unfolded
    double overlap = 0;                           // the part of it that does
    double excess = 0; // the square of the L2 stretch of its map less 1; what that may be, before it has one
    std::vector<Plane_point> unfolded = {};
    Parameterization map = {}; // once it has one
    bool is_whole = false;     // no arc divides it
  };

  // What one may return to.
  struct State
  {
    Cut cut;
    std::vector<Chart> charts;
    std::size_t extended;
  };
  State state() const { return {m_result.cut, m_charts, m_result.extended}; }
  void return_to(State&& before);

  // Cuts it into one disc, or along seams.
  void cut();
  // Edges where the surface turns by more than an angle, and seams may go.
  std::vector<Index> sharp_edges(double angle) const;
  // Takes the surface apart. Charts that are as they were keep what is known of them; of others the map begins where
  // they are drawn, or, if that is nowhere, where they are unfolded.
  void update_charts(const std::vector<Plane_point>& drawn = {});
  // The maps of all charts, over each other.
  std::vector<Plane_point> joined_maps() const;
  void unfold(Chart& chart) const;
  // The square of the L2 stretch of all charts less 1.
  double excess() const;
  bool is_automatic() const { return m_options.charts == 0; }

  // Extends the cut in all charts, as far as unfolding them says that it should be for some excess. Returns whether
  // that paid.
  bool extend(double wanted);
  // The same, where what is expected then is to become less by some factor more than that.
  bool extend(double wanted, double boldness);
  // The same for what is mapped, nearly as it should be, and one chart: all of it is mapped again either way.
  void extend_further();
  // Divides charts that overlap themselves, or the largest until there are as many as were asked for.
  void divide();
  void map_charts();
  // Divides charts that stretch most, and maps what they became, until the stretch is as small as is wanted.
  void divide_further();

  // Divides charts that leave much of the square empty, until enough of it is filled.
  void divide_wasteful();
  std::vector<std::size_t> most_wasteful() const;
  // The part of a square that they fill.
  double filled() const;

  // Divides charts. Returns whether one of them could be.
  bool divide(const std::vector<std::size_t>& which);
  // Charts that are divided next, the most needful first.
  std::vector<std::size_t> most_needful() const;
  // Charts with the most excess, together at least `enough`, or all; `sum` receives what they have, as a part of all.
  std::vector<std::size_t> most_stretched(double enough, double& sum) const;
  // Whether an arc's points are far enough from those that there are for doubles to tell them apart.
  bool has_room(const Surface_curve& arc) const;

  // Puts the maps of all charts on the fields of a chessboard, at one scale.
  void join_maps();
  void note(const std::string& name);
  void check_cut(const std::string& name) const;

  const Triangle_surface& m_root;
  Unwrap_options m_options;
  const std::vector<char> m_kept_out; // of each face of the root, whether seams go around it; empty: around none
  const double m_wanted;              // the square of the L2 stretch less 1
  const bool m_extends;               // whether the cut may be extended for that
  Unwrapping m_result;
  std::vector<Chart> m_charts;
  Progress m_progress; // told how much is mapped
  double m_done = 0;
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_UNWRAP_INTERNAL_CHART_DIVIDER_H
