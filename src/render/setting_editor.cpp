#include "setting_editor.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "drape/base/numbers.h"
#include "overlay_style.h"

namespace drape {

namespace {

constexpr double span = 10;    // of a slider to both sides: more is typed
constexpr double narrow = 25;  // up to which a slider from 0 on is even

double number_in(const std::optional<SettingValue>& value) {
    const double* number = value ? std::get_if<double>(&*value) : nullptr;
    return number == nullptr ? 0 : *number;
}

// Numbers that a user reads, and a recording keeps
double rounded(double value) { return parse_real(real_text(value, 4)).value_or(value); }

// Where the grab is not; without its unit where that has no room
void number_beside_grab(const SettingRow& row, double number) {
    const auto& word = row.setting->word;
    std::string text = word && number == word->value ? word->text : format(row.format.c_str(), number);
    const auto& [low, high, logarithmic] = row.scale;
    const double part = logarithmic ? std::log(number / low) / std::log(high / low) : (number - low) / (high - low);
    const auto grab = static_cast<float>(std::clamp(part, 0.0, 1.0));
    const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
    const ImVec2 pad = ImGui::GetStyle().FramePadding;
    const float room = std::max(grab, 1 - grab) * (to.x - from.x - ImGui::GetStyle().GrabMinSize) - pad.x;
    if (text_width(text) > room) text = format("%.4g", number);
    const float x = grab > 0.5f ? from.x + pad.x : to.x - pad.x - text_width(text);
    ImGui::GetWindowDrawList()->AddText({x, from.y + pad.y}, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
}

}  // namespace

bool has_panel_row(const Setting& setting) {
    const bool is_start_of_view = setting.full_name() == "view.eye" || setting.full_name() == "view.target";
    return !is_start_of_view && setting.section != "needs" && !setting.section.empty() &&
           setting.kind != SettingKind::Text && setting.kind != SettingKind::Path;
}

SliderScale slider_scale(const Setting& setting, double scene_value) {
    const Range& range = setting.range;
    if (setting.usual_high > 0) return {range.low, std::max(setting.usual_high, scene_value), false};
    if (scene_value == 0) scene_value = number_in(setting.read(settings_with_one_of_each(), 0));
    if (scene_value < 0) return {std::max(range.low, -10.0), std::min(range.high, 10.0), false};
    if (scene_value == 0) return {std::max(range.low, 0.0), std::min(range.high, 1.0), false};
    const bool is_narrow = range.low == 0 && range.high <= narrow * scene_value;
    if (is_narrow) return {range.low, range.high, false};
    return {std::max(range.low, scene_value / span), std::min(range.high, scene_value * span), true};
}

SettingRow make_setting_row(const Setting& setting, std::size_t number, const Settings& settings,
                            const Settings& scene) {
    const bool is_whole = setting.kind == SettingKind::Integer || setting.kind == SettingKind::Grid;
    const bool is_list = setting.kind != SettingKind::Number && setting.kind != SettingKind::Integer;
    std::optional<SettingValue> of_the_scene;
    if (number < section_count(scene, setting)) of_the_scene = setting.read(scene, number);
    const SliderScale scale = slider_scale(setting, number_in(of_the_scene));
    return {.setting = &setting,
            .name = name_of(setting, number, settings),
            .format = is_whole  ? "%.0f"
                      : is_list ? "%.3g"
                                : "%.12g" + (setting.unit.empty() ? "" : " " + setting.unit),
            .value = setting.read(settings, number),
            .of_the_scene = std::move(of_the_scene),
            .scale = scale,
            .no_effect = why_without_effect(setting, settings, number)};
}

SettingValue another_value(const SettingRow& row) {
    if (const bool* flag = std::get_if<bool>(&row.value)) return !*flag;
    const auto* name = std::get_if<std::string>(&row.value);
    if (name == nullptr) return row.value;
    const auto& choices = row.setting->choices;
    const auto found = std::ranges::find(choices, *name);
    return found == choices.end() || found + 1 == choices.end() ? choices.front() : *(found + 1);
}

void SettingEditor::explain(const SettingRow& row) {
    if (!ImGui::IsItemHovered() || ImGui::IsItemActive()) return;
    const Setting& setting = *row.setting;
    // Beside the panel, where it covers no other row
    const float left = ImGui::GetWindowPos().x - 0.5f * ImGui::GetFontSize();
    tooltip({{ink::text, setting.full_name() + ": " + setting.help},
             {ink::wait, row.no_effect},
             {ink::quiet, accepted(setting)}},
            {left, ImGui::GetItemRectMin().y});
}

std::optional<SettingValue> SettingEditor::edit(const SettingRow& row) {
    const SettingKind kind = row.setting->kind;
    if (kind == SettingKind::Choice || kind == SettingKind::Pins) return choice(row);
    if (kind == SettingKind::Number || kind == SettingKind::Integer) return number(row);
    if (kind != SettingKind::Flag) return list(row);
    bool flag = std::get<bool>(row.value);
    if (ImGui::Checkbox("##value", &flag)) return flag;
    return std::nullopt;
}

std::optional<SettingValue> SettingEditor::choice(const SettingRow& row) {
    const auto* name = std::get_if<std::string>(&row.value);
    std::optional<SettingValue> chosen;
    if (!begin_list("##value", name == nullptr ? "a list" : name->c_str())) return chosen;
    for (const std::string& one : row.setting->choices) {
        if (ImGui::Selectable(one.c_str(), name != nullptr && one == *name)) chosen = one;
    }
    end_list();
    return chosen;
}

bool SettingEditor::begin_list(const char* label, const char* shown) {
    if (!ImGui::BeginCombo(label, shown)) return false;
    list_open_ = true;
    return true;
}

void SettingEditor::end_list() {
    if (closing_list_) ImGui::CloseCurrentPopup();
    ImGui::EndCombo();
}

std::optional<SettingValue> SettingEditor::number(const SettingRow& row) {
    const Setting& setting = *row.setting;
    const double value = std::get<double>(row.value);
    ImGuiSliderFlags flags = ImGuiSliderFlags_NoRoundToFormat;
    if (row.scale.logarithmic) flags |= ImGuiSliderFlags_Logarithmic;
    const unsigned int widget = ImGui::GetID("##value");
    const bool is_held = held_widget_ == widget;
    double changed = is_held ? held_values_.front() : value;
    // Dear ImGui would draw the number over the grab, but it draws what is typed
    ImGui::PushStyleColor(ImGuiCol_Text, is_held ? ImGui::GetColorU32(ImGuiCol_Text) : 0);
    const bool moved = ImGui::SliderScalar("##value", ImGuiDataType_Double, &changed, &row.scale.low, &row.scale.high,
                                           row.format.c_str(), flags);
    ImGui::PopStyleColor();
    if (setting.kind == SettingKind::Integer) changed = std::round(changed);
    if (!is_held) number_beside_grab(row, changed);
    const bool is_active = ImGui::IsItemActive();
    if (is_active && ImGui::GetIO().WantTextInput && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        // Half a number is none: what is typed counts once it is whole
        held_widget_ = widget;
        held_values_ = {changed};
        held_drawn_ = true;
        return std::nullopt;
    }
    if (is_held) forget();
    if (!moved && !is_held) return std::nullopt;
    if (setting.kind == SettingKind::Number) changed = rounded(changed);
    changed = std::clamp(changed, setting.range.low, setting.range.high);
    if (changed == value) return std::nullopt;
    return changed;
}

// Some of these make the cloth again, so a drag is carried out as it ends
std::optional<SettingValue> SettingEditor::list(const SettingRow& row) {
    const Setting& setting = *row.setting;
    std::vector<double> values = std::get<std::vector<double>>(row.value);
    const unsigned int widget = ImGui::GetID("##value");
    if (held_widget_ == widget && held_values_.size() == values.size()) values = held_values_;
    const bool is_grid = setting.kind == SettingKind::Grid;
    const float speed = is_grid ? 0.2f : 0.01f;
    const bool changed = ImGui::DragScalarN("##value", ImGuiDataType_Double, values.data(),
                                            static_cast<int>(values.size()), speed, &setting.range.low,
                                            &setting.range.high, row.format.c_str(), ImGuiSliderFlags_NoRoundToFormat);
    if (changed) {
        for (double& value : values) value = is_grid ? value : rounded(value);
        held_widget_ = widget;
        held_values_ = values;
    }
    held_drawn_ = held_drawn_ || held_widget_ == widget;
    if (held_widget_ != widget || ImGui::IsAnyItemActive()) return std::nullopt;
    forget();
    if (is_grid) {
        for (double& value : values) value = std::round(value);
    }
    return values;
}

}  // namespace drape
