#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "drape/base/assert.h"

namespace drape {

template <class Enum>
concept Enumeration = std::is_enum_v<Enum>;

/// An enumerator as the compiler writes it: "drape::Fabric::Silk". Any other value is a number behind a cast.
template <auto Value>
consteval std::string_view enumerator_text() {
    const std::string_view function = __PRETTY_FUNCTION__, mark = "Value = ";
    const std::size_t begin = function.find(mark) + mark.size();
    return function.substr(begin, function.find_first_of(";]", begin) - begin);
}

template <Enumeration Enum, std::size_t Value = 0>
consteval std::size_t count_values() {
    if constexpr (enumerator_text<static_cast<Enum>(Value)>().starts_with('(')) {
        return Value;
    } else {
        return count_values<Enum, Value + 1>();
    }
}

/// How many values an enumeration has: 0, 1, 2, ...
template <Enumeration Enum>
inline constexpr std::size_t enum_count = count_values<Enum>();

/// All of them.
template <Enumeration Enum>
std::vector<Enum> values_of() {
    std::vector<Enum> values;
    for (std::size_t k = 0; k < enum_count<Enum>; ++k) values.push_back(static_cast<Enum>(k));
    return values;
}

/// The name to show where it cannot follow from the enumerator's; empty: it follows.
template <auto Value>
inline constexpr std::string_view other_name = "";

/// A value's name as it is shown and read, which follows from the enumerator's: PrincipalStrain is "principal_strain".
template <auto Value>
std::string shown_name() {
    if (!other_name<Value>.empty()) return std::string(other_name<Value>);
    const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
    const std::string_view name = enumerator_text<Value>().substr(enumerator_text<Value>().rfind(':') + 1);
    std::string shown;
    for (std::size_t i = 0; i < name.size(); ++i) {
        if (i > 0 && is_capital(name[i]) && !is_capital(name[i - 1])) shown += '_';
        shown += static_cast<char>(is_capital(name[i]) ? name[i] - 'A' + 'a' : name[i]);
    }
    return shown;
}

/// All names, in the order of the values.
template <Enumeration Enum>
std::span<const std::string> names_of() {
    static_assert(enum_count<Enum> > 0, "the compiler writes enumerators in another way");
    static const auto names = []<std::size_t... values>(std::index_sequence<values...>) {
        return std::vector{shown_name<static_cast<Enum>(values)>()...};
    }
    (std::make_index_sequence<enum_count<Enum>>());
    return names;
}

template <Enumeration Enum>
const std::string& name_of(Enum value) {
    DRAPE_ASSERT(static_cast<std::size_t>(value) < enum_count<Enum>);
    return names_of<Enum>()[static_cast<std::size_t>(value)];
}

/// The value of a name; nothing if none is called so.
template <Enumeration Enum>
std::optional<Enum> value_named(std::string_view name) {
    const auto names = names_of<Enum>();
    const auto found = std::ranges::find(names, name);
    return found != names.end() ? std::optional(static_cast<Enum>(found - names.begin())) : std::nullopt;
}

}  // namespace drape
