#include "compare_section.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "drape/sim/comparison.h"
#include "overlay_style.h"
#include "settings_panel.h"

namespace drape {

namespace {

bool can_compare(const Setting& setting, const Settings& settings) {
    return has_panel_row(setting) && setting.section != "view" && section_count(settings, setting) > 0;
}

// A value to begin with: the next name, the other of two, twice the numbers
SettingValue another_value(const SettingRow& row) {
    if (const bool* flag = std::get_if<bool>(&row.value)) return !*flag;
    if (const double* number = std::get_if<double>(&row.value)) {
        const double other = *number == 0 ? row.scale.high / 2 : std::clamp(2 * *number, row.scale.low, row.scale.high);
        return row.setting->kind == SettingKind::Integer ? std::max(1.0, std::round(other)) : other;
    }
    if (const auto* numbers = std::get_if<std::vector<double>>(&row.value)) {
        std::vector<double> others = *numbers;
        for (double& one : others) one = std::clamp(2 * one, row.setting->range.low, row.setting->range.high);
        return others;
    }
    const auto* name = std::get_if<std::string>(&row.value);
    if (name == nullptr) return row.value;
    const auto& choices = row.setting->choices;
    const auto found = std::ranges::find(choices, *name);
    return found == choices.end() || found + 1 == choices.end() ? choices.front() : *(found + 1);
}

}  // namespace

void CompareSection::choose(const Setting& setting, const Settings& settings, const Settings& scene) {
    editor_.forget();
    row_ = make_setting_row(setting, 0, settings, scene);
    row_->name = setting.full_name();  // of several, all
    row_->value = another_value(*row_);
}

void CompareSection::choice_of_setting(const Settings& settings, const Settings& scene) {
    if (!editor_.begin_list("##setting", row_->name.c_str())) return;
    const Setting* chosen = nullptr;
    for (const Setting& setting : setting_table()) {
        if (!can_compare(setting, settings)) continue;
        if (ImGui::Selectable(setting.full_name().c_str(), &setting == row_->setting)) chosen = &setting;
    }
    editor_.end_list();
    if (chosen != nullptr) choose(*chosen, settings, scene);
}

void CompareSection::draw(const FrameView& view, const Settings& scene, float widget_width) {
    const Settings& settings = *view.settings;
    editor_.begin_frame();
    if (ImGui::CollapsingHeader("Compare")) {
        if (!row_ || section_count(settings, *row_->setting) == 0) {
            choose(find_setting("solver.integrator"), settings, scene);
        }
        ImGui::PushID("compare");
        ImGui::SetNextItemWidth(widget_width);
        choice_of_setting(settings, scene);
        ImGui::SameLine();
        ImGui::TextUnformatted("setting");
        ImGui::SetNextItemWidth(widget_width);
        if (auto chosen = editor_.edit(*row_)) row_->value = std::move(*chosen);
        SettingEditor::explain(*row_->setting);
        ImGui::SameLine();
        ImGui::TextUnformatted("in the other run");

        if (ImGui::SmallButton("Compare from the start")) wanted_ = row_->name + "=" + value_text(row_->value);
        if (view.comparison != nullptr) {
            ImGui::SameLine();
            if (ImGui::SmallButton("End")) wanted_ = "none";
        }
        ImGui::PopID();
    }
    editor_.end_frame();
}

}  // namespace drape
