// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_BASE_CHOICES_H
#define MERIDIAN_BASE_CHOICES_H

#include <meridian/base/names.h>

#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <variant>

namespace meridian {

/// \ingroup PkgMeridianNames
/// the name of a type that is one choice of several with knobs of their own, and what it means in a few words. Such a
/// type has it as `static constexpr Choice_name names`.
struct Choice_name
{
  const char* name;    ///< in reports and options
  const char* meaning; ///< in a few words
};

/// \ingroup PkgMeridianNames
/// a choice with knobs of its own, as it is before anybody turned one, its name and what it means.
template <class Variant> struct Named_choice
{
  Variant (*make)();   ///< makes it, with its knobs as they are at first
  const char* name;    ///< in reports and options
  const char* meaning; ///< in a few words
};

/// \ingroup PkgMeridianNames
/// \param row a row of a table
/// \returns the choice that it names, with its knobs as they are at first
template <class Variant> Variant value_of(const Named_choice<Variant>& row) { return row.make(); }

namespace internal {

template <class Type, class = void> struct Has_names : std::false_type
{};
template <class Type> struct Has_names<Type, std::void_t<decltype(Type::names)>> : std::true_type
{};

template <class Variant, class Type> Variant make_choice() { return Type(); }

template <class Variant, class Type, std::size_t n>
constexpr void add_choice(std::array<Named_choice<Variant>, n>& table, std::size_t& size)
{
  if constexpr (Has_names<Type>::value)
  {
    table[size++] = {&make_choice<Variant, Type>, Type::names.name, Type::names.meaning};
  }
}

template <class... Type> constexpr auto table_of_choices()
{
  std::array<Named_choice<std::variant<Type...>>, (std::size_t(Has_names<Type>::value) + ...)> table{};
  std::size_t size = 0;
  (add_choice<std::variant<Type...>, Type>(table, size), ...);
  return table;
}

} // namespace internal

/// \ingroup PkgMeridianNames
/// the one table of choices that are types: of those that have `names`, in the order of the variant.
template <class... Type> struct Names<std::variant<Type...>>
{
  static constexpr auto table = internal::table_of_choices<Type...>();
};

/// \ingroup PkgMeridianNames
/// \returns the name of a choice as it stands in reports and options: that of its type, or its own member `name`
/// \param choice the choice
template <class... Type> std::string name_of(const std::variant<Type...>& choice)
{
  return std::visit(
    [](const auto& c) -> std::string {
      using Choice = std::decay_t<decltype(c)>;
      if constexpr (internal::Has_names<Choice>::value) { return Choice::names.name; }
      else { return c.name; }
    },
    choice);
}

} // namespace meridian

#endif // MERIDIAN_BASE_CHOICES_H
