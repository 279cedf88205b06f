// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/internal/cut_methods.h>

#include <meridian/base/Progress_observer.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/curves/add_contours.h>
#include <meridian/curves/chords.h>
#include <meridian/curves/contours.h>
#include <meridian/curves/flow_lines.h>
#include <meridian/curves/morse_complex.h>
#include <meridian/curves/place_normal_curves.h>
#include <meridian/curves/project_contours.h>
#include <meridian/curves/snap_to_edges.h>
#include <meridian/curves/tighten_curves.h>
#include <meridian/cut/edge_cuts.h>
#include <meridian/cut/join_generators.h>
#include <meridian/field/Field.h>
#include <meridian/field/critical_points.h>
#include <meridian/handles/Generators.h>
#include <meridian/handles/find_generators.h>
#include <meridian/handles/find_meridians.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/insert_curves.h>
#include <meridian/surface/seam_paths.h>
#include <meridian/surface/seams.h>

#include <utility>

namespace meridian {

namespace internal {

void cut_along_contours(const Triangle_surface& root, const Ordered_surface& m, const Cut_options& options,
                        const Stage_runner& run, Cut& cut)
{
  Meridian_search search;
  run(Stage::CONTOURS, [&] { search.loops = trace_saddle_loops(m); });
  run(Stage::MERIDIANS, [&] {
    find_meridians(root, m, cut.genus, options.preference, search, options.levels);
    cut.choices = search.choices;
  });
  std::vector<Surface_curve> meridians;
  if (options.tightening != Tightening::NONE)
    run(Stage::TIGHTEN, [&] {
      Normal_curves curves(root, cut.genus);
      add_contours(project_crossings(root, m, search.chosen()), curves, 1);
      tighten_curves(curves, options.tighten_options, [&](double done) { run.progress(Stage::TIGHTEN, done); });
      for (Index crossings : count_crossings(curves))
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
    add_curves(cut, Curve_kind::MERIDIAN, insert_curves(root, cut.surface, meridians).vertices);
    for (std::size_t i = 0; i < cut.choices.size(); ++i)
    {
      cut.curves[i].saddle = search.candidates[cut.choices[i].loop].saddle;
    }
  });
}

void cut_along_edges(const Triangle_surface& root, const Cut_options& options, const Stage_runner& run, Cut& cut)
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
  add_curves(cut, Curve_kind::PATH, seam_paths(cut.surface));
}

std::vector<Link_guide> cut_along_generators(const Triangle_surface& root, const Ordered_surface& m,
                                             const Cut_options& options, const Stage_runner& run, Cut& cut)
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
    cut.curves.push_back({Curve_kind::MERIDIAN, pair.meridian.vertices, true, pair.meridian.saddle});
    cut.curves.push_back({Curve_kind::LONGITUDE, pair.longitude.vertices, true, -1});
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

void cut_along_flow_lines(const Triangle_surface& root, const Ordered_surface& m, const Stage_runner& run, Cut& cut)
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
    add_curves(cut, Curve_kind::FLOW_LINE, insert_curves(root, cut.surface, curves).vertices);
  });
}

} // namespace internal

} // namespace meridian
