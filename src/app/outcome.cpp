#include "outcome.h"

#include <cmath>
#include <string_view>

#include "drape/base/numbers.h"
#include "drape/integrate/stability.h"
#include "drape/scene/setting_table.h"

namespace drape {

namespace {

// What a new integrator makes of the time step
std::string step_advice(const Simulation& simulation) {
    const double ratio = simulation.report().step_limit_ratio;
    if (ratio > 1) return "Shift+R resets with a time step at 0.9 of its limit";
    const bool limited = ratio > 0 || has_step_limit(simulation.settings().solver.integrator);
    return limited ? "" : "no stability limit, a longer time step works too (menu)";
}

std::string outcome_for(const Setting& setting, const Simulation& simulation) {
    const std::string name = setting.full_name();
    const std::string text =
        setting_label(setting) + ": " + shown_value(setting, setting.read(simulation.settings(), 0));
    std::string remark = why_without_effect(setting, simulation.settings(), 0);
    if (name == "solver.integrator") remark = step_advice(simulation);
    const bool hidden = simulation.settings().view.panel == PanelSize::Off;
    if (name == "solver.ledger" && simulation.settings().solver.ledger && hidden) remark = "Tab shows it";
    if (name == "view.speed") remark = "simulated seconds in a second";
    const bool is_seen = setting.section == "view" && name != "view.speed";
    if (remark.empty()) return is_seen ? "" : text;
    return text + "; " + remark;
}

// With which time step a scene begins again
std::string outcome_of_reset(const Simulation& simulation) {
    const double dt = simulation.settings().solver.dt, part = dt / simulation.longest_step();
    const std::string text = "Reset with a time step of " + real_text(1e3 * dt, 4) + " ms";
    if (!std::isfinite(part)) return text + ", and no step of this method is stable here";
    if (part == 0 || simulation.settings().solver.on_unstable == OnUnstable::Substep) return text;
    return text + ", " + real_text(part, 3) + " x its limit" + (part > 1 ? "; Shift+R uses 0.9 x" : "");
}

}  // namespace

std::string outcome_of(const Command& command, const Simulation& simulation) {
    const std::string_view setting = setting_of(command);
    if (!setting.empty()) return outcome_for(find_setting(setting), simulation);
    if (std::holds_alternative<command::Reset>(command)) return outcome_of_reset(simulation);
    return {};
}

}  // namespace drape
