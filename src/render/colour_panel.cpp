#include "panels.h"

#include <imgui.h>

#include <array>
#include <optional>
#include <string>

namespace drape {

namespace {

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

}  // namespace

std::optional<ImVec2> begin_legend(const std::string& title, ImVec2 size, float taken, const OverlayPage& page) {
    const float right = page.width - page.margin, bottom = page.height - page.margin;
    const PanelBox box{right - size.x, bottom - size.y, right, bottom};
    if (box.left < taken || box.top < page.margin) return {};
    draw_panel(box);
    const ImVec2 line{box.left + page.margin, box.top + page.margin};
    text_at(line, ink::wait, title);
    return line;
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
