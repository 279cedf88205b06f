// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_PAGE_FORMAT_PAGE_H
#define MERIDIAN_PAGE_FORMAT_PAGE_H

#include <meridian/assemble_result.h>

namespace meridian {
namespace page {

// A self-contained page that shows the surface shaded by its field, with the cut drawn over it.
std::string format_page(const std::string& title, const Examination& examination, const std::vector<Disc_cut>& cuts,
                        const Assembled_result& assembled);

} // namespace page
} // namespace meridian

#endif // MERIDIAN_PAGE_FORMAT_PAGE_H
