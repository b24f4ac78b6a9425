#pragma once

#include <imgui.h>

#include "render/overlay_style.h"

namespace drape::test {

/// Those that are cut off at a side are neither.
struct DrawnLetters {
    int whole = 0;
    int cut = 0;  ///< at the upper or lower edge of what they are in
};

/// How many letters the panels of the last frame have in a part of the picture. A space is none.
inline DrawnLetters letters_within(const PanelBox& part) {
    DrawnLetters letters;
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int l = 0; l < data.CmdListsCount; ++l) {
        const ImDrawList& list = *data.CmdLists[l];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            // Two triangles a letter: a, b, c and a, c, d, clockwise from the upper left
            for (unsigned k = 0; k + 6 <= command.ElemCount;) {
                const ImDrawIdx* at = list.IdxBuffer.Data + command.IdxOffset + k;
                const ImDrawVert* vertices = list.VtxBuffer.Data + command.VtxOffset;
                const ImDrawVert &a = vertices[at[0]], &b = vertices[at[1]], &c = vertices[at[2]];
                const bool is_letter = at[3] == at[0] && at[4] == at[2] && a.uv.x != b.uv.x && a.uv.y != c.uv.y;
                k += is_letter ? 6 : 3;
                if (!is_letter || !part.covers(a.pos.x, a.pos.y)) continue;
                const ImVec4& shown = command.ClipRect;
                if (c.pos.y <= shown.y || a.pos.y >= shown.w || a.pos.x >= shown.z || c.pos.x <= shown.x) continue;
                const bool is_cut = a.pos.y < shown.y || c.pos.y > shown.w;
                if (is_cut) ++letters.cut;
                if (!is_cut && a.pos.x >= shown.x && c.pos.x <= shown.z) ++letters.whole;
            }
        }
    }
    return letters;
}

}  // namespace drape::test
