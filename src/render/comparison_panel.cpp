#include "panels.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace drape {

namespace {

constexpr double kept_interval = 1.0 / 24;  // s of scene time between two that are kept

struct ComparedFigure {
    const char* label;  // with its unit
    const char* format;
    double (*read)(const StepReport&);
};

constexpr std::array<ComparedFigure, 8> compared_figures{{
    {"step [us]", "%.0f", [](const StepReport& r) { return 1e6 * r.times.total(); }},
    {"BVH [us]", "%.1f", [](const StepReport& r) { return 1e6 * (r.times.build + r.times.traverse); }},
    {"volume tests", "%.0f", [](const StepReport& r) { return static_cast<double>(r.traversal.volume_tests); }},
    {"candidates", "%.0f", [](const StepReport& r) { return static_cast<double>(r.traversal.candidates); }},
    {"contacts", "%.0f", [](const StepReport& r) { return static_cast<double>(r.contacts); }},
    {"penetration [mm]", "%.3f", [](const StepReport& r) { return 1e3 * r.penetration; }},
    {"stretch [%]", "%.2f", [](const StepReport& r) { return 100 * r.stretch; }},
    {"energy [J]", "%.4g", [](const StepReport& r) { return r.energy.total(); }},
}};

// Less than a picometre is rounding
std::string millimetres(double metres) {
    return format(metres < 1e-12 ? "0" : metres < 1e-4 ? "%.2g" : metres < 0.1 ? "%.3g" : "%.0f", 1e3 * metres);
}

std::string figure_text(const ComparedFigure& row, const StepReport& report) {
    if (report.status != Status::Ok) return "diverged";
    // Counts stay those of the last step that was awake
    const bool is_time = std::string_view(row.label).ends_with("[us]");
    return report.asleep && is_time ? "asleep" : format(row.format, row.read(report));
}

// Of the legend, where the settings of the other run begin [font size]
constexpr float settings_column = 6;

// Which of both cloths is which
void draw_legend(const std::string& other_settings, ImVec2 line, float end) {
    const float row = ImGui::GetTextLineHeightWithSpacing(), size = ImGui::GetFontSize();
    const float text = line.x + settings_column * size;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 swatch{line.x, line.y + 0.1f * size}, far{swatch.x + 1.5f * size, swatch.y + 0.9f * size};
    list.AddRectFilled(swatch, far, ink::quiet, 2);
    text_at({line.x + 2 * size, line.y}, ink::quiet, "surface");
    text_at({text, line.y}, ink::text, "this run");

    // Lines as in the picture, on a light ground
    const float down = row, third = (far.x - swatch.x) / 3;
    list.AddRectFilled({swatch.x, swatch.y + down}, {far.x, far.y + down}, ink::quiet, 2);
    for (int k = 1; k < 3; ++k) {
        const float x = swatch.x + static_cast<float>(k) * third;
        list.AddLine({x, swatch.y + down}, {x, far.y + down}, ink::popup, 1);
    }
    const float middle = (swatch.y + far.y) / 2 + down;
    list.AddLine({swatch.x, middle}, {far.x, middle}, ink::popup, 1);
    text_at({line.x + 2 * size, line.y + row}, ink::quiet, "lines");
    wrapped_text({text, line.y + row}, end - text, ink::text, other_settings);
}

}  // namespace

void ComparisonPanel::keep(const FrameView& view) {
    if (view.comparison == nullptr) other_medians_ = {};
    if (view.comparison == nullptr || view.report->time < time_) distances_.clear();
    if (view.comparison == nullptr) return;
    other_medians_.keep(*view.comparison->other.report);
    if (!distances_.empty() && view.report->time < time_ + kept_interval) return;
    if (distances_.size() == most) distances_.pop_front();
    distances_.push_back(view.comparison->rms);
    time_ = view.report->time;
}

float ComparisonPanel::draw(const FrameView& view, const OverlayPage& page, float left, float right) const {
    const float row = ImGui::GetTextLineHeightWithSpacing(), size = ImGui::GetFontSize(), margin = page.margin;
    const float width = 24 * size, curve = 3 * size;
    std::string settings;  // an assignment a line
    for (const std::string& assignment : split_assignments(view.comparison->assignments)) {
        settings += (settings.empty() ? "" : "\n") + assignment;
    }
    const float settings_width = width - 2 * margin - settings_column * size;
    const float lines = wrapped_size(settings, settings_width).y;
    const float legend = row + lines + ImGui::GetStyle().ItemSpacing.y;
    const float height = static_cast<float>(compared_figures.size() + 2) * row + legend + curve + 2 * margin;
    const ImVec2 panel{right - width, margin};
    if (height + 2 * margin > page.height || panel.x < left) return right;
    draw_panel({panel.x, margin, right, margin + height});
    ImVec2 line{panel.x + margin, panel.y + margin};
    const float first = line.x + 9 * size, other = line.x + 15.5f * size, end = right - margin;
    const StepReport other_report = other_medians_.with_median_times(*view.comparison->other.report);

    draw_legend(settings, line, end);
    line.y += legend;
    text_at({first, line.y}, ink::quiet, "surface");
    text_at({other, line.y}, ink::quiet, "lines");
    for (const ComparedFigure& figures : compared_figures) {
        line.y += row;
        text_at(line, ink::quiet, figures.label);
        text_at({first, line.y}, ink::text, figure_text(figures, *view.report));
        text_at({other, line.y}, ink::text, figure_text(figures, other_report));
    }
    line.y += row;
    const std::string rms = millimetres(view.comparison->rms), apart = millimetres(view.comparison->largest);
    text_at(line, ink::quiet, "apart, RMS [mm]");
    text_at({first, line.y}, ink::wait, rms + ", most " + apart);

    // The curve, from 0 to the largest that is kept, or to 1 mm
    line.y += row;
    double largest = 1e-3;
    for (const double distance : distances_) largest = std::max(largest, distance);
    const float bottom = line.y + curve;
    std::vector<ImVec2> points;
    for (const double distance : distances_) {
        const float back = static_cast<float>(distances_.size() - 1 - points.size()) / static_cast<float>(most - 1);
        points.emplace_back(end - back * (end - line.x), bottom - static_cast<float>(distance / largest) * curve);
    }
    ImGui::GetWindowDrawList()->AddLine({line.x, bottom}, {end, bottom}, ink::groove);
    draw_curve(points, ink::bar);
    text_at({line.x, line.y}, ink::quiet, millimetres(largest) + " mm");
    return panel.x;
}

}  // namespace drape
