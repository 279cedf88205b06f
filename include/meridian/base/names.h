// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_BASE_NAMES_H
#define MERIDIAN_BASE_NAMES_H

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace meridian {

/// \ingroup PkgMeridianNames
/// a value of an enum, its name in reports and options, and what it means in a few words.
template <class Enum> struct Named_value
{
  Enum value;
  const char *name, *meaning;
};

/// \ingroup PkgMeridianNames
/// the one table of an enum. It is specialized beside each enum that has names, with an array `table` of
/// `Named_value`s in the order of their declaration. Reports, the program's options and the tests read it.
template <class Enum> struct Names;

/// \ingroup PkgMeridianNames
/// how many values an enum has.
template <class Enum> constexpr std::size_t number_of = Names<Enum>::table.size();

/// \ingroup PkgMeridianNames
/// \returns all values of an enum, in the order of their declaration
template <class Enum> constexpr std::array<Enum, number_of<Enum>> all()
{
  std::array<Enum, number_of<Enum>> values{};
  for (std::size_t i = 0; i < values.size(); ++i) { values[i] = Names<Enum>::table[i].value; }
  return values;
}

namespace internal {

template <class Enum> constexpr bool is_in_order()
{
  for (std::size_t i = 0; i < number_of<Enum>; ++i)
  {
    if (static_cast<std::size_t>(Names<Enum>::table[i].value) != i) { return false; }
  }
  return true;
}

} // namespace internal

/// \ingroup PkgMeridianNames
/// \returns the name of a value as it stands in reports and options
/// \throws std::out_of_range if the table does not have it
template <class Enum, class Table = decltype(Names<Enum>::table)> constexpr const char* name_of(Enum value)
{
  static_assert(internal::is_in_order<Enum>(), "the table has other values, or in another order");
  return Names<Enum>::table.at(static_cast<std::size_t>(value)).name;
}

/// \ingroup PkgMeridianNames
/// \returns the value that a name stands for, if there is one
template <class Enum> std::optional<Enum> from_name(const std::string& name)
{
  for (const auto& v : Names<Enum>::table)
  {
    if (name == v.name) { return v.value; }
  }
  return std::nullopt;
}

} // namespace meridian

#endif // MERIDIAN_BASE_NAMES_H
