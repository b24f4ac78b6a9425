#include "colour_panel.h"

#include <imgui.h>

#include <array>
#include <cstdio>

#include "overlay_style.h"

namespace drape {

namespace {

using LegendText = std::array<char, 64>;

ImU32 ink_of(const std::array<float, 3>& colour) {
    return ImGui::GetColorU32(ImVec4{colour[0], colour[1], colour[2], 1});
}

LegendText title_of(const ColourScale& scale, int level) {
    LegendText text{};
    if (scale.by == ColourBy::Level) {
        std::snprintf(text.data(), text.size(), "%s %d", scale.what.data(), level);
    } else if (scale.unit.empty()) {
        std::snprintf(text.data(), text.size(), "%s", scale.what.data());
    } else {
        std::snprintf(text.data(), text.size(), "%s [%s]", scale.what.data(), scale.unit.data());
    }
    return text;
}

// A bar of all colours, with numbers at both ends and in the middle
void draw_scale(const ColourScale& scale, ImVec2 corner, float width) {
    const float line = ImGui::GetTextLineHeight(), bar = 0.8f * line;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto colours = value_colours();
    const float part = width / static_cast<float>(colours.size() - 1);
    for (std::size_t k = 0; k + 1 < colours.size(); ++k) {
        const float left = corner.x + part * static_cast<float>(k);
        const ImU32 from = ink_of(colours[k]), to = ink_of(colours[k + 1]);
        list.AddRectFilledMultiColor({left, corner.y}, {left + part, corner.y + bar}, from, to, to, from);
    }
    for (const float at : {0.0f, 0.5f, 1.0f}) {
        LegendText text{};
        std::snprintf(text.data(), text.size(), "%g", static_cast<double>(at) * scale.most);
        const float room = width - ImGui::CalcTextSize(text.data()).x;
        text_at({corner.x + at * room, corner.y + bar + 0.15f * line}, ink::text, text.data());
    }
}

void draw_swatch(ImVec2 corner, const std::array<float, 3>& colour, const char* text) {
    const float line = ImGui::GetTextLineHeight();
    ImGui::GetWindowDrawList()->AddRectFilled({corner.x, corner.y + 0.15f * line},
                                              {corner.x + 1.2f * line, corner.y + 0.85f * line}, ink_of(colour), 2);
    text_at({corner.x + 1.6f * line, corner.y}, ink::text, text);
}

}  // namespace

void colour_panel(const ColourScale& scale, int level, float taken, const OverlayPage& page) {
    const float row = ImGui::GetTextLineHeightWithSpacing(), size = ImGui::GetFontSize();
    const float inner = 15 * size, width = inner + 2 * page.margin;
    const float height = 3 * row + 2 * page.margin;
    const ImVec2 panel{page.width - page.margin - width, page.height - page.margin - height};
    if (panel.x < taken || panel.y < page.margin) return;
    draw_panel(panel, {width, height});
    const ImVec2 line{panel.x + page.margin, panel.y + page.margin};
    text_at(line, ink::wait, title_of(scale, level).data());
    const ImVec2 below{line.x, line.y + 1.25f * row};
    const auto groups = group_colours();
    if (scale.by == ColourBy::Side) {
        draw_swatch(below, groups[0], "front");
        draw_swatch({below.x + inner / 2, below.y}, groups[1], "back");
    } else if (scale.by == ColourBy::Level) {
        for (std::size_t k = 0; k < groups.size(); ++k) {
            draw_swatch({below.x + 1.5f * size * static_cast<float>(k), below.y}, groups[k], "");
        }
        text_at({below.x + 6.5f * size, below.y}, ink::text, "neighbours differ");
    } else {
        draw_scale(scale, below, inner);
    }
}

}  // namespace drape
