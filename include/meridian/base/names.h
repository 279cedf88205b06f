// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_BASE_NAMES_H
#define MERIDIAN_BASE_NAMES_H

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>

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
/// the one table of an enum, or of a variant of choices. It is specialized beside each enum that has names, with an
/// array `table` of `Named_value`s in the order of their declaration. Reports, the program's options and the tests read
/// it.
template <class Enum> struct Names;

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

template <class Enum> constexpr Enum value_of(const Named_value<Enum>& v) { return v.value; }
template <class Variant> Variant value_of(const Named_choice<Variant>& v) { return v.make(); }

} // namespace internal

/// \ingroup PkgMeridianNames
/// the one table of choices that are types: of those that have `names`, in the order of the variant.
template <class... Type> struct Names<std::variant<Type...>>
{
  static constexpr auto table = internal::table_of_choices<Type...>(); ///< one row a choice
};

/// \ingroup PkgMeridianNames
/// how many values an enum has.
template <class Enum> constexpr std::size_t number_of = Names<Enum>::table.size();

/// \ingroup PkgMeridianNames
/// \returns all values of an enum, in the order of their declaration
template <class Enum> constexpr std::array<Enum, number_of<Enum>> all()
{
  std::array<Enum, number_of<Enum>> values{};
  for (std::size_t i = 0; i < values.size(); ++i) { values[i] = internal::value_of(Names<Enum>::table[i]); }
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

/// \ingroup PkgMeridianNames
/// \returns the value that a name stands for, if there is one
/// \param name the name, as `name_of()` gives it
template <class Enum> std::optional<Enum> from_name(const std::string& name)
{
  for (const auto& v : Names<Enum>::table)
  {
    if (name == v.name) { return internal::value_of(v); }
  }
  return std::nullopt;
}

} // namespace meridian

#endif // MERIDIAN_BASE_NAMES_H
