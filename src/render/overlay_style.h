#pragma once

#include <imgui.h>

namespace drape {

/// Colours of the overlay.
namespace ink {
inline constexpr ImU32 text = IM_COL32(238, 240, 243, 255);
inline constexpr ImU32 quiet = IM_COL32(160, 168, 178, 255);
inline constexpr ImU32 good = IM_COL32(112, 214, 160, 255);
inline constexpr ImU32 wait = IM_COL32(255, 200, 87, 255);
inline constexpr ImU32 bad = IM_COL32(255, 107, 94, 255);
inline constexpr ImU32 bar = IM_COL32(240, 128, 96, 255);
inline constexpr ImU32 groove = IM_COL32(255, 255, 255, 26);
inline constexpr ImU32 panel = IM_COL32(20, 24, 31, 208);
}  // namespace ink

/// Opens a panel of fixed place and size; `ImGui::End` closes it.
inline void begin_panel(const char* name, ImVec2 place, ImVec2 size) {
    ImGui::SetNextWindowPos(place);
    ImGui::SetNextWindowSize(size);
    ImGui::Begin(name, nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoNav |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoFocusOnAppearing);
}

inline void coloured_text(ImU32 colour, const char* text) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
}

}  // namespace drape
