#pragma once

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "drape/base/numbers.h"
#include "drape/render/renderer.h"
#include "drape/scene/setting_table.h"
#include "drape/session/comparison.h"
#include "overlay_style.h"
#include "setting_editor.h"

namespace drape {

/// The panel of every setting at the right, made from the table of settings, with Dear ImGui's widgets: a slider, a box
/// or a list each, the help under the pointer, and a button back to the scene's value. A row without effect is dim, and
/// its help says why. Of several cloths, balls, solids or pins it has one at a time, with buttons to the others. Where
/// the method is another one than the scene's, it offers a time step that suits it. Its first section begins a
/// comparison of the run with one in which a setting has another value, and ends it. It changes nothing by itself.
class SettingsPanel {
public:
    static constexpr float columns = 27;  ///< of the width, where there is room [font size]

    explicit SettingsPanel(PanelWishes& wishes) : wishes_(wishes) {}

    /// The values that the buttons lead back to.
    void set_scene(const Settings& settings) {
        scene_ = settings;
        numbers_.clear();
        seeks_ = false, marked_ = nullptr;
        editor_.forget();
        other_.reset();
        compared_.clear();
    }

    /// Makes a frame's panel.
    void draw(const FrameView& view, const OverlayPage& page) {
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

    /// Shows one of several cloths, balls, solids or pins from now on, as the buttons do.
    void show(const std::string& section, std::size_t number) {
        numbers_[section] = number;
        editor_.forget();
    }

    /// Shows the row of a setting, marked until another scene comes, and asks for itself where it is not shown.
    void show(const Setting& setting) {
        seeks_ = true, marked_ = &setting;
        if (window.width() == 0) wishes_.changes.emplace_back("view.controls=true");
    }

    /// As those of the editor.
    [[nodiscard]] bool list_open() const { return editor_.list_open(); }
    bool close_list() { return editor_.close_list(); }

    /// The panel is not shown.
    void hide() {
        window = {};
        editor_.hide();
    }

    PanelBox window;  ///< as it was last drawn

private:
    [[nodiscard]] float widget_width() const { return 0.48f * window.width(); }

    static bool can_compare(const Setting& setting, const Settings& settings) {
        return has_panel_row(setting) && setting.section != "view" && section_count(settings, setting) > 0;
    }

    /// With "< Ball 2 of 3 >" below it where there are several.
    /// @return whether its rows are shown
    [[nodiscard]] bool heading(const std::string& section, std::size_t count) {
        std::string text = section;
        text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
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

    void draw_row(const SettingRow& row) {
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
            if (ImGui::SmallButton("reset")) wishes_.changes.push_back(row.name + "=" + value_text(*row.of_the_scene));
        }
        ImGui::PopID();
    }

    /// Where the method is no longer the scene's, or the step too long for it.
    void offer_step(const FrameView& view) {
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

    void compare_section(const FrameView& view) {
        const Settings& settings = *view.settings;
        if (!ImGui::CollapsingHeader("Compare")) return;
        follow_comparison(view);
        ImGui::PushID("compare");
        ImGui::SetNextItemWidth(widget_width());
        if (editor_.begin_list("##setting", other_->name.c_str())) {
            const Setting* chosen = nullptr;
            for (const Setting& setting : setting_table()) {
                if (!can_compare(setting, settings)) continue;
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

    /// A comparison that has begun elsewhere is shown as it is; the run's own value is none to compare it with.
    void follow_comparison(const FrameView& view) {
        const Settings& settings = *view.settings;
        const std::string_view compared = view.comparison == nullptr ? "" : view.comparison->assignments;
        if (compared != compared_) {
            compared_ = compared;
            const std::string first = compared_.empty() ? "" : split_assignments(compared_).front();
            const std::size_t equals = first.find('=');
            const Setting* setting = first.empty() ? nullptr : &setting_meant_by(first.substr(0, equals));
            if (setting != nullptr && can_compare(*setting, settings)) {
                choose_other(*setting, settings);
                other_->value = parse_value(*setting, first.substr(equals + 1));
            }
        }
        if (!other_ || section_count(settings, *other_->setting) == 0) {
            return choose_other(find_setting("solver.integrator"), settings);
        }
        SettingValue of_the_run = other_->setting->read(settings, 0);
        if (of_the_run == of_the_run_) return;
        of_the_run_ = std::move(of_the_run);
        if (of_the_run_ == other_->value && view.comparison == nullptr) choose_other(*other_->setting, settings);
    }

    void choose_other(const Setting& setting, const Settings& settings) {
        editor_.forget();
        other_ = make_setting_row(setting, 0, settings, scene_);
        other_->name = setting.full_name();  // of several, all
        of_the_run_ = std::exchange(other_->value, another_value(*other_));
    }

    Settings scene_;
    PanelWishes& wishes_;
    std::map<std::string, std::size_t> numbers_;  ///< of those that are shown, by section
    const Setting* marked_ = nullptr;
    bool seeks_ = false;               ///< it was not drawn yet
    std::optional<SettingRow> other_;  ///< of the other simulation
    SettingValue of_the_run_;          ///< that runs, of the same setting
    std::string compared_;             ///< assignments of the comparison that was last seen
    SettingEditor editor_;
};

}  // namespace drape
