#pragma once

#include <string>
#include <string_view>

#include "drape/scene/setting_table.h"
#include "drape/sim/simulation.h"

namespace drape {

/// What a command that was carried out has set, for the user: "integrator: rk4", with the reason where that shows
/// nothing or is no good in the present scene. Empty for commands whose outcome is seen.
inline std::string outcome_of(const Command& command, const Simulation& simulation) {
    const std::string_view changed = setting_of(command);
    if (changed.empty()) return "";
    const Setting& setting = find_setting(changed);
    const std::string name = setting.full_name();
    const Settings& settings = simulation.settings();
    const std::string text = setting_label(setting) + ": " + shown_value(setting, setting.read(settings, 0));
    std::string remark = why_without_effect(setting, settings, 0);
    if (name == "view.speed") remark = "simulated seconds in a second";
    const bool is_seen = setting.section == "view" && name != "view.speed";
    if (remark.empty()) return is_seen ? "" : text;
    return text + "; " + remark;
}

}  // namespace drape
