#pragma once

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "drape/base/enum_names.h"
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
/// @tparam Values the struct that holds the section's values
template <class Values>
class SectionRows {
public:
    /// Finds the values of the index-th section of its kind; one that stands once ignores the index.
    using Find = Values& (*)(Settings&, std::size_t);

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

    /// @param member pointer to a number of Values
    template <class Number>
    void number(std::string name, Number Values::*member, std::string unit, Range range, std::string help) {
        number_at(
            std::move(name), [member](Values& values) -> Number& { return values.*member; }, std::move(unit), range,
            std::move(help));
    }

    template <class At>
    void number_at(std::string name, At at, std::string unit, Range range, std::string help) {
        add(
            std::move(name), SettingKind::Number, std::move(unit), range, {}, std::move(help),
            [at](Values& values) { return static_cast<double>(at(values)); },
            [at](Values& values, const SettingValue& value) {
                using Number = std::remove_reference_t<decltype(at(values))>;
                at(values) = static_cast<Number>(std::get<double>(value));
            });
    }

    void integer(std::string name, int Values::*member, Range range, std::string help) {
        add(
            std::move(name), SettingKind::Integer, "", range, {}, std::move(help),
            [member](Values& values) { return static_cast<double>(values.*member); },
            [member](Values& values, const SettingValue& value) {
                values.*member = static_cast<int>(std::get<double>(value));
            });
    }

    void flag(std::string name, bool Values::*member, std::string help) {
        add(
            std::move(name), SettingKind::Flag, "", {0, 1}, {}, std::move(help),
            [member](Values& values) { return values.*member; },
            [member](Values& values, const SettingValue& value) { values.*member = std::get<bool>(value); });
    }

    template <NamedEnum Enum>
    void choice(std::string name, Enum Values::*member, std::string help) {
        const auto names = names_of<Enum>();
        add(
            std::move(name), SettingKind::Choice, "", {0, 0}, {names.begin(), names.end()}, std::move(help),
            [member](Values& values) { return name_of(values.*member); },
            [member](Values& values, const SettingValue& value) {
                values.*member = value_named<Enum>(std::get<std::string>(value)).value();
            });
    }

    void vector(std::string name, Vec3 Values::*member, std::string unit, Range range, std::string help) {
        add(
            std::move(name), SettingKind::Vector, std::move(unit), range, {}, std::move(help),
            [member](Values& values) { return values_of(values.*member); },
            [member](Values& values, const SettingValue& value) { values.*member = vector_of(value); });
    }

private:
    std::string section_;
    Find find_;
    std::vector<Setting>& rows_;
};

}  // namespace drape
