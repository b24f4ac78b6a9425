#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/scene/setting_table.h"

namespace drape {
namespace {

using Values = std::vector<double>;

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
    return std::ranges::none_of(text, [](char c) { return static_cast<unsigned char>(c) < ' '; });
}

bool in_range(const Range& range, double value) { return value >= range.low && value <= range.high; }

bool is_whole(double value) { return value == std::floor(value); }

/// What a list of numbers has to be; of none of them, a setting that is no list.
struct ListForm {
    std::size_t numbers = 0;  ///< of each row
    bool one_row = true;
    bool whole = false;
    std::string text = {};  ///< what an error says before the range
};

ListForm list_form(const Setting& setting) {
    switch (setting.kind) {
        case SettingKind::Grid:
            return {2, true, true, "two whole numbers, each "};
        case SettingKind::Size:
            return {2, true, false, "two numbers, each "};
        case SettingKind::Vector:
            return {3, true, false, "three numbers, each "};
        case SettingKind::Path:
            return {4, false, false, "rows of four numbers t,x,y,z, each "};
        case SettingKind::Pins:
            return {1, false, true, listed(setting.choices) + " or a list of particle numbers, each "};
        default:
            return {};
    }
}

bool is_list(const Setting& setting) { return list_form(setting).numbers > 0; }

bool accepts_list(const Setting& setting, const Values& values) {
    const ListForm form = list_form(setting);
    if (form.numbers == 0 || values.size() % form.numbers != 0) return false;
    if (form.one_row && values.size() != form.numbers) return false;
    return std::ranges::all_of(values,
                               [&](double v) { return in_range(setting.range, v) && (!form.whole || is_whole(v)); });
}

bool accepts(const Setting& setting, const SettingValue& value) {
    if (const auto* list = std::get_if<Values>(&value)) return accepts_list(setting, *list);
    if (std::holds_alternative<bool>(value)) return setting.kind == SettingKind::Flag;
    if (const auto* number = std::get_if<double>(&value)) {
        if (setting.kind == SettingKind::Integer) return in_range(setting.range, *number) && is_whole(*number);
        return setting.kind == SettingKind::Number && in_range(setting.range, *number);
    }
    const auto& chosen = std::get<std::string>(value);
    if (setting.kind == SettingKind::Text) return is_one_line(chosen);
    return std::ranges::count(setting.choices, chosen) > 0;
}

std::string range_text(const Setting& setting) {
    return real_text(setting.range.low) + " <= " + (is_list(setting) ? "x" : setting.name) +
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
            return list_form(setting).text + range_text(setting);
    }
}

std::string refusal(const Setting& setting, const SettingValue& value) {
    if (accepts(setting, value)) return {};
    return setting.full_name() + " = " + shortened(value_text(value)) + ": allowed " + accepted(setting);
}

SettingValue parse_value(const Setting& setting, std::string_view text) {
    const std::string_view word = trimmed(text);
    const bool is_quoted = word.size() >= 2 && word.front() == '"' && word.back() == '"';
    if (setting.word && word == setting.word->text) return setting.word->value;
    if (setting.kind == SettingKind::Flag) {
        if (word == "true" || word == "on" || word == "1") return true;
        if (word == "false" || word == "off" || word == "0") return false;
    } else if (setting.kind == SettingKind::Integer || setting.kind == SettingKind::Number) {
        if (const auto number = parse_real(word)) return *number;
    } else if (is_list(setting)) {
        if (word == "[]") return Values{};
        if (auto list = parse_list(word)) return *std::move(list);
    } else if (setting.kind == SettingKind::Choice && is_quoted) {
        return std::string(word.substr(1, word.size() - 2));
    }
    return std::string(word);
}

std::string value_text(const SettingValue& value) {
    if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    if (const auto* number = std::get_if<double>(&value)) return real_text(*number);
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    std::string joined = "[";
    for (const double number : std::get<Values>(value)) joined += (joined.size() > 1 ? ", " : "") + real_text(number);
    return joined + "]";
}

std::string shown_value(const Setting& setting, const SettingValue& value) {
    if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "on" : "off";
    if (setting.word && value == SettingValue(setting.word->value)) return setting.word->text;
    return value_text(value) + (setting.unit.empty() ? "" : " " + setting.unit);
}

const Setting& find_setting(std::string_view name) {
    const auto table = setting_table();
    std::vector<std::string> names, endings;
    const Setting* found = nullptr;
    for (const Setting& setting : table) {
        const std::string full = setting.full_name(), &section = setting.section;
        names.push_back(full);
        names.push_back(setting.name);
        if (full == name) return setting;
        // Short names that these sections share with others are the others', which were there before
        const bool has_short_name = section != "solid" && section != "pins" && section != "ground";
        if (setting.name != name || !has_short_name) continue;
        found = &setting;
        endings.push_back(full);
    }
    if (endings.size() == 1) return *found;
    const std::string shown = shortened(name);
    if (endings.size() > 1) throw InputError("setting '" + shown + "' is ambiguous: say " + listed(endings));
    throw InputError("unknown setting '" + shown + "'" +
                     did_you_mean(name, names, ": drape-lab list settings has all"));
}

Settings settings_with_one_of_each() {
    Settings settings;
    for (const Setting& setting : setting_table()) {
        if (section_count(settings, setting) == 0) setting.several->add(settings);
    }
    return settings;
}

std::string settings_help() {
    const Settings defaults = settings_with_one_of_each();
    std::string text;
    for (const Setting& setting : setting_table()) {
        std::string left = "  " + setting.full_name() + " = " + value_text(setting.read(defaults, 0));
        if (!setting.unit.empty()) left += " [" + setting.unit + "]";
        left.resize(std::max<std::size_t>(left.size() + 2, 46), ' ');
        text += left + setting.help + "; " + accepted(setting);
        if (setting.word) text += ", or " + setting.word->text;
        text += "\n";
    }
    return text;
}

}  // namespace drape
