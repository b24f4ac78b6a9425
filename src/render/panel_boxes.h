#pragma once

#include <functional>
#include <optional>
#include <vector>

struct ImVec2;

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

/// Begins a window of Dear ImGui for widgets, on a panel's ground; `end_window` follows.
/// @param flags `ImGuiWindowFlags`
/// @return whether anything is to be made in it
[[nodiscard]] bool begin_window(const PanelBox& box, const char* name, int flags, float padding);
void end_window();

/// Where panels are that find room for themselves: the others of this frame are in the way.
/// @param size_within how large the panel is if it may be this wide [pixel]
/// @param least_width less of it would not be readable [pixel]
/// @param at_top in the middle of the top, else of the bottom
/// @return where it touches none of the others and is within the page; nothing if it is nowhere
/// @par Cost O(boxes^2)
std::optional<PanelBox> free_place(const OverlayPage& page, const std::vector<PanelBox>& others,
                                   const std::function<ImVec2(float)>& size_within, float least_width, bool at_top);

}  // namespace drape
