#include "panels.h"

#include <imgui.h>

#include <array>
#include <optional>
#include <string>

#include "format_text.h"
#include "overlay_style.h"

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

void draw_swatch(ImVec2 corner, const std::array<float, 3>& colour, const char* text) {
    const float line = ImGui::GetTextLineHeight();
    ImGui::GetWindowDrawList()->AddRectFilled({corner.x, corner.y + 0.15f * line},
                                              {corner.x + 1.2f * line, corner.y + 0.85f * line}, ink_of(colour), 2);
    text_at({corner.x + 1.6f * line, corner.y}, ink::text, text);
}

// The panel, with its title. Where it begins; nothing where there is no room
std::optional<ImVec2> begin_legend(const std::string& title, float rows, float taken, const OverlayPage& page) {
    const float width = legend_columns * ImGui::GetFontSize() + 2 * page.margin;
    const float height = rows * ImGui::GetTextLineHeightWithSpacing() + 2 * page.margin;
    const ImVec2 panel{page.width - page.margin - width, page.height - page.margin - height};
    if (panel.x < taken || panel.y < page.margin) return {};
    draw_panel(panel, {width, height});
    const ImVec2 line{panel.x + page.margin, panel.y + page.margin};
    text_at(line, ink::wait, title);
    return line;
}

}  // namespace

void colour_panel(const ColourScale& scale, int level, float taken, const OverlayPage& page) {
    const float row = ImGui::GetTextLineHeightWithSpacing(), size = ImGui::GetFontSize(), inner = legend_columns * size;
    const auto line = begin_legend(title_of(scale, level), 3, taken, page);
    if (!line) return;
    const ImVec2 below{line->x, line->y + 1.25f * row};
    if (scale.by == ColourBy::Side) {
        draw_swatch(below, group_colours[0], "front");
        draw_swatch({below.x + inner / 2, below.y}, group_colours[1], "back");
    } else if (scale.by == ColourBy::Level) {
        for (std::size_t k = 0; k < group_colours.size(); ++k) {
            draw_swatch({below.x + 1.5f * size * static_cast<float>(k), below.y}, group_colours[k], "");
        }
        text_at({below.x + 6.5f * size, below.y}, ink::text, "neighbours differ");
    } else {
        draw_scale(scale, below, inner);
    }
}

float line_panel(const std::string& title, std::span<const LineColour> colours, float taken, const OverlayPage& page) {
    const float row = ImGui::GetTextLineHeightWithSpacing(), size = ImGui::GetFontSize();
    const auto line = begin_legend(title, 2.1f, taken, page);
    if (!line) return 0;
    const float column = legend_columns * size / static_cast<float>(colours.size());
    for (std::size_t k = 0; k < colours.size(); ++k) {
        const ImVec2 corner{line->x + column * static_cast<float>(k), line->y + 1.15f * row};
        draw_swatch(corner, colours[k].colour, colours[k].text);
    }
    return 2.1f * row + 3 * page.margin;
}

}  // namespace drape
