#include "panels.h"

#include <imgui.h>

#include <array>
#include <optional>
#include <string>

#include "node_pick.h"

namespace drape {

namespace {

// Begins a panel at the lower right, with its title; the size has its margins in it. What is left of `taken` belongs to
// others. Returns where its lines begin, or nothing where there is no room
std::optional<ImVec2> begin_legend(const std::string& title, ImVec2 size, float taken, const OverlayPage& page) {
    const float right = page.width - page.margin, bottom = page.height - page.margin;
    const PanelBox box{right - size.x, bottom - size.y, right, bottom};
    if (box.left < taken || box.top < page.margin) return {};
    draw_panel(box);
    const ImVec2 line{box.left + page.margin, box.top + page.margin};
    text_at(line, ink::wait, title);
    return line;
}

constexpr float legend_columns = 15;  // font size

ImU32 ink_of(const std::array<float, 3>& colour) {
    return ImGui::GetColorU32(ImVec4{colour[0], colour[1], colour[2], 1});
}

std::string title_of(const ColourScale& scale, int level) {
    const std::string what(scale.what);
    if (scale.by == ColourBy::Level) return what + " " + std::to_string(level);
    return scale.unit.empty() ? what : what + " [" + std::string(scale.unit) + "]";
}

// A bar of all colours, with numbers at both ends and in the middle
void draw_scale(const ColourScale& scale, ImVec2 corner, float width) {
    const float line = ImGui::GetTextLineHeight(), bar = 0.8f * line;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float part = width / static_cast<float>(value_colours.size() - 1);
    for (std::size_t k = 0; k + 1 < value_colours.size(); ++k) {
        const float left = corner.x + part * static_cast<float>(k);
        const ImU32 from = ink_of(value_colours[k]), to = ink_of(value_colours[k + 1]);
        list.AddRectFilledMultiColor({left, corner.y}, {left + part, corner.y + bar}, from, to, to, from);
    }
    for (const float at : {0.0f, 0.5f, 1.0f}) {
        const std::string text = format("%g", static_cast<double>(at) * scale.most);
        const float room = width - text_width(text);
        text_at({corner.x + at * room, corner.y + bar + 0.15f * line}, ink::text, text);
    }
}

// Of the colours in rows
ImVec2 legend_size(float rows, const OverlayPage& page) {
    return {legend_columns * ImGui::GetFontSize() + 2 * page.margin,
            rows * ImGui::GetTextLineHeightWithSpacing() + 2 * page.margin};
}

std::string heading(const FrameView& view, const ShownLevel& shown) {
    const std::string volume = name_of(view.settings->contact.volume);
    if (shown.levels == 0) return "No hierarchy: " + volume;
    const std::string level = shown.all ? "All levels, 0 to " : "Level " + std::to_string(shown.level) + " of 0 to ";
    const char* search = !view.balls.empty()           ? ": ball on cloth"
                         : view.settings->contact.self ? ": cloth on cloth"
                                                       : "";
    return level + std::to_string(shown.levels - 1) + ", " + volume + search;
}

constexpr std::array<const char*, 8> column_names{"level",          "nodes",    "visited",   "pruned",
                                                  "false positive", "touching", "tightness", "fit [us]"};

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
    const double build = 1e6 * report.times.build / report.substeps;
    const std::string all_levels = build > 0 ? format("; build of all levels: %.0f us", build) : "";
    std::vector<std::string> lines{"tightness: mean radius / least possible radius",
                                   "fit: one level by itself" + all_levels};
    if (const SearchTimes* all = view.search) {
        lines.push_back(format("in all: %.0f tests, by brute force %.0f; %.1fx as fast", all->tests,
                               all->tests_of_brute_force, all->speed_up()));
    }
    if (view.balls.size() > 1) lines.push_back(format("%zu balls: each node counts once", view.balls.size()));
    if (const TraversalStats& pairs = view.pair_search; pairs.visited > 0) {
        lines.push_back("for this picture: " + std::to_string(pairs.volume_tests) + " pairs of nodes tested, " +
                        std::to_string(pairs.leaves) + " of leaves left");
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

float hierarchy_panel(const FrameView& view, LevelFits& fits, float taken, const OverlayPage& page) {
    const ShownLevel shown = shown_level(view);
    std::vector<LevelCounts> counts(static_cast<std::size_t>(shown.levels));
    std::vector<NodeView> nodes;
    for (const ClothView& cloth : view.cloths) {
        const TouchedCells touched(cloth, *view.report);
        for (int level = 0; level < cloth.hierarchy->levels(); ++level) {
            nodes_of_level(*cloth.hierarchy, level, nodes);
            counts[static_cast<std::size_t>(level)].add(nodes, touched);
        }
    }
    const float row = ImGui::GetTextLineHeightWithSpacing(), gap = 0.45f * ImGui::GetFontSize();
    const float width = table_width() + 2 * page.margin;
    float height = row + 2 * page.margin;
    const std::vector<std::string> lines = notes(view);
    const auto rows = static_cast<float>(counts.size() + 1), note_rows = static_cast<float>(lines.size());
    if (shown.levels > 0) height += (rows + note_rows + 3) * row + 3 * gap;

    const auto start = begin_legend(heading(view, shown), {width, height}, taken, page);
    if (!start) return 0;
    ImVec2 line = *start;
    if (shown.levels > 0) {
        line.y += row + gap;
        draw_levels(line, counts, fits.look(view, shown.levels), shown);
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

void node_panel(const FrameView& view, const Camera& camera, int x, int y, const OverlayPage& page) {
    const auto pick = pick_node(view, camera, x, y, static_cast<int>(page.width), static_cast<int>(page.height));
    if (!pick) return;
    const float size = ImGui::GetFontSize(), across = static_cast<float>(x), down = static_cast<float>(y);
    const auto beside = [size](float at, float room) { return at < room / 2 ? at + size : at - size / 2; };
    tooltip({{ink::text, node_title(*pick, view)}, {ink::wait, node_reason(*pick, view)}},
            {beside(across, page.width), beside(down, page.height)});
}

void colour_panel(const ColourScale& scale, int level, float taken, const OverlayPage& page) {
    const float row = ImGui::GetTextLineHeightWithSpacing(), size = ImGui::GetFontSize(), inner = legend_columns * size;
    const auto line = begin_legend(title_of(scale, level), legend_size(3, page), taken, page);
    if (!line) return;
    const ImVec2 below{line->x, line->y + 1.25f * row};
    if (scale.by == ColourBy::Side) {
        swatch_at(below, group_colours[0], "front");
        swatch_at({below.x + inner / 2, below.y}, group_colours[1], "back");
    } else if (scale.by == ColourBy::Level) {
        for (std::size_t k = 0; k < group_colours.size(); ++k) {
            swatch_at({below.x + 1.5f * size * static_cast<float>(k), below.y}, group_colours[k], "");
        }
        text_at({below.x + 6.5f * size, below.y}, ink::text, "neighbours differ");
    } else {
        draw_scale(scale, below, inner);
    }
}

float line_panel(const std::string& title, std::span<const LineLook> looks, float taken, const OverlayPage& page) {
    const float row = ImGui::GetTextLineHeightWithSpacing(), size = ImGui::GetFontSize();
    const auto line = begin_legend(title, legend_size(2.1f, page), taken, page);
    if (!line) return 0;
    const float column = legend_columns * size / static_cast<float>(looks.size());
    for (std::size_t k = 0; k < looks.size(); ++k) {
        const ImVec2 corner{line->x + column * static_cast<float>(k), line->y + 1.15f * row};
        swatch_at(corner, looks[k].colour, looks[k].text);
    }
    return 2.1f * row + 3 * page.margin;
}

}  // namespace drape
