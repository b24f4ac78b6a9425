#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drape/scene/setting_table.h"

namespace drape {

/// Whether the settings panel has a row for a setting: texts, paths, where the view starts and what a scene needs have
/// none.
bool has_panel_row(const Setting& setting);

/// The numbers that a slider leads over, which are fewer than the setting accepts.
struct SliderScale {
    double low, high;
    bool logarithmic;
};

/// What is of use, evenly, where the setting's row says that, or the whole range where that is from 0 to not much more
/// than the scene's value, else two decades to both sides of it.
/// @param scene_value of the setting in the scene as it was loaded
SliderScale slider_scale(const Setting& setting, double scene_value);

/// What a row of the settings panel shows of its setting.
struct SettingRow {
    const Setting* setting;
    std::string name;  ///< of what it changes: "solver.dt", "ball[1].radius"
    std::string format;
    SettingValue value;
    std::optional<SettingValue> of_the_scene;
    SliderScale scale;           ///< of a number
    std::string no_effect = {};  ///< why it changes nothing now; empty if it does
};

/// @param number of the cloth, ball, solid or pins; those of `settings` have it, those of `scene` may not
SettingRow make_setting_row(const Setting& setting, std::size_t number, const Settings& settings,
                            const Settings& scene);

/// A value to begin a comparison with: the next name, the other of two; a number stays the same.
/// @param row with the value of the run
SettingValue another_value(const SettingRow& row);

/// Dear ImGui's widgets that change a setting's value: a slider, a box or a list each. It knows which of its widgets is
/// being changed.
class SettingEditor {
public:
    /// Makes the widget of a row, as wide as the next item's width says.
    /// @return the value that the user has chosen in this frame
    std::optional<SettingValue> edit(const SettingRow& row);

    /// Says under the pointer what the last item's setting is and accepts, and why it has no effect.
    static void explain(const SettingRow& row);

    /// Begins a list of names, which `end_list` ends if it is open.
    bool begin_list(const char* label, const char* shown);
    void end_list();

    /// A frame has begun, and has ended.
    void begin_frame() { list_open_ = held_drawn_ = false; }
    void end_frame() {
        if (!held_drawn_) forget();  // its row is folded away
        if (closing_list_) list_open_ = closing_list_ = false;
    }

    /// Closes the list of names that is open, as it is drawn next. @return whether one is
    bool close_list() { return closing_list_ = list_open_; }

    /// Nothing is being changed any more.
    void forget() { held_widget_ = 0; }
    void hide() {
        list_open_ = closing_list_ = false;
        forget();
    }

private:
    std::optional<SettingValue> choice(const SettingRow& row);
    std::optional<SettingValue> number(const SettingRow& row);
    std::optional<SettingValue> list(const SettingRow& row);

    unsigned int held_widget_ = 0;  ///< of the value that is being changed, and waits for the button to go up; 0: none
    std::vector<double> held_values_;
    bool held_drawn_ = false;  ///< in this frame
    bool list_open_ = false, closing_list_ = false;
};

}  // namespace drape
