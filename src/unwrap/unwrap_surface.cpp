// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/unwrap_surface.h>

#include <meridian/unwrap/internal/Chart_divider.h>
#include <meridian/unwrap/internal/Unwrapper.h>
#include <meridian/unwrap/internal/symmetric.h>

namespace meridian {

Unwrapping unwrap_surface(const Triangle_surface& root, const Unwrap_options& options)
{
  if (options.is_symmetric)
  {
    internal::check_symmetric(options);
    if (const auto mirror = find_mirror(root)) { return internal::unwrap_symmetric(root, options, *mirror); }
  }
  const bool is_one_chart = options.charts == 1 && options.seams.empty();
  return is_one_chart ? internal::Unwrapper(root, options).run() : internal::Chart_divider(root, options).run();
}

} // namespace meridian
