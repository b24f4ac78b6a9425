#pragma once

#include <imgui.h>

#include <array>
#include <cmath>
#include <map>
#include <string>

namespace drape::test {

/// What the panels of the last frame say, from the glyphs that they draw: a line each, and a blank where text goes on
/// with a gap, as from the name of a figure to its value. What is cut is not there.
inline std::string drawn_text() {
    std::map<std::array<float, 4>, const ImFontGlyph*> glyphs;
    for (ImFont* font : ImGui::GetIO().Fonts->Fonts) {
#if IMGUI_VERSION_NUM < 19200
        const auto& of_font = font->Glyphs;
#else
        const auto& of_font = font->GetFontBaked(font->LegacySize)->Glyphs;
#endif
        for (const ImFontGlyph& glyph : of_font) {
            if (glyph.Visible) glyphs[{glyph.U0, glyph.V0, glyph.U1, glyph.V1}] = &glyph;
        }
    }
    std::string text;
    ImVec2 pen{0, 0};
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int l = 0; l < data.CmdListsCount; ++l) {
        const auto& corners = data.CmdLists[l]->VtxBuffer;
        for (int v = 0; v + 3 < corners.Size;) {
            const ImDrawVert &first = corners[v], &third = corners[v + 2];
            const auto found = glyphs.find({first.uv.x, first.uv.y, third.uv.x, third.uv.y});
            if (found == glyphs.end()) {
                ++v;
                continue;
            }
            const ImFontGlyph& glyph = *found->second;
            const ImVec2 at{first.pos.x - glyph.X0, first.pos.y - glyph.Y0};
            if (std::abs(at.y - pen.y) > 0.5f) {
                text += '\n';
            } else if (std::abs(at.x - pen.x) > 0.5f) {
                text += ' ';
            }
            text += static_cast<char>(glyph.Codepoint);
            pen = {at.x + glyph.AdvanceX, at.y};
            v += 4;
        }
    }
    return text;
}

}  // namespace drape::test
