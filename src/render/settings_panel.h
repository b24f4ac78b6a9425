#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "drape/sim/setting_table.h"
#include "figures_panel.h"

namespace drape {

/// The numbers that a slider leads over, which are fewer than the setting accepts.
struct SliderScale {
    double low, high;
    bool logarithmic;
};

/// The whole range, evenly, where that is from 0 to not much more than the scene's value, else two decades to both
/// sides of it.
/// @param scene_value of the setting in the scene as it was loaded
SliderScale slider_scale(const Setting& setting, double scene_value);

/// Whether the panel has a row for a setting: texts, paths, where the view starts and what a scene needs have none.
bool has_panel_row(const Setting& setting);

/// The panel of every setting at the right, made from the table of settings, with Dear ImGui's widgets: a slider, a box
/// or a list each, the help under the pointer, and a button back to the scene's value. Of several cloths, balls, solids
/// or pins it has the first. It changes nothing by itself.
class SettingsPanel {
public:
    static constexpr float columns = 27;  ///< of the width, where there is room [font size]

    /// The values that the buttons lead back to.
    void set_scene(const Settings& settings) {
        scene_ = settings;
        rows_.clear();
        held_setting_ = nullptr;
    }

    /// Where the panel of a frame is.
    PanelBox place(const OverlayPage& page);

    /// Makes it there.
    void draw(const Settings& settings, const OverlayPage& page);

    /// What the user has changed since the last call, as "solver.dt=0.001".
    [[nodiscard]] std::vector<std::string> take_changes() { return std::exchange(changes_, {}); }

    /// Whether a point of the picture lies on the panel as it was last drawn [pixel].
    [[nodiscard]] bool covers(float x, float y) const;

    /// Its left edge as it was last drawn; 0 where it is not shown [pixel].
    [[nodiscard]] float left() const { return width_ > 0 ? left_ : 0; }

    /// Whether a list of names was open as it was last drawn, and closes it as it is drawn next.
    [[nodiscard]] bool list_open() const { return list_open_; }
    void close_list() { closing_list_ = true; }

    /// The panel is not shown.
    void hide() {
        width_ = 0;
        list_open_ = closing_list_ = false;
        held_setting_ = nullptr;
    }

    /// How many times the texts of the rows were made: once, and once for each change of a setting or of the scene.
    [[nodiscard]] int times_made() const { return times_made_; }

private:
    /// What a row shows of its setting.
    struct Row {
        const Setting* setting;
        std::string name;     ///< of what it changes
        std::string heading;  ///< of a section that begins; else empty
        std::string label, format;
        SettingValue value;
        std::optional<SettingValue> of_the_scene;
        SliderScale scale;  ///< of a number
    };

    [[nodiscard]] bool is_up_to_date(const Settings& settings) const;
    void make_rows(const Settings& settings);
    void show(const Row& row);
    std::optional<SettingValue> edited(const Row& row);
    std::optional<SettingValue> edited_choice(const Setting& setting, const SettingValue& value);
    std::optional<SettingValue> edited_number(const Row& row);
    std::optional<SettingValue> edited_list(const Row& row);

    Settings scene_;
    std::vector<std::string> changes_;
    std::vector<Row> rows_;  ///< of `shown_`
    Settings shown_;
    int times_made_ = 0;
    const Setting* held_setting_ = nullptr;  ///< that is being changed, and waits for the button to go up
    std::vector<double> held_values_;
    std::vector<double> drawn_values_;
    bool list_open_ = false, closing_list_ = false;
    float left_ = 0, top_ = 0, width_ = 0, height_ = 0;
};

}  // namespace drape
