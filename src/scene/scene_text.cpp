#include "drape/scene/scene.h"

#include <algorithm>
#include <utility>

#include "drape/base/numbers.h"
#include "drape/scene/setting_table.h"

namespace drape {
namespace {

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + '"';
}

/// A list as a TOML array; one of many numbers has several lines, for those of a scene file must not be long.
std::string array_text(const std::vector<double>& values) {
    constexpr std::size_t a_line = 16;
    std::string text = "[";
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (k > 0) text += k % a_line == 0 ? ",\n    " : ", ";
        text += real_text(values[k]);
    }
    return text + "]";
}

std::string path_text(const std::vector<double>& values) {
    std::string text = "[\n";
    for (auto row = values.begin(); row != values.end(); row += 4) text += "    " + array_text({row, row + 4}) + ",\n";
    return text + "]";
}

std::string toml_text(const Setting& setting, const SettingValue& value) {
    if (const auto* text = std::get_if<std::string>(&value)) return quoted(*text);
    if (const auto* list = std::get_if<std::vector<double>>(&value)) {
        return setting.kind == SettingKind::Path ? path_text(*list) : array_text(*list);
    }
    return value_text(value);
}

/// Of origin and centre, which say the same, the one that was not given.
bool is_other_name(const Setting& setting, const Settings& settings, std::size_t index) {
    if (setting.section != "cloth") return false;
    return setting.name == (settings.cloths[index].centred ? "origin" : "centre");
}

/// The lines of a section's settings that are not as in `defaults`, each "name = value".
std::string lines_of(const std::string& section, const Settings& settings, const Settings& defaults,
                     std::size_t index) {
    std::string lines;
    for (const Setting& setting : setting_table()) {
        if (setting.section != section || is_other_name(setting, settings, index)) continue;
        const SettingValue value = setting.read(settings, index);
        if (value == setting.read(defaults, 0) && setting.full_name() != "cloth.particles") continue;
        lines += setting.name + " = " + toml_text(setting, value) + "\n";
    }
    return lines;
}

}  // namespace

std::string scene_text(const Settings& settings) {
    const Settings defaults = settings_with_one_of_each();
    std::string text, last = "none";
    for (const Setting& setting : setting_table()) {
        const std::string& section = setting.section;
        if (section == std::exchange(last, section)) continue;
        for (std::size_t k = 0; k < section_count(settings, setting); ++k) {
            const std::string lines = lines_of(section, settings, defaults, k);
            if (setting.several != nullptr) {
                text += "\n[[" + section + "]]\n";
            } else if (!section.empty() && !lines.empty()) {
                text += "\n[" + section + "]\n";
            }
            text += lines;
        }
    }
    return text;
}

std::vector<std::string> changes_of(const Settings& scene, const Settings& settings) {
    std::vector<std::string> changes;
    Settings again = scene;
    for (const Setting& setting : setting_table()) {
        for (std::size_t k = 0; k < std::min(section_count(scene, setting), section_count(settings, setting)); ++k) {
            if (is_other_name(setting, settings, k)) continue;
            const SettingValue value = setting.read(settings, k);
            if (value == setting.read(again, k)) continue;
            const std::string number = setting.several != nullptr ? "[" + std::to_string(k) + "]" : "";
            const std::string section = setting.section.empty() ? "" : setting.section + number + ".";
            changes.push_back(section + setting.name + "=" + value_text(value));
            assign(again, changes.back());
        }
    }
    if (scene_text(again) != scene_text(settings)) {
        throw RunError("the settings cannot be made from the scene again: it has changed, or moving pins have ended");
    }
    return changes;
}

}  // namespace drape
