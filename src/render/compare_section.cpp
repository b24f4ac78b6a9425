#include "compare_section.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "drape/session/comparison.h"
#include "overlay_style.h"
#include "settings_panel.h"

namespace drape {

namespace {

bool can_compare(const Setting& setting, const Settings& settings) {
    return has_panel_row(setting) && setting.section != "view" && section_count(settings, setting) > 0;
}

// Twice as much, or half where there is no more
double another_number(double number, double low, double high) {
    if (number == 0) return high / 2;
    const double twice = std::clamp(2 * number, low, high);
    return twice == number ? number / 2 : twice;
}

}  // namespace

SettingValue another_value(const SettingRow& row) {
    if (const bool* flag = std::get_if<bool>(&row.value)) return !*flag;
    if (const double* number = std::get_if<double>(&row.value)) {
        const Range& range = row.setting->range;
        const double other = another_number(*number, row.scale.low, row.scale.high);
        if (row.setting->kind != SettingKind::Integer) return other;
        const double whole = std::max(std::max(1.0, range.low), std::round(other));
        return whole != *number ? whole : *number > range.low ? *number - 1 : *number + 1;
    }
    const auto& choices = row.setting->choices;
    if (const auto* numbers = std::get_if<std::vector<double>>(&row.value)) {
        if (row.setting->kind == SettingKind::Pins) return choices.front();
        std::vector<double> others = *numbers;
        for (double& one : others) {
            if (one != 0) one = another_number(one, row.setting->range.low, row.setting->range.high);
        }
        if (others == *numbers) others.front() = std::min(1.0, row.setting->range.high);
        return others;
    }
    const auto* name = std::get_if<std::string>(&row.value);
    if (name == nullptr) return row.value;
    const auto found = std::ranges::find(choices, *name);
    return found == choices.end() || found + 1 == choices.end() ? choices.front() : *(found + 1);
}

void CompareSection::choose(const Setting& setting, const Settings& settings, const Settings& scene) {
    editor_.forget();
    row_ = make_setting_row(setting, 0, settings, scene);
    row_->name = setting.full_name();  // of several, all
    of_the_run_ = std::exchange(row_->value, another_value(*row_));
}

/// A comparison that has begun elsewhere is shown as it is; the run's own value is none to compare it with.
void CompareSection::follow(const FrameView& view, const Settings& scene) {
    const Settings& settings = *view.settings;
    const std::string_view compared = view.comparison == nullptr ? "" : view.comparison->assignments;
    if (compared != compared_) {
        compared_ = compared;
        const std::vector<std::string> assignments = split_assignments(compared_);
        if (!assignments.empty()) show(assignments.front(), settings, scene);
    }
    if (!row_ || section_count(settings, *row_->setting) == 0) {
        return choose(find_setting("solver.integrator"), settings, scene);
    }
    SettingValue of_the_run = row_->setting->read(settings, 0);
    if (of_the_run == of_the_run_) return;
    of_the_run_ = std::move(of_the_run);
    if (of_the_run_ == row_->value && view.comparison == nullptr) choose(*row_->setting, settings, scene);
}

void CompareSection::show(const std::string& assignment, const Settings& settings, const Settings& scene) {
    const std::size_t equals = assignment.find('=');
    const Setting& setting = setting_meant_by(assignment.substr(0, equals));
    if (!can_compare(setting, settings)) return;
    choose(setting, settings, scene);
    row_->value = parse_value(setting, assignment.substr(equals + 1));
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
    if (!ImGui::CollapsingHeader("Compare")) return;
    follow(view, scene);
    ImGui::PushID("compare");
    ImGui::SetNextItemWidth(widget_width);
    choice_of_setting(settings, scene);
    ImGui::SameLine();
    ImGui::TextUnformatted("setting");
    ImGui::SetNextItemWidth(widget_width);
    if (auto chosen = editor_.edit(*row_)) row_->value = std::move(*chosen);
    SettingEditor::explain(*row_);
    ImGui::SameLine();
    ImGui::TextUnformatted("in the other run");

    if (ImGui::SmallButton("Compare from the start")) wishes_.comparison = row_->name + "=" + value_text(row_->value);
    if (view.comparison != nullptr) {
        ImGui::SameLine();
        if (ImGui::SmallButton("End")) wishes_.comparison = "none";
    }
    ImGui::PopID();
}

}  // namespace drape
