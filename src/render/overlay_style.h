#pragma once

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "panel_boxes.h"

namespace drape {

/// Colours of the overlay.
namespace ink {
inline constexpr ImU32 text = IM_COL32(238, 240, 243, 255);
inline constexpr ImU32 quiet = IM_COL32(160, 168, 178, 255);
inline constexpr ImU32 dim = IM_COL32(120, 127, 137, 255);
inline constexpr ImU32 good = IM_COL32(112, 214, 160, 255);
inline constexpr ImU32 wait = IM_COL32(255, 200, 87, 255);
inline constexpr ImU32 bad = IM_COL32(255, 107, 94, 255);
inline constexpr ImU32 bar = IM_COL32(240, 128, 96, 255);
inline constexpr ImU32 grab = IM_COL32(156, 76, 54, 255);     ///< under text, which is readable on it
inline constexpr ImU32 grabbed = IM_COL32(176, 90, 62, 255);  ///< likewise
inline constexpr ImU32 groove = IM_COL32(255, 255, 255, 26);
inline constexpr ImU32 lit = IM_COL32(255, 255, 255, 52);
inline constexpr ImU32 popup = IM_COL32(34, 38, 48, 245);
inline constexpr ImU32 panel = IM_COL32(22, 26, 34, 196);
}  // namespace ink

/// What `std::printf` would print, of at most 199 bytes.
template <class... Values>
std::string format(const char* pattern, Values... values) {
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(), pattern, values...);
    return text.data();
}

/// A font in one of its sizes.
struct PanelFont {
    ImFont* font = nullptr;
    float size = 0;  ///< [pixel]

    /// In force until `ImGui::PopFont`.
    void push() const {
#if IMGUI_VERSION_NUM < 19200
        ImGui::PushFont(font);
#else
        ImGui::PushFont(font, size);
#endif
    }
};

/// Draws a panel's ground, and adds it to the panels of the frame, which are Dear ImGui's user data.
/// All panels are parts of one window as large as the picture, so that the overlay is one draw call.
inline void draw_panel(const PanelBox& box) {
    const float rounding = 8;
    if (auto* boxes = static_cast<std::vector<PanelBox>*>(ImGui::GetIO().UserData)) boxes->push_back(box);
    ImGui::GetWindowDrawList()->AddRectFilled({box.left, box.top}, {box.right, box.bottom}, ink::panel, rounding);
}

inline float text_width(std::string_view text) { return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x; }

/// Of curves [pixel].
inline float curve_width() { return std::max(1.5f, 0.1f * ImGui::GetFontSize()); }

/// Text from a point of the picture on.
inline void text_at(ImVec2 corner, ImU32 colour, std::string_view text) {
    ImGui::SetCursorScreenPos(corner);
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopStyleColor();
}

/// A patch of a colour, in sRGB, with what it means beside it.
/// @param colour red, green and blue; more is left out
inline void swatch_at(ImVec2 corner, std::span<const float> colour, std::string_view text) {
    const float line = ImGui::GetTextLineHeight();
    const ImVec2 upper{corner.x, corner.y + 0.2f * line}, lower{corner.x + 1.2f * line, corner.y + 0.85f * line};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(upper, lower, ImGui::GetColorU32(ImVec4{colour[0], colour[1], colour[2], 1}), 2);
    list.AddRect(upper, lower, ink::quiet, 2);
    text_at({corner.x + 1.6f * line, corner.y}, ink::text, text);
}

/// Text up to a point of the picture.
inline void text_before(ImVec2 corner, ImU32 colour, std::string_view text) {
    text_at({corner.x - text_width(text), corner.y}, colour, text);
}

}  // namespace drape
