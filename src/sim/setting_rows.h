#pragma once

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "drape/sim/setting_table.h"

namespace drape {

/// A vector as a setting's value, and back.
inline std::vector<double> values_of(const Vec3& v) {
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}
inline Vec3 vector_of(const SettingValue& value) {
    const auto& list = std::get<std::vector<double>>(value);
    return {static_cast<Real>(list[0]), static_cast<Real>(list[1]), static_cast<Real>(list[2])};
}

/// Makes rows of the table for the members of one section.
/// @tparam Part the struct that holds the section's values
template <class Part>
class SectionRows {
public:
    /// Finds the index-th part of a section; a section that stands once ignores the index.
    using Find = Part& (*)(Settings&, std::size_t);

    SectionRows(std::string section, Find find, std::vector<Setting>& rows)
        : section_(std::move(section)), find_(find), rows_(rows) {}

    /// Adds a row whose value is converted by `to` (member to value) and `from` (value to member).
    template <class To, class From>
    void add(std::string name, SettingKind kind, std::string unit, Range range, std::vector<std::string> choices,
             std::string help, To to, From from) {
        const Find find = find_;
        rows_.push_back({section_, std::move(name), kind, std::move(unit), range, std::move(choices), std::move(help),
                         [find, to](const Settings& settings, std::size_t index) {
                             return SettingValue(to(find(const_cast<Settings&>(settings), index)));
                         },
                         [find, from](Settings& settings, std::size_t index, const SettingValue& value) {
                             from(find(settings, index), value);
                         }});
    }

    /// @param member pointer to a number of Part
    template <class Number>
    void number(std::string name, Number Part::*member, std::string unit, Range range, std::string help) {
        number_at(
            std::move(name), [member](Part& part) -> Number& { return part.*member; }, std::move(unit), range,
            std::move(help));
    }

    template <class At>
    void number_at(std::string name, At at, std::string unit, Range range, std::string help) {
        add(
            std::move(name), SettingKind::Number, std::move(unit), range, {}, std::move(help),
            [at](Part& part) { return static_cast<double>(at(part)); },
            [at](Part& part, const SettingValue& value) {
                using Number = std::remove_reference_t<decltype(at(part))>;
                at(part) = static_cast<Number>(std::get<double>(value));
            });
    }

    void integer(std::string name, int Part::*member, Range range, std::string help) {
        add(
            std::move(name), SettingKind::Integer, "", range, {}, std::move(help),
            [member](Part& part) { return static_cast<double>(part.*member); },
            [member](Part& part, const SettingValue& value) {
                part.*member = static_cast<int>(std::get<double>(value));
            });
    }

    /// @param range of the flag as a number: {0, 0} accepts only false
    void flag(std::string name, bool Part::*member, std::string help, Range range = {0, 1}) {
        add(
            std::move(name), SettingKind::Flag, "", range, {}, std::move(help),
            [member](Part& part) { return part.*member; },
            [member](Part& part, const SettingValue& value) { part.*member = std::get<bool>(value); });
    }

    template <class Enum>
    void choice(std::string name, Enum Part::*member, std::span<const std::string> names, std::string help) {
        std::vector<std::string> choices(names.begin(), names.end());
        add(
            std::move(name), SettingKind::Choice, "", {0, 0}, choices, std::move(help),
            [member, choices](Part& part) { return choices[static_cast<std::size_t>(part.*member)]; },
            [member, choices](Part& part, const SettingValue& value) {
                const auto& chosen = std::get<std::string>(value);
                for (std::size_t i = 0; i < choices.size(); ++i) {
                    if (choices[i] == chosen) part.*member = static_cast<Enum>(i);
                }
            });
    }

    void vector(std::string name, Vec3 Part::*member, std::string unit, Range range, std::string help) {
        add(
            std::move(name), SettingKind::Vector, std::move(unit), range, {}, std::move(help),
            [member](Part& part) { return values_of(part.*member); },
            [member](Part& part, const SettingValue& value) { part.*member = vector_of(value); });
    }

private:
    std::string section_;
    Find find_;
    std::vector<Setting>& rows_;
};

}  // namespace drape
