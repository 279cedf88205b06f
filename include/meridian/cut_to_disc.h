// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_TO_DISC_H
#define MERIDIAN_CUT_TO_DISC_H

#include <meridian/Progress_observer.h>
#include <meridian/find_generators.h>
#include <meridian/join_generators.h>
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
/// what cuts the handles.
enum class Cut_method
{
  CONTOURS,   ///< a meridian for each handle (Patane 2007, section 3)
  GENERATORS, ///< a meridian and a longitude for each handle (section 4)
  MORSE       ///< the descending flow lines of all saddles (Ni, Garland, Hart 2004)
};

/// \ingroup PkgMeridianCut
/// \returns the name of a method as it stands in reports
inline const char* name_of(Cut_method method)
{
  switch (method)
  {
  case Cut_method::CONTOURS: return "contours";
  case Cut_method::GENERATORS: return "generators";
  case Cut_method::MORSE: return "morse";
  }
  return "";
}

/// \ingroup PkgMeridianCut
/// what one may choose about a cut. Vertices are those of the surface that is cut.
struct Cut_options : Field_options
{
  Cut_method method = Cut_method::CONTOURS;
  Generator_join join = Generator_join::SURFACE; ///< with `Cut_method::GENERATORS`
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
  std::vector<std::vector<Index>> longitudes;    ///< closed, of the same handles; with `Cut_method::GENERATORS`
  std::vector<std::vector<Index>> flow_lines;    ///< open; with `Cut_method::MORSE`
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

namespace internal {

inline void cut_along_contours(const Triangle_surface& root, const Ordered_surface& m, const Cut_options& options, const Stage_runner& run, Disc_cut& cut)
{
  Meridian_search search;
  run(Stage::CONTOURS, [&] { search.loops = trace_saddle_loops(m); });
  run(Stage::MERIDIANS, [&] {
    find_meridians(root, m, cut.genus, options.preference, search);
    cut.choices = search.choices;
    for (const auto& choice : cut.choices) { cut.saddles.push_back(search.candidates[choice.loop].saddle); }
    cut.meridians = insert_curves(root, cut.surface, project_contours(root, m, search.chosen())).vertices;
  });
}

template <class SymmetricTraits, class GeneralTraits>
std::vector<Link_guide> cut_along_generators(const Triangle_surface& root, const Ordered_surface& m, const Cut_options& options,
                                                    const Stage_runner& run, Disc_cut& cut)
{
  Generators g;
  g.genus = cut.genus;
  g.surface = Refined_surface(root);
  Generator_options generator_options;
  static_cast<Field_options&>(generator_options) = options;
  generator_options.preference = options.preference;
  const auto saddles = find_generators<SymmetricTraits, GeneralTraits>(root, m, generator_options, run, g);
  std::vector<Index> shared;
  for (const Generator_pair& pair : g.pairs)
  {
    cut.meridians.push_back(pair.meridian.vertices);
    cut.longitudes.push_back(pair.longitude.vertices);
    cut.saddles.push_back(pair.meridian.saddle);
    shared.push_back(pair.meridian.vertices.front());
  }
  cut.surface = std::move(g.surface);
  std::vector<Link_guide> guides;
  if (options.join != Generator_join::SURFACE) { run(Stage::FLOW, [&] { guides = guide_joins(m, make_morse_complex(m), saddles, shared, options.join); }); }
  return guides;
}

inline void cut_along_flow_lines(const Triangle_surface& root, const Ordered_surface& m, const Stage_runner& run, Disc_cut& cut)
{
  run(Stage::FLOW, [&] {
    const auto critical = find_critical_points(m.surface, m.rank);
    Flow_tracer tracer(m, true, critical);
    for (const Critical_point& p : critical) { if (p.kind == Critical_kind::SADDLE) { tracer.trace(p.vertex); } }
    std::vector<Surface_curve> curves;
    for (const Flow_line& line : tracer.lines()) { curves.push_back(line.curve); }
    cut.surface = m.surface;
    cut.flow_lines = insert_curves(root, cut.surface, curves).vertices;
  });
}

} // namespace internal

/*!
 * \ingroup PkgMeridianCut
 *
 * cuts a connected surface into a disc along smooth curves (Patane 2007, section 3).
 *
 * A harmonic field is ordered, simplified and unfolded; of its saddles' contours as many as there are handles are cut
 * as meridians (or generators, or the flow lines of all saddles); the boundaries that this leaves are joined by a tree of links. A
 * disc stays as it is.
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

  std::vector<Link_guide> guides;
  if (cut.genus > 0)
  {
    const Ordered_surface m = order_surface<SymmetricTraits, GeneralTraits>(root, options, run);
    static_cast<Field_summary&>(cut) = summarize_field(root, m);
    switch (options.method)
    {
    case Cut_method::CONTOURS: internal::cut_along_contours(root, m, options, run, cut); break;
    case Cut_method::GENERATORS: guides = internal::cut_along_generators<SymmetricTraits, GeneralTraits>(root, m, options, run, cut); break;
    case Cut_method::MORSE: internal::cut_along_flow_lines(root, m, run, cut); break;
    }
  }
  run(Stage::LINKS, [&] {
    if (options.link_domain == Link_domain::PLANE)
    {
      cut.link_note = link_boundaries_in_plane<SymmetricTraits>(root, cut.surface, options.links.source, cut.links);
      cut.links_in_plane = cut.link_note.empty();
      if (cut.links_in_plane) { return; }
    }
    Link_options links = options.links;
    links.guides = std::move(guides);
    links.progress = [&](double done) { run.progress(Stage::LINKS, done); };
    cut.links = link_boundaries(root, cut.surface, links);
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
