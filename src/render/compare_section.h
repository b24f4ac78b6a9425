#pragma once

#include <optional>
#include <string>

#include "drape/render/renderer.h"
#include "setting_editor.h"

namespace drape {

/// A value to begin a comparison with: the next name, the other of two, twice or half the numbers.
/// @param row with the value of the run
SettingValue another_value(const SettingRow& row);

/// The section of the settings panel that begins a comparison of the run with one in which a setting has another value,
/// and ends it. What runs beside the run already is shown, wherever that began.
class CompareSection {
public:
    /// @param editor of the panel
    CompareSection(SettingEditor& editor, PanelWishes& wishes) : editor_(editor), wishes_(wishes) {}

    /// Makes it in the present window of Dear ImGui.
    /// @param scene as it was loaded
    void draw(const FrameView& view, const Settings& scene, float widget_width);

    /// Another scene has begun.
    void forget() {
        row_.reset();
        compared_.clear();
        editor_.forget();
    }

private:
    void follow(const FrameView& view, const Settings& scene);
    void show(const std::string& assignment, const Settings& settings, const Settings& scene);
    void choose(const Setting& setting, const Settings& settings, const Settings& scene);
    void choice_of_setting(const Settings& settings, const Settings& scene);

    std::optional<SettingRow> row_;  ///< of the other simulation
    SettingValue of_the_run_;        ///< that runs, of the same setting
    std::string compared_;           ///< assignments of the comparison that was last seen
    SettingEditor& editor_;
    PanelWishes& wishes_;
};

}  // namespace drape
