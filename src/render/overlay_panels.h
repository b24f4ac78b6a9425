#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cloth_colours.h"
#include "drape/render/renderer.h"
#include "figures_panel.h"
#include "hierarchy_panel.h"

struct ImFont;
struct ImGuiContext;

namespace drape {

/// The panels over the picture, made with Dear ImGui: figures at the top left, help at the right, notices at the
/// bottom. Dear ImGui's context lives as long as this does.
class OverlayPanels {
public:
    OverlayPanels();

    /// Makes the panels of a frame as Dear ImGui's draw data.
    /// @param last what the frame before this one cost
    /// @return false if there is nothing to show, or no room
    bool build(const FrameView& view, const FrameReport& last, std::span<const std::string> notices, int width,
               int height);

    std::vector<KeyHelp> help;
    ColourScale colours;  ///< of the cloth in this frame

private:
    struct DestroyContext {
        void operator()(ImGuiContext* context) const;
    };

    void legends(const FrameView& view, float taken, OverlayPage page);
    void help_panel(const OverlayPage& page, float taken) const;
    void notice_panel(std::span<const std::string> notices, const OverlayPage& page) const;

    HierarchyPanel hierarchy_;
    std::unique_ptr<ImGuiContext, DestroyContext> context_;
    std::array<ImFont*, 4> fonts_{};  ///< from small to large
};

}  // namespace drape
