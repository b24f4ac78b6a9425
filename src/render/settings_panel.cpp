#include "settings_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "drape/base/numbers.h"
#include "overlay_style.h"

namespace drape {

namespace {

constexpr double decades = 100;  // of a slider to both sides
constexpr double narrow = 25;    // up to which a slider from 0 on is even

ImGuiWindowFlags panel_flags() {
    return ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
           ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing;
}

std::string capitalised(std::string text) {
    if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

// "%.4g N/m"
std::string number_format(const Setting& setting) { return "%.12g" + (setting.unit.empty() ? "" : " " + setting.unit); }

// What is said of a setting under the pointer
void tooltip(const Setting& setting) {
    if (!ImGui::IsItemHovered() || ImGui::IsItemActive()) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(28 * ImGui::GetFontSize());
    ImGui::TextUnformatted((setting.full_name() + ": " + setting.help).c_str());
    ImGui::PushStyleColor(ImGuiCol_Text, ink::quiet);
    ImGui::TextUnformatted(accepted(setting).c_str());
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

// Of the first of its section; nothing where there is none
std::optional<SettingValue> first_value(const Setting& setting, const Settings& settings) {
    if (section_count(settings, setting) == 0) return std::nullopt;
    return setting.read(settings, 0);
}

double first_number(const Setting& setting, const Settings& settings) {
    const std::optional<SettingValue> value = first_value(setting, settings);
    const double* number = value ? std::get_if<double>(&*value) : nullptr;
    return number == nullptr ? 0 : *number;
}

double default_number(const Setting& setting) {
    Settings defaults;
    defaults.balls.resize(1);
    defaults.solids.resize(1);
    defaults.pins.resize(1);
    return first_number(setting, defaults);
}

// Numbers that a user reads, and a recording keeps
double rounded(double value) { return parse_real(real_text(value, 4)).value_or(value); }

}  // namespace

SliderScale slider_scale(const Setting& setting, double scene_value) {
    const Range& range = setting.range;
    if (scene_value == 0) scene_value = default_number(setting);
    if (scene_value < 0) return {std::max(range.low, -10.0), std::min(range.high, 10.0), false};
    if (scene_value == 0) return {std::max(range.low, 0.0), std::min(range.high, 1.0), false};
    const bool is_narrow = range.low == 0 && range.high <= narrow * scene_value;
    if (is_narrow) return {range.low, range.high, false};
    return {std::max(range.low, scene_value / decades), std::min(range.high, scene_value * decades), true};
}

bool has_panel_row(const Setting& setting) {
    const bool is_start_of_view = setting.full_name() == "view.eye" || setting.full_name() == "view.target";
    return !is_start_of_view && setting.section != "needs" && !setting.section.empty() &&
           setting.kind != SettingKind::Text && setting.kind != SettingKind::Path;
}

bool SettingsPanel::covers(float x, float y) const {
    return x >= left_ && x < left_ + width_ && y >= top_ && y < top_ + height_;
}

PanelBox SettingsPanel::place(const OverlayPage& page) {
    width_ = std::min(columns * ImGui::GetFontSize(), page.width - 2 * page.margin);
    height_ = page.height - 2 * page.margin;
    left_ = page.width - page.margin - width_;
    top_ = page.margin;
    return {left_, top_, left_ + width_, top_ + height_};
}

void SettingsPanel::draw(const Settings& settings, const OverlayPage& page) {
    list_open_ = false;
    ImGui::SetNextWindowPos({left_, top_});
    ImGui::SetNextWindowSize({width_, height_});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {page.margin, page.margin});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ink::panel);
    if (ImGui::Begin("settings", nullptr, panel_flags())) {
        if (!is_up_to_date(settings)) make_rows(settings);
        bool open = false;
        for (const Row& row : rows_) {
            if (!row.heading.empty()) {
                const std::string& section = row.setting->section;
                ImGui::SetNextItemOpen(section == "solver" || section == "contact", ImGuiCond_Once);
                open = ImGui::CollapsingHeader(row.heading.c_str());
            }
            if (open) show(row);
        }
    }
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
    if (std::exchange(closing_list_, false)) list_open_ = false;
}

/// Those of the view have no comparison of their own, and no value that would need memory.
bool SettingsPanel::is_up_to_date(const Settings& settings) const {
    const auto is_shown = [&](const Row& row) {
        return row.setting->section != "view" || row.setting->read(settings, 0) == row.value;
    };
    const auto same = [&](auto... parts) { return ((settings.*parts == shown_.*parts) && ...); };
    return !rows_.empty() &&
           same(&Settings::cloths, &Settings::balls, &Settings::solids, &Settings::pins, &Settings::solver,
                &Settings::contact, &Settings::ground, &Settings::wind) &&
           std::ranges::all_of(rows_, is_shown);
}

/// Texts are made here, not in every frame.
void SettingsPanel::make_rows(const Settings& settings) {
    rows_.clear();
    shown_ = settings;
    ++times_made_;
    std::string_view section;
    for (const Setting& setting : setting_table()) {
        const std::optional<SettingValue> value = first_value(setting, settings);
        if (!has_panel_row(setting) || !value) continue;
        // Of several cloths, balls, solids or pins the first is shown and changed
        const bool is_first = section_count(settings, setting) > 1;
        const bool is_whole = setting.kind == SettingKind::Integer || setting.kind == SettingKind::Grid;
        const bool is_list = setting.kind != SettingKind::Number && setting.kind != SettingKind::Integer;
        rows_.push_back({.setting = &setting,
                         .name = is_first ? setting.section + "[0]." + setting.name : setting.full_name(),
                         .heading = setting.section == section ? "" : capitalised(setting.section),
                         .label = setting_label(setting),
                         .format = is_whole  ? "%.0f"
                                   : is_list ? "%.3g"
                                             : number_format(setting),
                         .value = *value,
                         .of_the_scene = first_value(setting, scene_),
                         .scale = slider_scale(setting, first_number(setting, scene_))});
        section = setting.section;
    }
}

void SettingsPanel::show(const Row& row) {
    ImGui::PushID(row.name.c_str());
    ImGui::SetNextItemWidth(0.48f * width_);
    if (const auto chosen = edited(row)) changes_.push_back(row.name + "=" + value_text(*chosen));
    tooltip(*row.setting);
    ImGui::SameLine();
    ImGui::TextUnformatted(row.label.c_str());
    tooltip(*row.setting);

    if (row.of_the_scene && *row.of_the_scene != row.value) {
        ImGui::SameLine(width_ - 4.5f * ImGui::GetFontSize());
        if (ImGui::SmallButton("reset")) changes_.push_back(row.name + "=" + value_text(*row.of_the_scene));
    }
    ImGui::PopID();
}

std::optional<SettingValue> SettingsPanel::edited(const Row& row) {
    switch (row.setting->kind) {
        case SettingKind::Flag: {
            bool flag = std::get<bool>(row.value);
            if (ImGui::Checkbox("##value", &flag)) return flag;
            return std::nullopt;
        }
        case SettingKind::Choice:
        case SettingKind::Pins:
            return edited_choice(*row.setting, row.value);
        case SettingKind::Number:
        case SettingKind::Integer:
            return edited_number(row);
        default:
            return edited_list(row);
    }
}

std::optional<SettingValue> SettingsPanel::edited_choice(const Setting& setting, const SettingValue& value) {
    const auto* name = std::get_if<std::string>(&value);
    std::optional<SettingValue> chosen;
    if (!ImGui::BeginCombo("##value", name == nullptr ? "a list" : name->c_str())) return chosen;
    list_open_ = true;
    for (const std::string& choice : setting.choices) {
        if (ImGui::Selectable(choice.c_str(), name != nullptr && choice == *name)) chosen = choice;
    }
    if (closing_list_) ImGui::CloseCurrentPopup();
    ImGui::EndCombo();
    return chosen;
}

std::optional<SettingValue> SettingsPanel::edited_number(const Row& row) {
    const Setting& setting = *row.setting;
    const double value = std::get<double>(row.value);
    ImGuiSliderFlags flags = ImGuiSliderFlags_NoRoundToFormat;
    if (row.scale.logarithmic) flags |= ImGuiSliderFlags_Logarithmic;
    const bool is_held = held_setting_ == &setting;
    double changed = is_held ? held_values_.front() : value;
    const bool moved = ImGui::SliderScalar("##value", ImGuiDataType_Double, &changed, &row.scale.low, &row.scale.high,
                                           row.format.c_str(), flags);
    const bool is_active = ImGui::IsItemActive();
    if (is_active && ImGui::GetIO().WantTextInput && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        // Half a number is none: what is typed counts once it is whole
        held_setting_ = &setting;
        held_values_ = {changed};
        return std::nullopt;
    }
    if (is_held) held_setting_ = nullptr;
    if (!moved && !is_held) return std::nullopt;
    changed = setting.kind == SettingKind::Integer ? std::round(changed) : rounded(changed);
    changed = std::clamp(changed, setting.range.low, setting.range.high);
    if (changed == value) return std::nullopt;
    return changed;
}

// Some of these make the cloth again, so a drag is carried out as it ends
std::optional<SettingValue> SettingsPanel::edited_list(const Row& row) {
    const Setting& setting = *row.setting;
    std::vector<double>& values = drawn_values_;
    values = std::get<std::vector<double>>(row.value);
    if (held_setting_ == &setting && held_values_.size() == values.size()) values = held_values_;
    const bool is_grid = setting.kind == SettingKind::Grid;
    const float speed = is_grid ? 0.2f : 0.01f;
    const bool changed = ImGui::DragScalarN("##value", ImGuiDataType_Double, values.data(),
                                            static_cast<int>(values.size()), speed, &setting.range.low,
                                            &setting.range.high, row.format.c_str(), ImGuiSliderFlags_NoRoundToFormat);
    if (changed) {
        for (double& value : values) value = is_grid ? value : rounded(value);
        held_setting_ = &setting;
        held_values_ = values;
    }
    if (held_setting_ != &setting || ImGui::IsAnyItemActive()) return std::nullopt;
    held_setting_ = nullptr;
    if (is_grid) {
        for (double& value : values) value = std::round(value);
    }
    return values;
}

}  // namespace drape
