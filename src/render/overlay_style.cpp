#include "overlay_style.h"

namespace drape {

bool begin_window(const PanelBox& box, const char* name, int flags, float padding) {
    add_panel(box);
    ImGui::SetNextWindowPos({box.left, box.top});
    ImGui::SetNextWindowSize({box.width(), box.bottom - box.top});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {padding, padding});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ink::panel);
    return ImGui::Begin(name, nullptr,
                        flags | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
}

void end_window() {
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
}

std::optional<PanelBox> free_place(const OverlayPage& page, const std::vector<PanelBox>& others,
                                   const std::function<ImVec2(float)>& size_within, float min_width, bool at_top) {
    const float gap = page.margin / 2;
    float left = page.margin, right = page.width - page.margin, top = page.margin, bottom = page.height - page.margin;
    // Each turn leaves at least one of the others behind
    for (std::size_t turn = 0; turn <= others.size(); ++turn) {
        if (right - left < min_width) return std::nullopt;
        const ImVec2 size = size_within(right - left);
        if (size.y > bottom - top || size.x > right - left) return std::nullopt;
        const float middle = (left + right) / 2, edge = at_top ? top : bottom - size.y;
        const PanelBox box{middle - size.x / 2, edge, middle + size.x / 2, edge + size.y};
        const auto in_the_way =
            std::ranges::find_if(others, [&](const PanelBox& other) { return overlap(box, other, gap); });
        if (in_the_way == others.end()) return box;
        const float before = in_the_way->left - page.margin, after = in_the_way->right + page.margin;
        if (right - after >= std::max(min_width, before - left)) {
            left = after;
        } else if (before - left >= min_width) {
            right = before;
        } else if (at_top) {
            top = in_the_way->bottom + page.margin;
        } else {
            bottom = in_the_way->top - page.margin;
        }
    }
    return std::nullopt;
}

}  // namespace drape
