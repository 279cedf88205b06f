// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_OPTIONS_H
#define MERIDIAN_OPTIONS_H

#include "commands.h"

#include <CLI/CLI.hpp>

namespace meridian {
namespace program {

// The options that several commands share, and what was given of them whose default cannot tell.

extern const char* const repair_help;

void add_common_options(CLI::App& command, Common_arguments& a);
void add_field_options(CLI::App& command, Field_arguments& a);
void add_cut_options(CLI::App& command, Cut_arguments& a);
void note_field_options(const CLI::App& command, Field_arguments& a);
void note_cut_options(const CLI::App& command, Cut_arguments& a);

} // namespace program
} // namespace meridian

#endif // MERIDIAN_OPTIONS_H
