#include "figures_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "drape/integrate/integrator.h"
#include "overlay_style.h"

namespace drape {

namespace {

struct Row {
    const char* name;
    std::string value;
    float part = -1;        // of a bar, in [0, 1]; below 0 there is none
    int importance = 1;     // rows of the lowest go first where there is no room
    ImU32 colour = ink::text;
    bool opens_group = false;
};

template <class... Values>
std::string format(const char* pattern, Values... values) {
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), pattern, values...);
    return text.data();
}

// 1234567 as "1 234 567"
std::string grouped(double value) {
    const std::string digits = format("%.0f", value);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0 && digits[i - 1] != '-') text += ' ';
        text += digits[i];
    }
    return text;
}

std::string energy(Real value) { return format("%.4f J", static_cast<double>(value)); }

Row state_row(const FrameView& view) {
    const StepReport& report = *view.report;
    if (report.status == Status::Diverged) return {"state", "diverged", -1, 4, ink::bad};
    if (view.paused) return {"state", "paused", -1, 4, ink::wait};
    return {"state", view.held ? "running, in hand" : "running", -1, 4, ink::good};
}

void add_time_rows(const FrameView& view, std::vector<Row>& rows) {
    const StepReport& report = *view.report;
    const SolverSettings& solver = view.settings->solver;
    rows.push_back(state_row(view));
    rows.push_back({"method", std::string(name_of(solver.integrator)), -1, 4});
    rows.push_back({"step", grouped(static_cast<double>(report.step)), -1, 3});
    rows.push_back({"step size", format("%g ms, fixed", 1000 * static_cast<double>(solver.dt)), -1, 3});
    rows.push_back({"time", format("%.3f s", report.time), -1, 3});
}

void add_stage_rows(const StageTimes& times, std::vector<Row>& rows) {
    const std::array<std::pair<const char*, double>, 5> stages{{{"integrate", times.step},
                                                                {"build", times.build},
                                                                {"traverse", times.traverse},
                                                                {"narrow", times.narrow},
                                                                {"respond", times.respond}}};
    const double total = std::max(times.total(), 1e-12);
    for (const auto& [name, seconds] : stages) {
        rows.push_back({name, format("%.1f us", 1e6 * seconds), static_cast<float>(seconds / total), 1, ink::text,
                        name == stages.front().first});
    }
}

void add_count_rows(const StepReport& report, std::vector<Row>& rows) {
    const auto visited = static_cast<double>(report.traversal.visited);
    const auto nodes = static_cast<double>(report.traversal.nodes);
    rows.push_back({"nodes", grouped(visited) + " of " + grouped(nodes), -1, 3, ink::text, true});
    rows.push_back({"candidates", grouped(static_cast<double>(report.traversal.candidates)), -1, 2});
    rows.push_back({"contacts", grouped(static_cast<double>(report.contacts)), -1, 3});
    rows.push_back({"kinetic", energy(report.energy.kinetic), -1, 2, ink::text, true});
    rows.push_back({"gravity", energy(report.energy.gravity), -1, 1});
    rows.push_back({"spring", energy(report.energy.spring), -1, 1});
    rows.push_back({"total", energy(report.energy.total()), -1, 2});
}

void add_cost_rows(const FrameReport& last, std::vector<Row>& rows) {
    rows.push_back({"frames", format("%.1f / s", last.rate), -1, 3, ink::text, true});
    rows.push_back({"processor", format("%.0f %%", 100 * last.cpu), -1, 2});
    rows.push_back({"GL calls", grouped(last.gl_calls), -1, 2});
    rows.push_back({"vertices", grouped(last.vertices), -1, 2});
}

float height_of(const std::vector<Row>& rows, float line, float gap) {
    float height = 0;
    for (const Row& row : rows) height += line + (row.opens_group ? gap : 0);
    return height;
}

// Leaves out rows until the rest fits
void drop_rows(std::vector<Row>& rows, float line, float gap, float room) {
    while (!rows.empty() && height_of(rows, line, gap) > room) {
        const auto least = std::min_element(rows.rbegin(), rows.rend(), [](const Row& a, const Row& b) {
            return a.importance < b.importance;
        });
        rows.erase(std::next(least).base());
    }
}

void draw_row(const Row& row, float gap, float value_column, float bar_start, float bar_end) {
    if (row.opens_group) ImGui::SetCursorPosY(ImGui::GetCursorPosY() + gap);
    const ImVec2 place = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetTextLineHeight();
    coloured_text(ink::quiet, row.name);
    ImGui::SameLine(value_column);
    coloured_text(row.colour, row.value.c_str());
    if (row.part < 0) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float top = place.y + 0.36f * line, bottom = place.y + 0.74f * line;
    list.AddRectFilled({bar_start, top}, {bar_end, bottom}, ink::groove, 2);
    const float filled = bar_start + row.part * (bar_end - bar_start);
    if (filled - bar_start > 1) list.AddRectFilled({bar_start, top}, {filled, bottom}, ink::bar, 2);
}

}  // namespace

float figures_panel(const FrameView& view, const FrameReport& last, ImFont* title, float width, float height) {
    std::vector<Row> rows;
    add_time_rows(view, rows);
    add_stage_rows(view.report->times, rows);
    add_count_rows(*view.report, rows);
    add_cost_rows(last, rows);

    // Size: as wide as it must be, at most the picture
    const ImGuiStyle& style = ImGui::GetStyle();
    const float margin = style.WindowPadding.y, size = ImGui::GetFontSize();
    const float line = ImGui::GetTextLineHeightWithSpacing(), gap = 0.45f * size;
    const float title_height = title->FontSize + 0.4f * size;
    drop_rows(rows, line, gap, height - 4 * margin - title_height);
    const float panel_width = std::min(15.5f * size + 2 * style.WindowPadding.x, width - 2 * margin);
    const float panel_height = height_of(rows, line, gap) + title_height + 2 * margin - style.ItemSpacing.y;

    begin_panel("figures", {margin, margin}, {panel_width, std::min(panel_height, height - 2 * margin)});
    ImGui::PushFont(title);
    const std::string& name = view.settings->title;
    ImGui::TextUnformatted(name.empty() ? "Drape" : name.c_str());
    ImGui::PopFont();
    ImGui::SetCursorPosY(margin + title_height);
    const float right = margin + panel_width - style.WindowPadding.x;
    const float value_column = style.WindowPadding.x + 5.8f * size;
    for (const Row& row : rows) draw_row(row, gap, value_column, margin + value_column + 5.2f * size, right);
    ImGui::End();
    return margin + panel_width;
}

}  // namespace drape
