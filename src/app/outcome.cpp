#include "outcome.h"

#include <string_view>

#include "drape/scene/setting_table.h"

namespace drape {

namespace {

std::string outcome_for(const Setting& setting, const Simulation& simulation) {
    const std::string name = setting.full_name();
    const std::string text =
        setting_label(setting) + ": " + shown_value(setting, setting.read(simulation.settings(), 0));
    std::string remark = why_without_effect(setting, simulation.settings(), 0);
    const bool hidden = simulation.settings().view.panel == PanelSize::Off;
    if (name == "solver.ledger" && simulation.settings().solver.ledger && hidden) remark = "Tab shows it";
    if (name == "view.speed") remark = "simulated seconds in a second";
    const bool is_seen = setting.section == "view" && name != "view.speed";
    if (remark.empty()) return is_seen ? "" : text;
    return text + "; " + remark;
}

}  // namespace

std::string outcome_of(const Command& command, const Simulation& simulation) {
    const std::string_view setting = setting_of(command);
    return setting.empty() ? "" : outcome_for(find_setting(setting), simulation);
}

}  // namespace drape
