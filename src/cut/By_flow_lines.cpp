// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/By_flow_lines.h>

#include <meridian/base/Progress_observer.h>
#include <meridian/curves/flow_lines.h>
#include <meridian/cut/internal/cut_along_contours.h>
#include <meridian/field/critical_points.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/insert_curves.h>

#include <vector>

namespace meridian {

void By_flow_lines::cut_handles(Cut_job& job) const
{
  const Ordered_surface m = internal::order_for_cut(job, *this, true);
  job.run(Stage::FLOW, [&] {
    const auto critical = find_critical_points(m.surface, m.rank);
    Flow_tracer tracer(m, true, critical);
    for (const Critical_point& p : critical)
    {
      if (p.kind == Critical_kind::SADDLE) { tracer.trace(p.vertex); }
    }
    std::vector<Surface_curve> curves;
    for (const Flow_line& line : tracer.lines()) { curves.push_back(line.curve); }
    job.cut.surface = m.surface;
    add_curves(job.cut, Curve_kind::FLOW_LINE, insert_curves(job.root, job.cut.surface, curves).vertices);
  });
}

} // namespace meridian
