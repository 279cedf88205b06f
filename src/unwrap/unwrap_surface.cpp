// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/unwrap_surface.h>

#include <meridian/unwrap/internal/Chart_divider.h>
#include <meridian/unwrap/internal/Unwrapper.h>

namespace meridian {

Unwrapping unwrap_surface(const Triangle_surface& root, const Unwrap_options& options)
{
  const bool is_one_chart = options.charts == 1 && options.seams.empty();
  return is_one_chart ? internal::Unwrapper(root, options).run() : internal::Chart_divider(root, options).run();
}

} // namespace meridian
