#include "hierarchy_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "overlay_style.h"

namespace drape {

namespace {

using PanelText = std::array<char, 64>;

PanelText heading(const FrameView& view, const ShownLevel& shown) {
    PanelText text{};
    const char* volume = name_of(view.settings->contact.volume).c_str();
    if (shown.levels == 0) {
        std::snprintf(text.data(), text.size(), "No hierarchy: %s", volume);
    } else if (shown.all) {
        std::snprintf(text.data(), text.size(), "All levels, 0 to %d, %s", shown.levels - 1, volume);
    } else {
        std::snprintf(text.data(), text.size(), "Level %d of %d, %s", shown.level, shown.levels - 1, volume);
    }
    return text;
}

constexpr std::array<const char*, 8> column_names{"level",      "nodes",    "visited",   "pruned",
                                                  "false pos.", "touching", "tightness", "fit [us]"};

// One column after the other, each as wide as its name
template <class Cell>
void for_each_column(float left, Cell cell) {
    for (std::size_t c = 0; c < column_names.size(); ++c) {
        left += ImGui::CalcTextSize(column_names[c]).x;
        cell(c, left);
        left += ImGui::GetFontSize();
    }
}

float table_width() {
    float width = 0;
    for_each_column(0, [&](std::size_t, float right) { width = right; });
    return width;
}

// Numbers end at the right edges of their columns
void draw_levels(ImVec2 corner, std::span<const LevelCounts> counts, std::span<const LevelFit> fits,
                 const ShownLevel& shown) {
    const float row = ImGui::GetTextLineHeightWithSpacing();
    for_each_column(corner.x, [&](std::size_t c, float right) {
        text_at({right - ImGui::CalcTextSize(column_names[c]).x, corner.y}, ink::quiet, column_names[c]);
    });
    for (std::size_t level = 0; level < counts.size(); ++level) {
        corner.y += row;
        const LevelCounts& of = counts[level];
        const int number = static_cast<int>(level);
        const std::array numbers{number, of.nodes, of.visited, of.pruned, of.false_positives, of.touching};
        const ImU32 colour = shown.all || number == shown.level ? ink::text : ink::quiet;
        for_each_column(corner.x, [&](std::size_t c, float right) {
            PanelText text{};
            if (c < numbers.size()) {
                std::snprintf(text.data(), text.size(), "%d", numbers[c]);
            } else if (c == numbers.size()) {
                std::snprintf(text.data(), text.size(), "%.2f", fits[level].tightness);
            } else {
                std::snprintf(text.data(), text.size(), "%.1f", 1e6 * fits[level].seconds);
            }
            text_at({right - ImGui::CalcTextSize(text.data()).x, corner.y}, colour, text.data());
        });
    }
}

// What the table cannot say by level
int notes(const FrameView& view, std::array<PanelText, 3>& lines) {
    const StepReport& report = *view.report;
    std::snprintf(lines[0].data(), lines[0].size(), "tightness: mean radius / least possible radius");
    std::snprintf(lines[1].data(), lines[1].size(), "fit: one level by itself; build of all levels: %.0f us",
                  1e6 * report.times.build / report.substeps);
    if (!view.settings->contact.self) return 2;
    std::snprintf(lines[2].data(), lines[2].size(), "cloth on cloth: %lld pair tests, %lld pruned, %lld left",
                  static_cast<long long>(view.pair_search.volume_tests),
                  static_cast<long long>(view.pair_search.pruned), static_cast<long long>(view.pair_search.leaves));
    return 3;
}

void draw_colours(ImVec2 corner, float column) {
    const float row = ImGui::GetTextLineHeightWithSpacing(), line = ImGui::GetTextLineHeight();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto looks = node_looks();
    for (std::size_t s = 0; s < looks.size(); ++s) {
        const ImVec2 at{corner.x + column * static_cast<float>(s / 3), corner.y + row * static_cast<float>(s % 3)};
        const auto& [red, green, blue, opacity] = looks[s].colour;
        // Thin lines on a bright ground are lighter than a patch on a dark one
        const ImU32 colour = ImGui::GetColorU32(ImVec4{red, green, blue, 1});
        list.AddRectFilled({at.x, at.y + 0.2f * line}, {at.x + 1.2f * line, at.y + 0.85f * line}, colour, 2);
        list.AddRect({at.x, at.y + 0.2f * line}, {at.x + 1.2f * line, at.y + 0.85f * line}, ink::quiet, 2);
        text_at({at.x + 1.7f * line, at.y}, ink::text, looks[s].text.data());
    }
}

}  // namespace

void HierarchyPanel::count(const FrameView& view, int levels) {
    counts_.assign(static_cast<std::size_t>(levels), {});
    for (const ClothView& cloth : view.cloths) {
        touched_.take(cloth, *view.report);
        for (int level = 0; level < cloth.hierarchy->levels(); ++level) {
            nodes_of_level(*cloth.hierarchy, level, nodes_);
            counts_[static_cast<std::size_t>(level)] += counts_of(nodes_, touched_);
        }
    }
}

float HierarchyPanel::draw(const FrameView& view, float taken, const OverlayPage& page) {
    const ShownLevel shown = shown_level(view);
    count(view, shown.levels);
    const float row = ImGui::GetTextLineHeightWithSpacing(), gap = 0.45f * ImGui::GetFontSize();
    const float width = table_width() + 2 * page.margin;
    float height = row + 2 * page.margin;
    std::array<PanelText, 3> lines{};
    const int line_count = notes(view, lines);
    const auto rows = static_cast<float>(counts_.size() + 1), note_rows = static_cast<float>(line_count);
    if (shown.levels > 0) height += (rows + note_rows + 3) * row + 3 * gap;

    const ImVec2 panel{page.width - page.margin - width, page.height - page.margin - height};
    if (panel.x < taken || panel.y < page.margin) return 0;
    draw_panel(panel, {width, height});
    ImVec2 line{panel.x + page.margin, panel.y + page.margin};
    text_at(line, ink::wait, heading(view, shown).data());
    if (shown.levels > 0) {
        line.y += row + gap;
        draw_levels(line, counts_, fits_.look(view, shown.levels), shown);
        line.y += rows * row + gap;
        for (int k = 0; k < line_count; ++k, line.y += row) {
            text_at(line, ink::quiet, lines[static_cast<std::size_t>(k)].data());
        }
        line.y += gap;
        draw_colours(line, 0.52f * table_width());
    }
    return height + page.margin;
}

void HierarchyPanel::name_node(const FrameView& view, const Camera& camera, int x, int y, const OverlayPage& page) {
    const auto pick = picker_.pick(view, camera, x, y, static_cast<int>(page.width), static_cast<int>(page.height));
    if (!pick) return;
    const NodeText title = node_title(*pick, view), reason = node_reason(*pick, view);
    const float row = ImGui::GetTextLineHeightWithSpacing(), size = ImGui::GetFontSize(), rim = 0.5f * size;
    const float width = std::max(ImGui::CalcTextSize(title.data()).x, ImGui::CalcTextSize(reason.data()).x) + 2 * rim;
    const float height = 2 * row + 2 * rim;
    // Below the pointer at its right, or above or at its left where there is no room
    ImVec2 corner{static_cast<float>(x) + size, static_cast<float>(y) + size};
    if (corner.x + width > page.width) corner.x = std::max(static_cast<float>(x) - width - 0.5f * size, 0.0f);
    if (corner.y + height > page.height) corner.y = std::max(static_cast<float>(y) - height - 0.5f * size, 0.0f);
    draw_panel(corner, {width, height});
    text_at({corner.x + rim, corner.y + rim}, ink::text, title.data());
    text_at({corner.x + rim, corner.y + rim + row}, ink::wait, reason.data());
}

}  // namespace drape
