// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_OPTIONS_H
#define MERIDIAN_OPTIONS_H

#include "commands.h"

#include <meridian/base/names.h>

#include <CLI/CLI.hpp>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace meridian {

enum class Tightening;
struct Pack_options;
struct Padding;

namespace program {

struct Field_arguments;
struct Cut_arguments;

// The options that several commands share, and what was given of them whose default cannot tell.

extern const char* const repair_help;

// An option whose value is the name of one of an enum's; its help lists them all with what they mean.
template <class Enum>
CLI::Option* add_choice(CLI::App& command, const char* option, std::function<void(Enum)> take,
                        const std::string& otherwise, std::string help)
{
  std::vector<std::string> names;
  for (const auto& v : Names<Enum>::table)
  {
    names.push_back(v.name);
    help += std::string("\n  ") + v.name + ": " + v.meaning;
  }
  return command
    .add_option_function<std::string>(
      option, [take](const std::string& name) { take(from_name<Enum>(name).value()); }, help)
    ->check(CLI::IsMember(names))
    ->default_str(otherwise);
}

template <class Enum> CLI::Option* add_choice(CLI::App& command, const char* option, Enum& value, std::string help)
{
  return add_choice<Enum>(
    command, option, [&value](const Enum& chosen) { value = chosen; }, name_of(value), help);
}

// Checks that a value is a number in a range; "nan" is none. `meaning`: what it is.
CLI::Validator number_from(double low, double high, const std::string& meaning);

void add_common_options(CLI::App& command, Common_arguments& a);
void add_field_options(CLI::App& command, Field_arguments& a);
// `tightened`: what is, by itself; `unless`: when that is not so.
void add_cut_options(CLI::App& command, Cut_arguments& a, Tightening tightened, const std::string& unless = "");
CLI::Option* add_resolution(CLI::App& command, const char* option, std::array<int, 2>& resolution, const char* help);
void add_pack_options(CLI::App& command, Pack_options& packing);
void check_padding(const Pack_options& packing); // throws Usage_error if it is too wide
Padding padding_of(const Pack_options& packing); // as it is recounted
double texels_of(const Pack_options& packing);   // the number of them
void note_field_options(const CLI::App& command, Field_arguments& a);
void note_cut_options(const CLI::App& command, Cut_arguments& a);

} // namespace program
} // namespace meridian

#endif // MERIDIAN_OPTIONS_H
