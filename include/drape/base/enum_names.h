#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace drape {

/// Whether a value is one of its enumeration's: compilers print such a value by its name, any other as a number behind
/// a cast.
template <auto Value>
consteval bool is_enumerator() {
    return std::string_view(__PRETTY_FUNCTION__).find("Value = (") == std::string_view::npos;
}

/// The names of an enumeration's values 0, 1, 2, ... as they are shown and read. An enumeration that is shown has them
/// beside it, as in
///
///     template <>
///     inline constexpr auto enum_names<Plane> = all_names<Plane>("xz", "xy");
///
/// which does not compile with a name too few or too many.
template <class Enum>
inline constexpr std::nullptr_t enum_names = nullptr;

template <class Enum, class... Names>
consteval std::array<std::string_view, sizeof...(Names)> all_names(Names... names) {
    static_assert(!is_enumerator<static_cast<Enum>(sizeof...(Names))>(), "a value has no name");
    static_assert(is_enumerator<static_cast<Enum>(sizeof...(Names) - 1)>(), "a name has no value");
    return {names...};
}

template <class Enum>
concept NamedEnum = std::is_enum_v<Enum> && !std::is_null_pointer_v<std::remove_cv_t<decltype(enum_names<Enum>)>>;

/// All names, in the order of the values.
template <NamedEnum Enum>
std::span<const std::string> names_of() {
    static const std::vector<std::string> names(enum_names<Enum>.begin(), enum_names<Enum>.end());
    return names;
}

template <NamedEnum Enum>
const std::string& name_of(Enum value) {
    return names_of<Enum>()[static_cast<std::size_t>(value)];
}

/// The value of a name; nothing if none is called so.
template <NamedEnum Enum>
constexpr std::optional<Enum> value_named(std::string_view name) {
    for (std::size_t i = 0; i < enum_names<Enum>.size(); ++i) {
        if (enum_names<Enum>[i] == name) return static_cast<Enum>(i);
    }
    return std::nullopt;
}

}  // namespace drape
