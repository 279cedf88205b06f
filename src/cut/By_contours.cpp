// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/By_contours.h>

#include <meridian/base/Progress_observer.h>
#include <meridian/base/exceptions.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/curves/add_contours.h>
#include <meridian/curves/chords.h>
#include <meridian/curves/contours.h>
#include <meridian/curves/place_normal_curves.h>
#include <meridian/curves/project_contours.h>
#include <meridian/curves/snap_to_edges.h>
#include <meridian/curves/tighten_curves.h>
#include <meridian/cut/internal/cut_along_contours.h>
#include <meridian/field/order_surface.h>
#include <meridian/handles/find_meridians.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/insert_curves.h>

#include <vector>

namespace meridian {

namespace internal {

namespace {

// The meridians, tightened, as curves on the surface.
std::vector<Surface_curve> tighten_meridians(const Cut_job& job, const Ordered_surface& m,
                                             const std::vector<const Contour*>& loops)
{
  Normal_curves curves(job.root, job.cut.genus);
  add_contours(project_crossings(job.root, m, loops), curves, 1);
  tighten_curves(curves, job.options.tighten_options, [&](double done) { job.run.progress(Stage::TIGHTEN, done); });
  for (Index crossings : count_crossings(curves))
  {
    if (crossings > 0) { throw Internal_error("cut_to_disc: two meridians cross"); }
  }
  return place_normal_curves(curves);
}

} // namespace

Ordered_surface order_for_cut(Cut_job& job, const Field_options& field, bool one_maximum)
{
  Ordered_surface m = order_surface(job.root, {field, one_maximum, job.options.solvers}, job.run);
  static_cast<Field_summary&>(job.cut) = summarize_field(job.root, m);
  return m;
}

std::vector<Surface_curve> find_cut_meridians(Cut_job& job, const Field_options& field, const Meridian_options& choice,
                                              Meridian_search& search)
{
  Ordered_surface m = order_for_cut(job, field);
  m.placement = choice.placement;
  job.run(Stage::CONTOURS, [&] { search.loops = trace_saddle_loops(m); });
  job.run(Stage::MERIDIANS,
          [&] { find_meridians(job.root, m, job.cut.genus, choice.preference, search, choice.levels); });
  std::vector<Surface_curve> meridians;
  if (job.options.tightening == Tightening::NONE)
  {
    job.run(Stage::INSERT, [&] { meridians = project_contours(job.root, m, search.chosen()); });
  }
  else
  {
    job.run(Stage::TIGHTEN, [&] { meridians = tighten_meridians(job, m, search.chosen()); });
  }
  return meridians;
}

void cut_along_contours(Cut_job& job, const Field_options& field, const Meridian_options& choice)
{
  const Triangle_surface& root = job.root;
  const Cut_options& options = job.options;
  Cut& cut = job.cut;
  Meridian_search search;
  std::vector<Surface_curve> meridians = find_cut_meridians(job, field, choice, search);
  cut.choices = search.choices;
  job.run(Stage::INSERT, [&] {
    if (options.on_edges && options.tightening != Tightening::GRAPH)
    {
      meridians = snap_to_edges(root, meridians, options.refine_where_needed);
    }
    cut.surface = Refined_surface(root);
    add_curves(cut, Curve_kind::MERIDIAN, insert_curves(root, cut.surface, meridians).vertices);
    for (std::size_t i = 0; i < cut.choices.size(); ++i)
    {
      cut.curves[i].saddle = search.candidates[cut.choices[i].loop].saddle;
    }
  });
}

} // namespace internal

void By_contours::cut_handles(Cut_job& job) const { internal::cut_along_contours(job, *this, *this); }

} // namespace meridian
