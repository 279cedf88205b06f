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
  Enum value;          ///< of the enum
  const char* name;    ///< in reports and options
  const char* meaning; ///< in a few words
};

/// \ingroup PkgMeridianNames
/// the one table of an enum, or of a variant of choices (`base/choices.h`). It is specialized beside each enum that has
/// names, with an array `table` of `Named_value`s in the order of their declaration. Reports, the program's options and
/// the tests read it.
template <class Enum> struct Names;

/// \ingroup PkgMeridianNames
/// \param row a row of a table
/// \returns the value that it names
template <class Enum> constexpr Enum value_of(const Named_value<Enum>& row) { return row.value; }

/// \ingroup PkgMeridianNames
/// how many values an enum has.
template <class Enum> constexpr std::size_t number_of = Names<Enum>::table.size();

/// \ingroup PkgMeridianNames
/// \returns all values of an enum, in the order of their declaration
template <class Enum> constexpr std::array<Enum, number_of<Enum>> all()
{
  std::array<Enum, number_of<Enum>> values{};
  for (std::size_t i = 0; i < values.size(); ++i) { values[i] = value_of(Names<Enum>::table[i]); }
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
/// \param value the value
/// \throws std::out_of_range if the table does not have it
template <class Enum, class Table = decltype(Names<Enum>::table)> constexpr const char* name_of(Enum value)
{
  static_assert(internal::is_in_order<Enum>(), "the table has other values, or in another order");
  return Names<Enum>::table.at(static_cast<std::size_t>(value)).name;
}

/// \ingroup PkgMeridianNames
/// \returns the value that a name stands for, if there is one
/// \param name the name, as `name_of()` gives it
template <class Enum> std::optional<Enum> from_name(const std::string& name)
{
  for (const auto& v : Names<Enum>::table)
  {
    if (name == v.name) { return value_of(v); }
  }
  return std::nullopt;
}

} // namespace meridian

#endif // MERIDIAN_BASE_NAMES_H
