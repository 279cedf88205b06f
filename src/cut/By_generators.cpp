// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/By_generators.h>

#include <meridian/base/Progress_observer.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/morse_complex.h>
#include <meridian/cut/internal/cut_along_contours.h>
#include <meridian/handles/Generators.h>
#include <meridian/handles/find_generators.h>
#include <meridian/surface/Refined_surface.h>

#include <utility>
#include <vector>

namespace meridian {

void By_generators::cut_handles(Cut_job& job) const
{
  Ordered_surface m = internal::order_for_cut(job, *this);
  m.placement = placement;
  Generators g;
  g.genus = job.cut.genus;
  g.surface = Refined_surface(job.root);
  Generator_options generator_options;
  static_cast<Field_options&>(generator_options) = *this;
  static_cast<Meridian_options&>(generator_options) = *this;
  generator_options.tighten = job.options.tightening != Tightening::NONE;
  generator_options.tightening = job.options.tighten_options;
  generator_options.solvers = job.options.solvers;
  const auto saddles = internal::find_generators(job.root, m, generator_options, job.run, g);
  std::vector<Index> shared;
  for (const Generator_pair& pair : g.pairs)
  {
    job.cut.curves.push_back({Curve_kind::MERIDIAN, pair.meridian.vertices, true, pair.meridian.saddle});
    job.cut.curves.push_back({Curve_kind::LONGITUDE, pair.longitude.vertices, true, -1});
    shared.push_back(pair.meridian.vertices.front());
  }
  job.cut.surface = std::move(g.surface);
  if (join != Generator_join::SURFACE)
  {
    job.run(Stage::FLOW, [&] { job.guides = internal::guide_joins(m, make_morse_complex(m), saddles, shared, join); });
  }
}

} // namespace meridian
