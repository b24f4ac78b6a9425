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

// From its right edge to the left
void number_at(float right, float top, ImU32 colour, int number) {
    PanelText text{};
    std::snprintf(text.data(), text.size(), "%d", number);
    text_at({right - ImGui::CalcTextSize(text.data()).x, top}, colour, text.data());
}

constexpr std::array<const char*, 6> column_names{"level", "nodes", "visited", "pruned", "false pos.", "touching"};

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

void draw_levels(ImVec2 corner, std::span<const LevelCounts> counts, const ShownLevel& shown) {
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
        for_each_column(corner.x, [&](std::size_t c, float right) { number_at(right, corner.y, colour, numbers[c]); });
    }
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
        touched_.take(cloth.model.grid, cloth.contacts, view.report->step > 0);
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
    if (shown.levels > 0) height += (1 + static_cast<float>(counts_.size())) * row + 3 * row + 2 * gap;

    const ImVec2 panel{page.width - page.margin - width, page.height - page.margin - height};
    if (panel.x < taken || panel.y < page.margin) return 0;
    draw_panel(panel, {width, height});
    ImVec2 line{panel.x + page.margin, panel.y + page.margin};
    text_at(line, ink::wait, heading(view, shown).data());
    if (shown.levels > 0) {
        line.y += row + gap;
        draw_levels(line, counts_, shown);
        line.y += static_cast<float>(counts_.size() + 1) * row + gap;
        draw_colours(line, 0.52f * table_width());
    }
    return height + page.margin;
}

}  // namespace drape
