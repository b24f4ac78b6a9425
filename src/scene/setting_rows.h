#pragma once

#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "drape/base/enum_names.h"
#include "drape/scene/setting_table.h"

namespace drape {

/// A member of a section as its setting's value.
template <class Member>
SettingValue setting_value(const Member& member) {
    if constexpr (Enumeration<Member>) {
        return name_of(member);
    } else if constexpr (std::is_arithmetic_v<Member> && !std::is_same_v<Member, bool>) {
        return static_cast<double>(member);
    } else {
        return member;
    }
}
SettingValue setting_value(const Vec3& v);
SettingValue setting_value(const Grid& grid);
SettingValue setting_value(const Pins& pins);
SettingValue setting_value(const std::vector<PathPoint>& path);

/// Gives a member the value of its setting.
template <class Member>
void take(const SettingValue& value, Member& member) {
    if constexpr (Enumeration<Member>) {
        member = value_named<Member>(std::get<std::string>(value)).value();
    } else if constexpr (std::is_arithmetic_v<Member> && !std::is_same_v<Member, bool>) {
        member = static_cast<Member>(std::get<double>(value));
    } else {
        member = std::get<Member>(value);
    }
}
void take(const SettingValue& value, Vec3& v);
void take(const SettingValue& value, Grid& grid);
void take(const SettingValue& value, Pins& pins);
void take(const SettingValue& value, std::vector<PathPoint>& path);

/// The kind of the settings that a member's type holds.
template <class Member>
consteval SettingKind kind_of() {
    if (std::is_same_v<Member, bool>) return SettingKind::Flag;
    if (std::is_same_v<Member, int>) return SettingKind::Integer;
    if (std::is_floating_point_v<Member>) return SettingKind::Number;
    if (Enumeration<Member>) return SettingKind::Choice;
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

    /// The rows of a section that may stand several times.
    /// @tparam entries the member of `Settings` that holds them
    template <std::vector<Values> Settings::*entries>
    static SectionRows of_several(std::string section, std::vector<Setting>& rows) {
        static constexpr SeveralSections several{[](const Settings& s) { return (s.*entries).size(); },
                                                 [](Settings& s) { (s.*entries).emplace_back(); }};
        SectionRows of_section(
            std::move(section), [](Settings& s, std::size_t i) -> Values& { return (s.*entries)[i]; }, rows);
        of_section.several_ = &several;
        return of_section;
    }

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
                         },
                         several_});
    }

    /// Adds a row for a member, of the kind that its type has.
    /// @param at pointer to it, or a function that finds it
    template <class At>
    void add(std::string name, At at, std::string unit, Range range, std::string help) {
        using Member = std::remove_cvref_t<std::invoke_result_t<At&, Values&>>;
        add(
            std::move(name), kind_of<Member>(), std::move(unit), range, std::move(help),
            [at](Values& values) { return setting_value(std::invoke(at, values)); },
            [at](Values& values, const SettingValue& value) { take(value, std::invoke(at, values)); });
        if constexpr (Enumeration<Member>) {
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
    const SeveralSections* several_ = nullptr;
    std::vector<Setting>& rows_;
};

}  // namespace drape
