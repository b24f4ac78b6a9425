#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "drape/render/renderer.h"
#include "drape/scene/setting_table.h"
#include "overlay_style.h"
#include "setting_editor.h"

namespace drape {

/// The panel of every setting at the right, made from the table of settings, with Dear ImGui's widgets: a slider, a box
/// or a list each, the help under the pointer, and a button back to the scene's value. A row without effect is dim, and
/// its help says why. Of several cloths, balls, solids or pins it has one at a time, with buttons to the others. Where
/// the method is another one than the scene's, it offers a time step that suits it. Its first section begins a
/// comparison of the run with one in which a setting has another value, and ends it. It changes nothing by itself.
class SettingsPanel {
public:
    static constexpr float columns = 27;  ///< of the width, where there is room [font size]

    explicit SettingsPanel(PanelWishes& wishes) : wishes_(wishes) {}

    /// The values that the buttons lead back to.
    void set_scene(const Settings& settings) {
        scene_ = settings;
        numbers_.clear();
        seeks_ = false, marked_ = nullptr;
        editor_.forget();
        other_.reset();
    }

    /// Makes a frame's panel.
    void draw(const FrameView& view, const OverlayPage& page);

    /// Shows one of several cloths, balls, solids or pins from now on, as the buttons do.
    void show(const std::string& section, std::size_t number);

    /// Shows the row of a setting, marked until another scene comes, and asks for itself where it is not shown.
    void show(const Setting& setting) {
        seeks_ = true, marked_ = &setting;
        if (window.width() == 0) wishes_.changes.emplace_back("view.controls=true");
    }

    /// As the editor's.
    bool close_list() { return editor_.close_list(); }

    /// The panel is not shown.
    void hide() {
        window = {};
        editor_.hide();
    }

    PanelBox window;  ///< as it was last drawn

private:
    [[nodiscard]] float widget_width() const { return 0.48f * window.width(); }
    [[nodiscard]] bool heading(const std::string& section, std::size_t count);
    void draw_row(const SettingRow& row);
    void offer_step(const FrameView& view);
    void compare_section(const FrameView& view);
    void choose_other(const Setting& setting, const Settings& settings);

    Settings scene_;
    PanelWishes& wishes_;
    std::map<std::string, std::size_t> numbers_;  ///< of those that are shown, by section
    const Setting* marked_ = nullptr;
    bool seeks_ = false;               ///< it was not drawn yet
    std::optional<SettingRow> other_;  ///< of the other simulation
    SettingEditor editor_;
};

}  // namespace drape
