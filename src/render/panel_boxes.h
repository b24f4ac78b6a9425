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

/// The rectangle of a panel, from the top left of the picture [pixel].
struct PanelBox {
    float left, top, right, bottom;
};

/// Whether two panels touch, or are less than a gap apart.
inline bool overlap(const PanelBox& a, const PanelBox& b, float gap = 0) {
    return a.left < b.right + gap && b.left < a.right + gap && a.top < b.bottom + gap && b.top < a.bottom + gap;
}

/// A window of Dear ImGui that has widgets, as it was last drawn [pixel].
struct PanelWindow {
    float left = 0, top = 0, width = 0, height = 0;

    [[nodiscard]] bool shown() const { return width > 0; }
    [[nodiscard]] PanelBox box() const { return {left, top, left + width, top + height}; }
    [[nodiscard]] bool covers(float x, float y) const {
        return x >= left && x < left + width && y >= top && y < top + height;
    }

    /// Begins it on a panel's ground; `end` follows.
    /// @param flags `ImGuiWindowFlags`
    /// @return whether anything is to be made in it
    [[nodiscard]] bool begin(const char* name, int flags, float padding) const;
    static void end();
};

/// Where panels are that find room for themselves: the others of this frame are in the way.
/// @param size_within how large the panel is if it may be this wide [pixel]
/// @param least_width less of it would not be readable [pixel]
/// @param at_top in the middle of the top, else of the bottom
/// @return where it touches none of the others and is within the page; nothing if it is nowhere
/// @par Cost O(boxes^2)
std::optional<PanelBox> free_place(const OverlayPage& page, const std::vector<PanelBox>& others,
                                   const std::function<ImVec2(float)>& size_within, float least_width, bool at_top);

}  // namespace drape
