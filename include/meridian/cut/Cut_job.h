// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_CUT_JOB_H
#define MERIDIAN_CUT_CUT_JOB_H

#include <meridian/base/Stage_runner.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/cut/link_boundaries.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianCut
/// what a cut method is given, and what it fills.
///
/// The surface is connected, and no disc; `cut` knows its genus and boundary loops, and `cut.surface` is `root` itself.
/// A method refines `cut.surface`, flags the edges that it cuts as seams and names them in `cut.curves`. What is left
/// must be connected and of genus 0, or, if the method cuts edges alone, a disc. One that does not cut edges alone is
/// asked only where there are handles.
struct Cut_job
{
  const Triangle_surface& root;        ///< the surface
  const Cut_options& options;          ///< those that do not depend on the method
  const Stage_runner& run;             ///< each stage of the method's work is run by it
  Cut& cut;                            ///< what is filled
  std::vector<Link_guide> guides = {}; ///< ways for the links that follow, if the method has any
};

} // namespace meridian

#endif // MERIDIAN_CUT_CUT_JOB_H
