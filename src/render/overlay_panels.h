#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cloth_colours.h"
#include "drape/render/renderer.h"
#include "menu_panel.h"
#include "overlay_style.h"
#include "panels.h"
#include "plot_history.h"
#include "settings_panel.h"
#include "step_medians.h"

struct ImGuiContext;

namespace drape {

/// The panels over the picture, made with Dear ImGui: figures at the top left, help at the right, legends at the lower
/// right, a hint for the first moments at the bottom, and notices at the top between the others. Dear ImGui's context
/// lives as long as this does.
class OverlayPanels final : public Panels {
public:
    OverlayPanels();

    /// Makes the panels of a frame as Dear ImGui's draw data.
    /// @param last what the frame before this one cost
    /// @return false if there is nothing to show, or no room
    bool build(FrameView view, const Camera& camera, const FrameReport& last, std::span<const std::string> notices,
               int width, int height);

    /// Where the panels of the last frame are.
    [[nodiscard]] const std::vector<PanelBox>& boxes() const { return boxes_; }

    void set_scene(const Settings& of_the_scene) override { settings.set_scene(of_the_scene); }
    void open_menu(std::span<const Entry> entries, const Settings& present) override { menu.open(entries, present); }
    [[nodiscard]] bool menu_open() const override { return menu.is_open(); }
    void point(const PanelPointer& pointer) override;
    void type(unsigned char code) override {
        menu.is_open() ? menu.type(code) : input_.typed.push_back(static_cast<char>(code));
    }
    [[nodiscard]] bool have_pointer() const override;
    [[nodiscard]] bool have_keyboard() const override;
    [[nodiscard]] bool close_list() override { return settings.close_list(); }
    [[nodiscard]] bool shows_timeline() const override { return timeline_.width() > 0; }

    SettingsPanel settings{wishes};
    MenuPanel menu{settings, wishes};
    ColourScale colours;     ///< of the cloth in this frame
    double full_strain = 0;  ///< as in `StrainCrosses`

private:
    void legends(const FrameView& view, float taken, OverlayPage page);
    void hand_over_input();
    void forget_input();

    /// What has come and was not seen yet: each frame sees one press or release, where it was.
    struct Input {
        PanelPointer seen;
        std::vector<PanelPointer> next;
        std::string typed;
        bool key_seen = false;  ///< in the last frame, that makes no character
    };

    StepMedians step_medians_;
    LevelFits fits_;
    PlotHistory plots_;
    ComparisonPanel comparison_;
    PanelBox timeline_;
    std::vector<PanelBox> boxes_;
    std::shared_ptr<ImGuiContext> context_;
    Input input_;
    std::array<PanelFont, 8> fonts_{};  ///< from small to large
    double style_scale_ = 1;            ///< for which Dear ImGui's widgets have their sizes
};

}  // namespace drape
