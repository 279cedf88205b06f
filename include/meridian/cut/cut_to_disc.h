// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_CUT_TO_DISC_H
#define MERIDIAN_CUT_CUT_TO_DISC_H

#include <meridian/base/Progress_observer.h>
#include <meridian/curves/project_contours.h>
#include <meridian/curves/snap_to_edges.h>
#include <meridian/cut/edge_cuts.h>
#include <meridian/cut/edge_cuts_near.h>
#include <meridian/cut/join_generators.h>
#include <meridian/cut/link_boundaries.h>
#include <meridian/cut/link_on_edges.h>
#include <meridian/cut/planar_links.h>
#include <meridian/cut/shorten_cut_graph.h>
#include <meridian/field/geodesic_distance.h>
#include <meridian/field/order_surface.h>
#include <meridian/handles/find_generators.h>
#include <meridian/handles/select_meridians.h>
#include <meridian/surface/open_along.h>
#include <meridian/surface/seam_paths.h>

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
  CONTOURS,      ///< a meridian for each handle (Patane 2007, section 3)
  GENERATORS,    ///< a meridian and a longitude for each handle (section 4)
  MORSE,         ///< the descending flow lines of all saddles (Ni, Garland, Hart 2004)
  GEODESIC,      ///< contours of the geodesic distance from a vertex (Steiner, Fischer 2002)
  TREE_COTREE,   ///< edges: the shortest loops at a base point (Erickson, Whittlesey 2005), for the best of several
  GEOMETRY_IMAGE ///< edges: what is left when faces are removed and keep a disc (Gu, Gortler, Hoppe 2002)
};

/// \ingroup PkgMeridianCut
/// what is made shorter before the surface is opened.
enum class Tightening
{
  NONE,   ///< curves stay as they were found
  CURVES, ///< meridians, each within its class; links are shortest paths between them anyway
  GRAPH   ///< the whole cut graph: its vertices move, and ways through the disc take the place of longer curves
};

/// \ingroup PkgMeridianCut
/// \returns the name of a tightening as it stands in reports
inline const char* name_of(Tightening t)
{
  return t == Tightening::NONE ? "no" : t == Tightening::CURVES ? "curves" : "graph";
}

/// \ingroup PkgMeridianCut
/// \returns the name of a method as it stands in reports
inline const char* name_of(Cut_method method)
{
  switch (method)
  {
  case Cut_method::CONTOURS: return "contours";
  case Cut_method::GENERATORS: return "generators";
  case Cut_method::MORSE: return "morse";
  case Cut_method::GEODESIC: return "geodesic";
  case Cut_method::TREE_COTREE: return "tree-cotree";
  case Cut_method::GEOMETRY_IMAGE: return "geometry-image";
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
  Levels levels = Levels::SADDLE;
  Tightening tightening = Tightening::CURVES;
  Tighten_options tighten_options;
  /// whether only edges of the surface are cut, so that there are no new vertices: meridians of contours are moved onto
  /// edges; for other curves, and with `GRAPH`, a cut graph of edges close by is taken
  bool on_edges = false;
  bool refine_where_needed = false; ///< with `on_edges`: divide edges where meridians cannot be moved onto them
  /// with `Cut_method::GEODESIC`: where distances begin, or -1; with `TREE_COTREE`: the base point
  Index source = -1;
  int bases = 16; ///< with `TREE_COTREE` and no source: how many base points are tried
  Link_domain link_domain = Link_domain::SURFACE;
  Link_options links;
  Progress_observer* observer = nullptr;
};

/// \ingroup PkgMeridianCut
/// a cut graph of one connected surface, and what was counted on the way.
struct Disc_cut : Field_summary
{
  Refined_surface surface;                    ///< the input, refined; the cut graph is its seam
  Opened_surface opened;                      ///< the disc
  std::vector<std::vector<Index>> meridians;  ///< closed, as vertices of `surface`, the most preferred first
  std::vector<std::vector<Index>> longitudes; ///< closed, of the same handles; with `Cut_method::GENERATORS`
  std::vector<std::vector<Index>> flow_lines; ///< open; with `Cut_method::MORSE`
  std::vector<std::vector<Index>> links;      ///< open, as vertices of `surface`
  /// open: the graph's paths, where they are none of these: with methods that cut edges and with `Tightening::GRAPH`
  std::vector<std::vector<Index>> paths;
  std::vector<Meridian_choice> choices; ///< the count after each meridian
  std::vector<Index> saddles;           ///< for each meridian, a vertex of its saddle
  int genus = 0, boundary_loops = 0;
  bool links_in_plane = false;
  std::string link_note;   ///< why links were not taken through the plane, if asked for
  double length = 0;       ///< of the seams
  double length_found = 0; ///< before the graph was tightened
  double smallest_angle_before = 0, smallest_angle_after = 0; ///< in radians
  Stage_times seconds;
};

namespace internal {

inline void cut_along_contours(const Triangle_surface& root, const Ordered_surface& m, const Cut_options& options,
                               const Stage_runner& run, Disc_cut& cut)
{
  Meridian_search search;
  run(Stage::CONTOURS, [&] { search.loops = trace_saddle_loops(m); });
  run(Stage::MERIDIANS, [&] {
    find_meridians(root, m, cut.genus, options.preference, search, options.levels);
    cut.choices = search.choices;
    for (const auto& choice : cut.choices) { cut.saddles.push_back(search.candidates[choice.loop].saddle); }
  });
  std::vector<Surface_curve> meridians;
  if (options.tightening != Tightening::NONE)
    run(Stage::TIGHTEN, [&] {
      Normal_curves curves(root, cut.genus);
      add_contours(project_crossings(root, m, search.chosen()), curves, 1);
      Tighten_options tightening = options.tighten_options;
      tightening.progress = [&](double done) { run.progress(Stage::TIGHTEN, done); };
      tighten_curves(curves, tightening);
      for (Index crossings : curves.count_crossings())
      {
        if (crossings > 0) { throw Internal_error("cut_to_disc: two meridians cross"); }
      }
      meridians = place_normal_curves(curves);
    });
  run(Stage::INSERT, [&] {
    if (options.tightening == Tightening::NONE) { meridians = project_contours(root, m, search.chosen()); }
    if (options.on_edges && options.tightening != Tightening::GRAPH)
    {
      meridians = snap_to_edges(root, meridians, options.refine_where_needed);
    }
    cut.meridians = insert_curves(root, cut.surface, meridians).vertices;
  });
}

// Cuts edges alone, of a surface that is no disc and no closed sphere already.
inline void cut_along_edges(const Triangle_surface& root, const Cut_options& options, const Stage_runner& run,
                            Disc_cut& cut)
{
  run(Stage::MERIDIANS, [&] {
    if (options.method == Cut_method::GEOMETRY_IMAGE) { flag_seam(cut.surface, cut_by_removing_faces(root)); }
    else if (options.source >= 0) { flag_seam(cut.surface, cut_by_tree_cotree(root, options.source)); }
    else
    {
      flag_seam(cut.surface, find_short_tree_cotree_cut(root, options.bases,
                                                        [&](double done) { run.progress(Stage::MERIDIANS, done); }));
    }
  });
  cut.paths = seam_paths(cut.surface);
}

// Takes the surface apart along its seams.
inline void open_cut(Disc_cut& cut)
{
  cut.opened = open_along(cut.surface);
  cut.length = 0;
  for (const auto& seam : cut.opened.seams) { cut.length += cut.surface.length(seam[0]); }
  cut.smallest_angle_after = smallest_angle(cut.surface);
}

inline double seam_length(const Refined_surface& s)
{
  double sum = 0;
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    if (s.seam[h] && s.edge(h) == h) { sum += s.length(h); }
  }
  return sum;
}

// Makes the whole graph shorter, or moves it onto edges.
inline void reshape_graph(const Triangle_surface& root, const Cut_options& options, const Stage_runner& run,
                          Disc_cut& cut)
{
  const bool is_on_edges = cut.surface.origins.empty();
  const bool is_sphere = cut.genus == 0 && cut.boundary_loops == 0; // opened along one shortest path
  const bool shorten = options.tightening == Tightening::GRAPH && !is_sphere;
  if (!shorten && (!options.on_edges || is_on_edges || options.refine_where_needed)) { return; }
  run(Stage::SHORTEN, [&] {
    Refined_surface s(root);
    std::vector<Index> edges = cut_of_edges_near(root, cut.surface, shorten ? 0 : 5);
    // fast, and a better beginning
    if (shorten) { edges = straighten_edge_cut(root, edges, Path_ends::SLIDE, options.on_edges ? 5 : 3); }
    flag_seam(s, edges);
    cut.paths = seam_paths(s);
    if (!options.on_edges)
    {
      Tighten_options tightening = options.tighten_options;
      tightening.progress = [&](double done) { run.progress(Stage::SHORTEN, done); };
      const auto curves = shorten_cut_graph(root, cut.paths, tightening);
      s = Refined_surface(root);
      cut.paths = insert_curves(root, s, curves).vertices;
    }
    cut.surface = std::move(s);
  });
  for (auto* curves : {&cut.meridians, &cut.longitudes, &cut.flow_lines, &cut.links}) { curves->clear(); }
}

inline std::vector<Link_guide> cut_along_generators(const Triangle_surface& root, const Ordered_surface& m,
                                             const Cut_options& options, const Stage_runner& run, Disc_cut& cut)
{
  Generators g;
  g.genus = cut.genus;
  g.surface = Refined_surface(root);
  Generator_options generator_options;
  static_cast<Field_options&>(generator_options) = options;
  generator_options.preference = options.preference;
  generator_options.levels = options.levels;
  generator_options.tighten = options.tightening != Tightening::NONE;
  generator_options.tightening = options.tighten_options;
  const auto saddles = find_generators(root, m, generator_options, run, g);
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
  if (options.join != Generator_join::SURFACE)
  {
    run(Stage::FLOW, [&] { guides = guide_joins(m, make_morse_complex(m), saddles, shared, options.join); });
  }
  return guides;
}

inline void cut_along_flow_lines(const Triangle_surface& root, const Ordered_surface& m, const Stage_runner& run,
                                 Disc_cut& cut)
{
  run(Stage::FLOW, [&] {
    const auto critical = find_critical_points(m.surface, m.rank);
    Flow_tracer tracer(m, true, critical);
    for (const Critical_point& p : critical)
    {
      if (p.kind == Critical_kind::SADDLE) { tracer.trace(p.vertex); }
    }
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
 * as meridians (or generators, or the flow lines of all saddles); the boundaries that this leaves are joined by a tree
 * of links. Other methods find a cut graph of edges. The graph may then be made shorter. A disc stays as it is.
 *
 * \param root the surface
 * \param options see there
 *
 * \returns the cut, which is topologically right however bad the shape of the faces is
 * \pre `root` is connected
 * \throws Invalid_input_error if minima and maxima coincide, or if only edges shall be cut and the mesh is too coarse;
 *   Solver_error if the field cannot be solved, Cancelled if the observer says so, Internal_error if an invariant broke
 * \par Complexity
 * One factorization, \f$ O(n^{1.5}) \f$, and \f$ O(n \log n) \f$ beside it.
 */
inline Disc_cut cut_to_disc(const Triangle_surface& root, const Cut_options& options = Cut_options())
{
  Disc_cut cut;
  const internal::Stage_runner run{options.observer, cut.seconds};

  cut.boundary_loops = static_cast<int>(boundary_loops(root).size());
  const int characteristic = root.number_of_vertices() - root.number_of_edges() + root.number_of_faces();
  cut.genus = (2 - characteristic - cut.boundary_loops) / 2;
  cut.smallest_angle_before = smallest_angle(root);
  cut.surface = Refined_surface(root);

  const bool is_disc = cut.genus == 0 && cut.boundary_loops == 1;
  const bool is_of_edges = options.method == Cut_method::TREE_COTREE || options.method == Cut_method::GEOMETRY_IMAGE;
  std::vector<Link_guide> guides;
  if (is_of_edges && !is_disc) { internal::cut_along_edges(root, options, run, cut); }
  if (cut.genus > 0 && !is_of_edges)
  {
    Field_options field = options;
    field.one_maximum = options.method == Cut_method::MORSE;
    if (options.method == Cut_method::GEODESIC)
      run(Stage::FIELD, [&] {
        const Closed_model g = make_closed_model(root);
        const Index source = options.source >= 0 ? options.source : g.representative[find_distant_nodes(root, g).first];
        field.values_name = "distance";
        field.values = geodesic_distance(root, {source}, options.solvers.symmetric);
      });
    const Ordered_surface m = order_surface(root, field, run);
    static_cast<Field_summary&>(cut) = summarize_field(root, m, field);
    switch (options.method)
    {
    case Cut_method::GEODESIC:
    case Cut_method::CONTOURS: internal::cut_along_contours(root, m, options, run, cut); break;
    case Cut_method::GENERATORS:
      guides = internal::cut_along_generators(root, m, options, run, cut);
      break;
    case Cut_method::MORSE: internal::cut_along_flow_lines(root, m, run, cut); break;
    default: break;
    }
  }
  run(Stage::LINKS, [&] {
    if (is_of_edges) { return; }
    if (options.on_edges && options.tightening != Tightening::GRAPH
        && (cut.genus == 0 || (options.method != Cut_method::GENERATORS && options.method != Cut_method::MORSE)))
    {
      cut.links = link_boundaries_on_edges(cut.surface, options.links.source);
      return;
    }
    if (options.link_domain == Link_domain::PLANE)
    {
      cut.link_note = link_boundaries_in_plane(root, cut.surface, options.links.source, cut.links, options.solvers.symmetric);
      cut.links_in_plane = cut.link_note.empty();
      if (cut.links_in_plane) { return; }
    }
    Link_options links = options.links;
    links.guides = std::move(guides);
    links.progress = [&](double done) { run.progress(Stage::LINKS, done); };
    cut.links = link_boundaries(root, cut.surface, links);
  });
  cut.length_found = internal::seam_length(cut.surface);
  if (!is_disc) { internal::reshape_graph(root, options, run, cut); }
  run(Stage::OPEN, [&] { internal::open_cut(cut); });
  return cut;
}

} // namespace meridian

#endif // MERIDIAN_CUT_CUT_TO_DISC_H
