// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_FAMILY_H
#define MERIDIAN_CUT_FAMILY_H

/// \file
/// Finds many cuts of one surface, and compares them.

#include <meridian/unwrap/cut_family.h>

#endif // MERIDIAN_CUT_FAMILY_H
