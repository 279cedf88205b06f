// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_INTERNAL_CUT_ALONG_CONTOURS_H
#define MERIDIAN_CUT_INTERNAL_CUT_ALONG_CONTOURS_H

#include <meridian/cut/Cut_job.h>
#include <meridian/field/Field.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/handles/find_meridians.h>
#include <meridian/handles/preference.h>
#include <meridian/surface/Surface_curve.h>

#include <vector>

namespace meridian {

namespace internal {

// Orders the surface of a cut by a field, and says in the cut what field it was.
Ordered_surface order_for_cut(Cut_job& job, const Field_options& field, bool one_maximum = false);

// The meridians of a surface as curves on it, one for each handle, tight if that is asked for. `search` receives what
// they were chosen from.
std::vector<Surface_curve> find_cut_meridians(Cut_job& job, const Field_options& field, const Meridian_options& choice,
                                              Meridian_search& search);

// Cuts a meridian for each handle, a contour of a field.
void cut_along_contours(Cut_job& job, const Field_options& field, const Meridian_options& choice);

} // namespace internal

} // namespace meridian

#endif // MERIDIAN_CUT_INTERNAL_CUT_ALONG_CONTOURS_H
