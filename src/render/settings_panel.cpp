#include "settings_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "drape/base/numbers.h"

namespace drape {

namespace {

std::string capitalised(std::string text) {
    if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

}  // namespace

void SettingsPanel::draw(const FrameView& view, const OverlayPage& page) {
    const float width = std::min(columns * ImGui::GetFontSize(), page.width - 2 * page.margin);
    const float right = page.width - page.margin;
    window = {right - width, page.margin, right, page.height - page.margin};
    const Settings& settings = *view.settings;
    editor_.begin_frame();
    constexpr auto flags =
        ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoFocusOnAppearing;
    if (begin_window(window, "settings", flags, page.margin)) {
        compare_section(view);
        std::string section;
        bool open = false;
        for (const Setting& setting : setting_table()) {
            const std::size_t count = section_count(settings, setting);
            if (!has_panel_row(setting) || count == 0) continue;
            std::size_t& number = numbers_[setting.section];
            if (number >= count) number = 0;
            if (std::exchange(section, setting.section) != section) open = heading(section, count);
            if (!open) continue;
            draw_row(make_setting_row(setting, number, settings, scene_));
            if (setting.full_name() == "solver.dt") offer_step(view);
        }
    }
    end_window();
    editor_.end_frame();
}

void SettingsPanel::show(const std::string& section, std::size_t number) {
    numbers_[section] = number;
    editor_.forget();
}

/// With "< Ball 2 of 3 >" below it where there are several.
/// @return whether its rows are shown
bool SettingsPanel::heading(const std::string& section, std::size_t count) {
    const std::string text = capitalised(section);
    const bool sought = seeks_ && marked_->section == section;
    const bool usual = section == "solver" || section == "contact";
    ImGui::SetNextItemOpen(sought || usual, sought ? ImGuiCond_Always : ImGuiCond_Once);
    if (!ImGui::CollapsingHeader(text.c_str())) return false;
    if (count == 1) return true;
    const std::size_t number = numbers_[section];
    ImGui::PushID(text.c_str());
    if (ImGui::SmallButton("<")) show(section, (number + count - 1) % count);
    ImGui::SameLine();
    ImGui::Text("%s %zu of %zu", text.c_str(), number + 1, count);
    ImGui::SameLine();
    if (ImGui::SmallButton(">")) show(section, (number + 1) % count);
    ImGui::PopID();
    return true;
}

/// Where the method is no longer the scene's, or the step too long for it.
void SettingsPanel::offer_step(const FrameView& view) {
    const SolverSettings& solver = view.settings->solver;
    constexpr double picture = 1.0 / 60, below_the_limit = 0.895;  // 0.9 at most, however its digits are rounded
    const double step = std::min(below_the_limit * view.longest_step, picture);
    const bool changed = solver.integrator != scene_.solver.integrator || solver.dt > view.longest_step;
    const bool suits = std::abs(solver.dt - step) < 0.05 * step;
    if (!changed || suits || step == 0) return;
    if (ImGui::SmallButton(("Use " + real_text(1e3 * step, 3) + " ms").c_str())) {
        wishes_.changes.push_back("solver.dt=" + real_text(step, 3));
    }
    ImGui::SameLine();
    ImGui::TextUnformatted(2 * step < view.longest_step ? "one step a picture" : "0.9 of its limit");
}

void SettingsPanel::draw_row(const SettingRow& row) {
    ImGui::PushID(row.name.c_str());
    if (row.setting == marked_) {
        const ImVec2 at = ImGui::GetCursorScreenPos(), far{window.right, at.y + ImGui::GetFrameHeight()};
        ImGui::GetWindowDrawList()->AddRectFilled({window.left, at.y}, far, ink::lit);
        if (std::exchange(seeks_, false)) ImGui::SetScrollHereY();
    }
    // Without an effect it is dim, and can be set all the same
    ImGui::BeginGroup();
    for (const ImGuiCol part : {ImGuiCol_Text, ImGuiCol_SliderGrab, ImGuiCol_CheckMark})
        ImGui::PushStyleColor(part, row.no_effect.empty() ? ImGui::GetColorU32(part) : ink::dim);
    ImGui::SetNextItemWidth(widget_width());
    if (const auto chosen = editor_.edit(row)) wishes_.changes.push_back(row.name + "=" + value_text(*chosen));
    ImGui::SameLine();
    ImGui::TextUnformatted(setting_label(*row.setting).c_str());
    ImGui::PopStyleColor(3);
    ImGui::EndGroup();
    SettingEditor::explain(row);

    if (row.of_the_scene && *row.of_the_scene != row.value) {
        ImGui::SameLine(window.width() - 4.5f * ImGui::GetFontSize());
        const bool resets = ImGui::SmallButton("reset");
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("to %s", value_text(*row.of_the_scene).c_str());
        if (resets) wishes_.changes.push_back(row.name + "=" + value_text(*row.of_the_scene));
    }
    ImGui::PopID();
}

void SettingsPanel::compare_section(const FrameView& view) {
    const Settings& settings = *view.settings;
    if (!ImGui::CollapsingHeader("Compare")) return;
    // At first, and where another scene has none of the one that was chosen
    if (!other_ || section_count(settings, *other_->setting) == 0) {
        choose_other(find_setting("solver.integrator"), settings);
    }
    ImGui::PushID("compare");
    ImGui::SetNextItemWidth(widget_width());
    if (editor_.begin_list("##setting", other_->name.c_str())) {
        const Setting* chosen = nullptr;
        for (const Setting& setting : setting_table()) {
            if (!has_panel_row(setting) || setting.section == "view" || section_count(settings, setting) == 0) continue;
            if (ImGui::Selectable(setting.full_name().c_str(), &setting == other_->setting)) chosen = &setting;
        }
        editor_.end_list();
        if (chosen != nullptr) choose_other(*chosen, settings);
    }
    ImGui::SameLine();
    ImGui::TextUnformatted("setting");
    ImGui::SetNextItemWidth(widget_width());
    if (auto chosen = editor_.edit(*other_)) other_->value = std::move(*chosen);
    SettingEditor::explain(*other_);
    ImGui::SameLine();
    ImGui::TextUnformatted("in the other run");

    if (ImGui::SmallButton("Compare from the start")) {
        wishes_.comparison = other_->name + "=" + value_text(other_->value);
    }
    if (view.comparison != nullptr) {
        ImGui::SameLine();
        if (ImGui::SmallButton("End")) wishes_.comparison = "none";
    }
    ImGui::PopID();
}

void SettingsPanel::choose_other(const Setting& setting, const Settings& settings) {
    editor_.forget();
    other_ = make_setting_row(setting, 0, settings, scene_);
    other_->name = setting.full_name();  // of several, all
    other_->value = another_value(*other_);
}

}  // namespace drape
