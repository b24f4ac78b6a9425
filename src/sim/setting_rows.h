#pragma once

#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "drape/base/enum_names.h"
#include "drape/sim/setting_table.h"

namespace drape {

/// Lists of numbers as settings have them, and back.
inline std::vector<double> values_of(const Vec3& v) {
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}
inline std::vector<double> values_of(const Grid& grid) {
    return {static_cast<double>(grid.nx), static_cast<double>(grid.ny)};
}
std::vector<double> values_of(const std::vector<PathPoint>& path);
SettingValue values_of(const Pins& pins);

inline void take(const SettingValue& value, Vec3& v) {
    const auto& list = std::get<std::vector<double>>(value);
    v = {static_cast<Real>(list[0]), static_cast<Real>(list[1]), static_cast<Real>(list[2])};
}
inline void take(const SettingValue& value, Grid& grid) {
    const auto& list = std::get<std::vector<double>>(value);
    grid = {static_cast<int>(list[0]), static_cast<int>(list[1])};
}
void take(const SettingValue& value, std::vector<PathPoint>& path);
void take(const SettingValue& value, Pins& pins);

/// The kind of the settings that a member's type holds.
template <class Member>
consteval SettingKind kind_of() {
    if (std::is_same_v<Member, bool>) return SettingKind::Flag;
    if (std::is_same_v<Member, int>) return SettingKind::Integer;
    if (std::is_floating_point_v<Member>) return SettingKind::Number;
    if (NamedEnum<Member>) return SettingKind::Choice;
    if (std::is_same_v<Member, std::string>) return SettingKind::Text;
    if (std::is_same_v<Member, Grid>) return SettingKind::Grid;
    if (std::is_same_v<Member, Vec3>) return SettingKind::Vector;
    return std::is_same_v<Member, Pins> ? SettingKind::Pins : SettingKind::Path;
}

/// Makes rows of the table for the members of one section.
/// @tparam Values the struct that holds the section's values
template <class Values>
class SectionRows {
public:
    /// Finds the values of the index-th section of its kind; one that stands once ignores the index.
    using Find = std::function<Values&(Settings&, std::size_t)>;

    SectionRows(std::string section, Find find, std::vector<Setting>& rows)
        : section_(std::move(section)), find_(std::move(find)), rows_(rows) {}
    SectionRows(std::string section, Values Settings::*once, std::vector<Setting>& rows)
        : SectionRows(
              std::move(section), [once](Settings& s, std::size_t) -> Values& { return s.*once; }, rows) {}
    SectionRows(std::string section, std::vector<Values> Settings::*several, std::vector<Setting>& rows)
        : SectionRows(
              std::move(section), [several](Settings& s, std::size_t i) -> Values& { return (s.*several)[i]; }, rows) {}

    /// Adds a row whose value is converted by `to` (values to value) and `from` (value to values).
    template <class To, class From>
    void add(std::string name, SettingKind kind, std::string unit, Range range, std::string help, To to, From from) {
        rows_.push_back({section_,
                         std::move(name),
                         kind,
                         std::move(unit),
                         range,
                         {},
                         std::move(help),
                         [find = find_, to](const Settings& settings, std::size_t index) -> SettingValue {
                             return to(find(const_cast<Settings&>(settings), index));
                         },
                         [find = find_, from](Settings& settings, std::size_t index, const SettingValue& value) {
                             from(find(settings, index), value);
                         }});
    }

    /// Adds a row for a member, of the kind that its type has.
    /// @param at pointer to it, or a function that finds it
    template <class At>
    void add(std::string name, At at, std::string unit, Range range, std::string help) {
        using Member = std::remove_cvref_t<std::invoke_result_t<At&, Values&>>;
        add(
            std::move(name), kind_of<Member>(), std::move(unit), range, std::move(help),
            [at](Values& values) -> SettingValue {
                const Member& member = std::invoke(at, values);
                if constexpr (std::is_same_v<Member, bool> || std::is_same_v<Member, std::string>) {
                    return member;
                } else if constexpr (std::is_arithmetic_v<Member>) {
                    return static_cast<double>(member);
                } else if constexpr (NamedEnum<Member>) {
                    return name_of(member);
                } else {
                    return values_of(member);
                }
            },
            [at](Values& values, const SettingValue& value) {
                Member& member = std::invoke(at, values);
                if constexpr (std::is_same_v<Member, bool> || std::is_same_v<Member, std::string>) {
                    member = std::get<Member>(value);
                } else if constexpr (std::is_arithmetic_v<Member>) {
                    member = static_cast<Member>(std::get<double>(value));
                } else if constexpr (NamedEnum<Member>) {
                    member = value_named<Member>(std::get<std::string>(value)).value();
                } else {
                    take(value, member);
                }
            });
        if constexpr (NamedEnum<Member>) {
            const auto names = names_of<Member>();
            rows_.back().choices.assign(names.begin(), names.end());
        }
    }

    /// The same of flags, choices and texts.
    template <class At>
    void add(std::string name, At at, std::string help) {
        add(std::move(name), at, "", {0, 0}, std::move(help));
    }

private:
    std::string section_;
    Find find_;
    std::vector<Setting>& rows_;
};

}  // namespace drape
