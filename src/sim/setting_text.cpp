#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/sim/setting_table.h"

namespace drape {
namespace {

using Values = std::vector<double>;

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// "1, 2, 3" or "[1, 2, 3]" or "[[1, 2], [3, 4]]": the numbers in their order; nothing if there is anything else.
std::optional<Values> parse_list(std::string_view text) {
    Values values;
    int open = 0;
    for (std::string_view item : split_at_commas(text)) {
        for (item = trimmed(item); item.starts_with('['); item = trimmed(item.substr(1))) ++open;
        for (; open > 0 && item.ends_with(']'); item = trimmed(item.substr(0, item.size() - 1))) --open;
        const auto value = parse_real(item);
        if (!value) return std::nullopt;
        values.push_back(*value);
    }
    if (open != 0) return std::nullopt;
    return values;
}

/// A text that stays within its line in recordings, tables and the panel.
bool is_one_line(const std::string& text) {
    return std::none_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; });
}

bool in_range(const Range& range, double value) { return value >= range.low && value <= range.high; }

bool is_whole(double value) { return value == std::floor(value); }

/// How many numbers a list must have; 0 for any number of them.
std::size_t wanted_count(SettingKind kind) {
    switch (kind) {
        case SettingKind::Grid:
        case SettingKind::Size:
            return 2;
        case SettingKind::Vector:
            return 3;
        default:
            return 0;
    }
}

bool is_list(SettingKind kind) {
    return kind == SettingKind::Grid || kind == SettingKind::Size || kind == SettingKind::Vector ||
           kind == SettingKind::Pins || kind == SettingKind::Path;
}

bool accepts_list(const Setting& setting, const Values& values) {
    const std::size_t wanted = wanted_count(setting.kind);
    if (wanted != 0 && values.size() != wanted) return false;
    if (setting.kind == SettingKind::Path && values.size() % 4 != 0) return false;
    const bool whole = setting.kind == SettingKind::Grid || setting.kind == SettingKind::Pins;
    return std::all_of(values.begin(), values.end(),
                       [&](double v) { return in_range(setting.range, v) && (!whole || is_whole(v)); });
}

bool accepts(const Setting& setting, const SettingValue& value) {
    if (const auto* list = std::get_if<Values>(&value)) return is_list(setting.kind) && accepts_list(setting, *list);
    if (std::holds_alternative<bool>(value)) return setting.kind == SettingKind::Flag;
    if (const auto* number = std::get_if<double>(&value)) {
        if (setting.kind == SettingKind::Integer) return in_range(setting.range, *number) && is_whole(*number);
        return setting.kind == SettingKind::Number && in_range(setting.range, *number);
    }
    const auto& chosen = std::get<std::string>(value);
    if (setting.kind == SettingKind::Text) return is_one_line(chosen);
    return std::find(setting.choices.begin(), setting.choices.end(), chosen) != setting.choices.end();
}

std::string list_form(const Setting& setting) {
    switch (setting.kind) {
        case SettingKind::Grid:
            return "two whole numbers, each ";
        case SettingKind::Size:
            return "two numbers, each ";
        case SettingKind::Vector:
            return "three numbers, each ";
        case SettingKind::Path:
            return "rows of four numbers t,x,y,z, each ";
        case SettingKind::Pins:
            return listed(setting.choices) + " or a list of particle numbers, each ";
        default:
            return "";
    }
}

std::string range_text(const Setting& setting) {
    return real_text(setting.range.low) + " <= " + (is_list(setting.kind) ? "x" : setting.name) +
           " <= " + real_text(setting.range.high) + (setting.unit.empty() ? "" : " " + setting.unit);
}

// The menu's words, where a setting's name is none that a user of such programs expects
constexpr std::pair<std::string_view, std::string_view> words_of_the_menu[] = {
    {"solver.dt", "time step"},
    {"solver.on_unstable", "above the limit"},
    {"solver.ledger", "energy balance"},
    {"contact.volume", "bounding volume"},
    {"contact.update", "BVH update"},
    {"contact.leaf_cells", "leaf size"},
    {"contact.search_level", "search depth"},
    {"contact.self", "self-contact"},
    {"view.panel", "stats panel"},
    {"view.controls", "settings panel"},
    {"view.bounds", "bounding volumes"},
    {"view.colour", "colour by"},
};

}  // namespace

std::string setting_label(const Setting& setting) {
    const std::string full = setting.full_name();
    for (const auto& [name, words] : words_of_the_menu) {
        if (name == full) return std::string(words);
    }
    std::string label = setting.name == "on" ? setting.section : setting.name;
    std::ranges::replace(label, '_', ' ');
    std::ranges::replace(label, '.', ' ');
    return label;
}

std::string accepted(const Setting& setting) {
    switch (setting.kind) {
        case SettingKind::Flag:
            return "true or false";
        case SettingKind::Choice:
            return listed(setting.choices);
        case SettingKind::Text:
            return "a text of one line";
        case SettingKind::Integer:
            return "whole " + range_text(setting);
        default:
            return list_form(setting) + range_text(setting);
    }
}

std::string refusal(const Setting& setting, const SettingValue& value) {
    if (accepts(setting, value)) return {};
    return setting.full_name() + " = " + shortened(value_text(value)) + ": allowed " + accepted(setting);
}

SettingValue parse_value(const Setting& setting, std::string_view text) {
    const std::string_view word = trimmed(text);
    const auto refuse = [&]() -> SettingValue {
        throw InputError(setting.full_name() + " = " + shortened(word) + ": allowed " + accepted(setting));
    };
    if (setting.kind == SettingKind::Text) return std::string(word);
    if (setting.kind == SettingKind::Choice) {
        const bool quoted = word.size() >= 2 && word.front() == '"' && word.back() == '"';
        return std::string(quoted ? word.substr(1, word.size() - 2) : word);
    }
    if (setting.kind == SettingKind::Flag) {
        if (word == "true" || word == "on" || word == "1") return true;
        if (word == "false" || word == "off" || word == "0") return false;
        return refuse();
    }
    if (is_list(setting.kind)) {
        const bool named = std::find(setting.choices.begin(), setting.choices.end(), word) != setting.choices.end();
        if (named) return std::string(word);
        if (word == "[]") return Values{};
        auto list = parse_list(word);
        return list ? SettingValue(*std::move(list)) : refuse();
    }
    const auto number = parse_real(word);
    return number ? SettingValue(*number) : refuse();
}

std::string value_text(const SettingValue& value) {
    if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    if (const auto* number = std::get_if<double>(&value)) return real_text(*number);
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    std::string joined = "[";
    for (const double number : std::get<Values>(value)) joined += (joined.size() > 1 ? ", " : "") + real_text(number);
    return joined + "]";
}

const Setting& find_setting(std::string_view name) {
    const auto table = setting_table();
    std::vector<std::string> names, endings;
    const Setting* found = nullptr;
    for (const Setting& setting : table) {
        const std::string full = setting.full_name();
        names.push_back(full);
        names.push_back(setting.name);
        if (full == name) return setting;
        if (setting.name != name || setting.full_name_only) continue;
        found = &setting;
        endings.push_back(full);
    }
    if (endings.size() == 1) return *found;
    const std::string shown = shortened(name);
    if (endings.size() > 1) throw InputError("setting '" + shown + "' is ambiguous: say " + listed(endings));
    throw InputError("unknown setting '" + shown + "': did you mean '" + nearest_name(name, names) + "'?");
}

std::string settings_help() {
    Settings defaults;
    defaults.balls.emplace_back();
    defaults.solids.emplace_back();
    defaults.pins.emplace_back();
    std::string text;
    for (const Setting& setting : setting_table()) {
        std::string left = "  " + setting.full_name() + " = " + value_text(setting.read(defaults, 0));
        if (!setting.unit.empty()) left += " [" + setting.unit + "]";
        left.resize(std::max<std::size_t>(left.size() + 2, 46), ' ');
        text += left + setting.help + "; " + accepted(setting) + "\n";
    }
    return text;
}

}  // namespace drape
