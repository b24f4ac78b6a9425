#pragma once

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace drape {

/// The picture as the panels see it, and the space around them and within [pixel].
struct OverlayPage {
    float width;
    float height;
    float margin;
};

/// The rectangle of a panel, from the top left of the picture; without a width where it is not shown [pixel].
struct PanelBox {
    float left = 0, top = 0, right = 0, bottom = 0;

    [[nodiscard]] float width() const { return right - left; }
    [[nodiscard]] bool covers(float x, float y) const { return x >= left && x < right && y >= top && y < bottom; }
};

/// Whether two panels touch, or are less than a gap apart.
inline bool overlap(const PanelBox& a, const PanelBox& b, float gap = 0) {
    return a.left < b.right + gap && b.left < a.right + gap && a.top < b.bottom + gap && b.top < a.bottom + gap;
}

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

/// Adds a panel to those of the frame, which are Dear ImGui's user data.
inline void add_panel(const PanelBox& box) {
    if (auto* boxes = static_cast<std::vector<PanelBox>*>(ImGui::GetIO().UserData)) boxes->push_back(box);
}

/// Draws a panel's ground, and adds it. All such panels are parts of one window as large as the picture, so that the
/// overlay is one draw call.
inline void draw_panel(const PanelBox& box) {
    const float rounding = 8;
    add_panel(box);
    ImGui::GetWindowDrawList()->AddRectFilled({box.left, box.top}, {box.right, box.bottom}, ink::panel, rounding);
}

inline float text_width(std::string_view text) { return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x; }

inline void draw_curve(const std::vector<ImVec2>& points, ImU32 colour) {
    const float width = std::max(1.5f, 0.1f * ImGui::GetFontSize());
    const auto count = static_cast<int>(points.size());
    ImGui::GetWindowDrawList()->AddPolyline(points.data(), count, colour, ImDrawFlags_None, width);
}

/// Text from a point of the picture on.
inline void text_at(ImVec2 corner, ImU32 colour, std::string_view text) {
    ImGui::SetCursorScreenPos(corner);
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopStyleColor();
}

/// How large a text is where its lines end before a width [pixel].
inline ImVec2 wrapped_size(const std::string& text, float width) {
    return ImGui::CalcTextSize(text.c_str(), nullptr, false, width);
}

/// Text from a point of the picture on, whose lines end before a width.
inline void wrapped_text(ImVec2 corner, float width, ImU32 colour, std::string_view text) {
    ImGui::PushTextWrapPos(corner.x + width);
    text_at(corner, colour, text);
    ImGui::PopTextWrapPos();
}

/// Wrapped texts, each in a colour, from a corner towards the middle of the picture. Nothing if the first is empty.
inline void tooltip(std::initializer_list<std::pair<ImU32, std::string>> texts, ImVec2 corner) {
    if (texts.begin()->second.empty()) return;
    const float size = ImGui::GetFontSize();
    const ImVec2 page = ImGui::GetIO().DisplaySize;
    const ImVec2 part{corner.x < page.x / 2 ? 0.0f : 1.0f, corner.y < page.y / 2 ? 0.0f : 1.0f};
    ImGui::SetNextWindowPos(corner, ImGuiCond_Always, part);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {size / 2, size / 2});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, size / 3);
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(std::min(28 * size, (part.x > 0 ? corner.x : page.x - corner.x) - size));
    for (const auto& [colour, text] : texts) {
        if (!text.empty()) ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(colour), "%s", text.c_str());
    }
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopStyleVar(2);
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

/// Begins a window of Dear ImGui for widgets, on a panel's ground, and adds it; `end_window` follows.
/// @param flags `ImGuiWindowFlags`
/// @return whether anything is to be made in it
[[nodiscard]] bool begin_window(const PanelBox& box, const char* name, int flags, float padding);
void end_window();

/// Where panels are that find room for themselves: the others of this frame are in the way.
/// @param size_within how large the panel is if it may be this wide [pixel]
/// @param min_width less of it would not be readable [pixel]
/// @param at_top in the middle of the top, else of the bottom
/// @return where it touches none of the others and is within the page; nothing if it is nowhere
/// @par Cost O(boxes^2)
std::optional<PanelBox> free_place(const OverlayPage& page, const std::vector<PanelBox>& others,
                                   const std::function<ImVec2(float)>& size_within, float min_width, bool at_top);

}  // namespace drape
