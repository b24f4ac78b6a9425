#include "toml_value.h"

#include <sstream>

#include "drape/base/input_error.h"

namespace drape {
namespace {

std::optional<double> number_of(const toml::node& node) {
    if (const auto* real = node.as_floating_point()) return real->get();
    if (const auto* integer = node.as_integer()) return static_cast<double>(integer->get());
    return std::nullopt;
}

/// The numbers of an array, or of its rows one after another where rows are wanted.
bool append_numbers(const toml::array& array, bool rows, std::vector<double>& values) {
    for (const toml::node& entry : array) {
        if (rows) {
            const toml::array* row = entry.as_array();
            if (row == nullptr || row->size() != 4 || !append_numbers(*row, false, values)) return false;
        } else {
            const auto number = number_of(entry);
            if (!number) return false;
            values.push_back(*number);
        }
    }
    return true;
}

}  // namespace

toml::table parse_toml(std::string_view text, const std::string& file) {
    try {
        return toml::parse(text, file);
    } catch (const toml::parse_error& error) {
        const auto& begin = error.source().begin;
        throw InputError(file + ":" + std::to_string(begin.line) + ":" + std::to_string(begin.column) + ": " +
                         std::string(error.description()));
    }
}

std::optional<SettingValue> toml_value(const toml::node& node, SettingKind kind) {
    switch (kind) {
        case SettingKind::Flag:
            if (const auto* flag = node.as_boolean()) return flag->get();
            return std::nullopt;
        case SettingKind::Integer:
        case SettingKind::Number:
            if (const auto number = number_of(node)) return *number;
            return std::nullopt;
        case SettingKind::Choice:
            if (const auto* flag = node.as_boolean()) return std::string(flag->get() ? "true" : "false");
            [[fallthrough]];
        case SettingKind::Text:
            if (const auto* text = node.as_string()) return text->get();
            return std::nullopt;
        case SettingKind::Pins:
            if (const auto* name = node.as_string()) return name->get();
            [[fallthrough]];
        case SettingKind::Grid:
        case SettingKind::Size:
        case SettingKind::Vector:
        case SettingKind::Path: {
            std::vector<double> values;
            const toml::array* array = node.as_array();
            if (array == nullptr || !append_numbers(*array, kind == SettingKind::Path, values)) return std::nullopt;
            return values;
        }
    }
    return std::nullopt;
}

std::string toml_text(const toml::node& node) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    node.visit([&out](const auto& value) {
        if constexpr (toml::is_table<decltype(value)>) {
            out << "a table";
        } else if constexpr (toml::is_array<decltype(value)>) {
            out << toml::default_formatter(value);
        } else {
            out << value;
        }
    });
    return shortened(out.str());
}

}  // namespace drape
