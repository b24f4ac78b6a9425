#include "panels.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>

namespace drape {

namespace {

std::string heading(const FrameView& view, const ShownLevel& shown) {
    const std::string volume = name_of(view.settings->contact.volume);
    if (shown.levels == 0) return "No hierarchy: " + volume;
    const std::string level = shown.all ? "All levels, 0 to " : "Level " + std::to_string(shown.level) + " of ";
    return level + std::to_string(shown.levels - 1) + ", " + volume;
}

constexpr std::array<const char*, 8> column_names{"level",      "nodes",    "visited",   "pruned",
                                                  "false pos.", "touching", "tightness", "fit [us]"};

// One column after the other, each as wide as its name
template <class Cell>
void for_each_column(float left, Cell cell) {
    for (std::size_t c = 0; c < column_names.size(); ++c) {
        left += text_width(column_names[c]);
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
        text_before({right, corner.y}, ink::quiet, column_names[c]);
    });
    for (std::size_t level = 0; level < counts.size(); ++level) {
        corner.y += row;
        const LevelCounts& of = counts[level];
        const int number = static_cast<int>(level);
        const std::array numbers{number, of.nodes, of.visited, of.pruned, of.false_positives, of.touching};
        const ImU32 colour = shown.all || number == shown.level ? ink::text : ink::quiet;
        for_each_column(corner.x, [&](std::size_t c, float right) {
            text_before({right, corner.y}, colour,
                        c < numbers.size()    ? std::to_string(numbers[c])
                        : c == numbers.size() ? format("%.2f", fits[level].tightness)
                                              : format("%.1f", 1e6 * fits[level].seconds));
        });
    }
}

// What the table cannot say by level
std::vector<std::string> notes(const FrameView& view) {
    const StepReport& report = *view.report;
    std::vector<std::string> lines{
        "tightness: mean radius / least possible radius",
        format("fit: one level by itself; build of all levels: %.0f us", 1e6 * report.times.build / report.substeps)};
    if (view.settings->contact.self) {
        const TraversalStats& pairs = view.pair_search;
        lines.push_back("cloth on cloth: " + std::to_string(pairs.volume_tests) + " pair tests, " +
                        std::to_string(pairs.pruned) + " pruned, " + std::to_string(pairs.leaves) + " left");
    }
    return lines;
}

void draw_colours(ImVec2 corner, float column) {
    const float row = ImGui::GetTextLineHeightWithSpacing();
    for (std::size_t s = 0; s < static_cast<std::size_t>(NodeState::Compared); ++s) {
        // Thin lines on a bright ground are lighter than a patch on a dark one
        swatch_at({corner.x + column * static_cast<float>(s / 3), corner.y + row * static_cast<float>(s % 3)},
                  node_looks[s].colour, node_looks[s].text);
    }
}

}  // namespace

void HierarchyPanel::count(const FrameView& view, int levels) {
    counts_.assign(static_cast<std::size_t>(levels), {});
    for (const ClothView& cloth : view.cloths) {
        touched_.take(cloth, *view.report);
        for (int level = 0; level < cloth.hierarchy->levels(); ++level) {
            nodes_of_level(*cloth.hierarchy, level, nodes_);
            counts_[static_cast<std::size_t>(level)].add(nodes_, touched_);
        }
    }
}

float HierarchyPanel::draw(const FrameView& view, float taken, const OverlayPage& page) {
    const ShownLevel shown = shown_level(view);
    count(view, shown.levels);
    const float row = ImGui::GetTextLineHeightWithSpacing(), gap = 0.45f * ImGui::GetFontSize();
    const float width = table_width() + 2 * page.margin;
    float height = row + 2 * page.margin;
    const std::vector<std::string> lines = notes(view);
    const auto rows = static_cast<float>(counts_.size() + 1), note_rows = static_cast<float>(lines.size());
    if (shown.levels > 0) height += (rows + note_rows + 3) * row + 3 * gap;

    const auto start = begin_legend(heading(view, shown), {width, height}, taken, page);
    if (!start) return 0;
    ImVec2 line = *start;
    if (shown.levels > 0) {
        line.y += row + gap;
        draw_levels(line, counts_, fits_.look(view, shown.levels), shown);
        line.y += rows * row + gap;
        for (const std::string& note : lines) {
            text_at(line, ink::quiet, note);
            line.y += row;
        }
        line.y += gap;
        draw_colours(line, 0.52f * table_width());
    }
    return height + page.margin;
}

void HierarchyPanel::name_node(const FrameView& view, const Camera& camera, int x, int y, const OverlayPage& page) {
    const auto pick = picker_.pick(view, camera, x, y, static_cast<int>(page.width), static_cast<int>(page.height));
    if (!pick) return;
    const std::string title = node_title(*pick, view), reason = node_reason(*pick, view);
    const float row = ImGui::GetTextLineHeightWithSpacing(), size = ImGui::GetFontSize(), rim = 0.5f * size;
    const float width = std::max(text_width(title), text_width(reason)) + 2 * rim;
    const float height = 2 * row + 2 * rim;
    // Below the pointer at its right, or above or at its left where there is no room
    ImVec2 corner{static_cast<float>(x) + size, static_cast<float>(y) + size};
    if (corner.x + width > page.width) corner.x = std::max(static_cast<float>(x) - width - 0.5f * size, 0.0f);
    if (corner.y + height > page.height) corner.y = std::max(static_cast<float>(y) - height - 0.5f * size, 0.0f);
    draw_panel({corner.x, corner.y, corner.x + width, corner.y + height});
    text_at({corner.x + rim, corner.y + rim}, ink::text, title);
    text_at({corner.x + rim, corner.y + rim + row}, ink::wait, reason);
}

}  // namespace drape
