// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_TO_DISC_H
#define MERIDIAN_CUT_TO_DISC_H

#include <meridian/Progress_observer.h>
#include <meridian/link_boundaries.h>
#include <meridian/open_along.h>
#include <meridian/order_surface.h>
#include <meridian/planar_links.h>
#include <meridian/project_contours.h>
#include <meridian/select_meridians.h>

#include <string>

namespace meridian {

/// \ingroup PkgMeridianCut
/// where links run.
enum class Link_domain
{
  SURFACE, ///< shortest paths on the surface
  PLANE    ///< counterimages of segments in a planar embedding, where one exists in double precision
};

/// \ingroup PkgMeridianCut
/// what one may choose about a cut. Vertices are those of the surface that is cut.
struct Cut_options : Field_options
{
  Preference preference = preference::gaussian_curvature;
  Link_domain link_domain = Link_domain::SURFACE;
  Link_options links;
  Progress_observer* observer = nullptr;
};

/// \ingroup PkgMeridianCut
/// a cut graph of one connected surface, and what was counted on the way.
struct Disc_cut : Field_summary
{
  Refined_surface surface;                       ///< the input, refined; the cut graph is its seam
  Opened_surface opened;                         ///< the disc
  std::vector<std::vector<Index>> meridians;     ///< closed, as vertices of `surface`, the most preferred first
  std::vector<std::vector<Index>> links;         ///< open, as vertices of `surface`
  std::vector<Meridian_choice> choices;          ///< the count after each meridian
  std::vector<Index> saddles;                    ///< for each meridian, a vertex of its saddle
  int genus = 0, boundary_loops = 0;
  bool links_in_plane = false;
  std::string link_note;                         ///< why links were not taken through the plane, if asked for
  double length = 0;                             ///< of the seams
  double smallest_angle_before = 0, smallest_angle_after = 0; ///< in radians
  Stage_times seconds;
};

/*!
 * \ingroup PkgMeridianCut
 *
 * cuts a connected surface into a disc along smooth curves (Patane 2007, section 3).
 *
 * A harmonic field is ordered, simplified and unfolded; of its saddles' contours as many as there are handles are cut
 * as meridians; the boundaries that this leaves are joined by a tree of links. A disc stays as it is.
 *
 * \tparam SymmetricTraits, GeneralTraits models of CGAL's `SparseLinearAlgebraWithFactorTraits_d`; the second serves
 *         mean-value weights
 * \param root the surface
 * \param options see there
 *
 * \returns the cut, which is topologically right however bad the shape of the faces is
 * \pre `root` is connected
 * \throws Invalid_input_error if minima and maxima coincide, Solver_error if the field cannot be solved, Cancelled if the
 *         observer says so, Internal_error if an invariant broke
 * \par Complexity
 * One factorization, \f$ O(n^{1.5}) \f$, and \f$ O(n \log n) \f$ beside it.
 */
template <class SymmetricTraits = Symmetric_solver_traits, class GeneralTraits = General_solver_traits>
Disc_cut cut_to_disc(const Triangle_surface& root, const Cut_options& options = Cut_options())
{
  Disc_cut cut;
  const internal::Stage_runner run{options.observer, cut.seconds};

  cut.boundary_loops = static_cast<int>(boundary_loops(root).size());
  const int characteristic = root.number_of_vertices() - root.number_of_edges() + root.number_of_faces();
  cut.genus = (2 - characteristic - cut.boundary_loops) / 2;
  cut.smallest_angle_before = smallest_angle(root);
  cut.surface = Refined_surface(root);

  if (cut.genus > 0)
  {
    const Ordered_surface m = order_surface<SymmetricTraits, GeneralTraits>(root, options, run);
    static_cast<Field_summary&>(cut) = summarize_field(root, m);
    Meridian_search search;
    run(Stage::CONTOURS, [&] { search.loops = trace_saddle_loops(m); });
    run(Stage::MERIDIANS, [&] {
      find_meridians(root, m, cut.genus, options.preference, search);
      cut.choices = search.choices;
      for (const auto& choice : cut.choices) { cut.saddles.push_back(search.candidates[choice.loop].saddle); }
      cut.meridians = insert_curves(root, cut.surface, project_contours(root, m, search.chosen())).vertices;
    });
  }
  run(Stage::LINKS, [&] {
    if (options.link_domain == Link_domain::PLANE)
    {
      cut.link_note = link_boundaries_in_plane<SymmetricTraits>(root, cut.surface, options.links.source, cut.links);
      cut.links_in_plane = cut.link_note.empty();
      if (cut.links_in_plane) { return; }
    }
    Link_options links = options.links;
    links.progress = [&](double done) { run.progress(Stage::LINKS, done); };
    cut.links = link_boundaries(root, cut.surface, cut.meridians, links);
  });
  run(Stage::OPEN, [&] {
    cut.opened = open_along(cut.surface);
    for (const auto& seam : cut.opened.seams) { cut.length += cut.surface.length(seam[0]); }
    cut.smallest_angle_after = smallest_angle(cut.surface);
  });
  return cut;
}

} // namespace meridian

#endif // MERIDIAN_CUT_TO_DISC_H
