#include "drape/sim/scene_text.h"

#include "drape/base/numbers.h"
#include "drape/sim/setting_table.h"

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
    for (std::size_t k = 0; k + 3 < values.size(); k += 4) {
        text += "    " +
                array_text({values.begin() + static_cast<std::ptrdiff_t>(k),
                            values.begin() + static_cast<std::ptrdiff_t>(k) + 4}) +
                ",\n";
    }
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
    Settings defaults;
    defaults.balls.emplace_back();
    defaults.solids.emplace_back();
    defaults.pins.emplace_back();
    std::string text = lines_of("", settings, defaults, 0);
    for (std::size_t c = 0; c < settings.cloths.size(); ++c) {
        text += "\n[[cloth]]\n" + lines_of("cloth", settings, defaults, c);
    }
    for (std::size_t b = 0; b < settings.balls.size(); ++b) {
        text += "\n[[ball]]\n" + lines_of("ball", settings, defaults, b);
    }
    for (std::size_t s = 0; s < settings.solids.size(); ++s) {
        text += "\n[[solid]]\n" + lines_of("solid", settings, defaults, s);
    }
    for (std::size_t p = 0; p < settings.pins.size(); ++p) {
        text += "\n[[pins]]\n" + lines_of("pins", settings, defaults, p);
    }
    std::string last = "cloth";
    for (const Setting& setting : setting_table()) {
        const std::string& section = setting.section;
        const bool is_several = section == "cloth" || section == "ball" || section == "solid" || section == "pins";
        if (section.empty() || is_several || section == last) continue;
        last = section;
        const std::string lines = lines_of(section, settings, defaults, 0);
        if (!lines.empty()) text += "\n[" + section + "]\n" + lines;
    }
    return text;
}

}  // namespace drape
