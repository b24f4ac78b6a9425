#include "menu_mark.h"

namespace drape {

MenuMark::MenuMark(std::string_view command) : command_(parse_command(command)) {
    if (const auto* next = std::get_if<command::Next>(&command_)) setting_ = &find_setting(next->setting);
    if (const auto* set = std::get_if<command::Set>(&command_)) {
        const std::string_view assignment = set->assignment;
        const std::size_t equals = assignment.find('=');
        setting_ = &find_setting(assignment.substr(0, equals));
        value_ = parse_value(*setting_, assignment.substr(equals + 1));
    }
}

std::string MenuMark::text(const Simulation& simulation) const {
    const auto now = [](bool is_present) { return is_present ? "  - now" : ""; };
    if (std::holds_alternative<command::Pause>(command_)) return simulation.paused() ? "  - paused" : "";
    if (const auto* load = std::get_if<command::LoadScene>(&command_)) return now(simulation.scene() == load->name);
    if (setting_ == nullptr) return "";
    const SettingValue present = setting_->read(simulation.settings(), 0);
    if (value_) return now(present == *value_);
    const bool* flag = std::get_if<bool>(&present);
    if (flag == nullptr) return "";
    return *flag ? "  - on" : "  - off";
}

}  // namespace drape
