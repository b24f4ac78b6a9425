#include <gtest/gtest.h>

#include "render/overlay_panels.h"

namespace drape {
namespace {

TEST(SettingsRows, AreMadeWhenASettingChangesAndNotInEveryFrame) {
    ClothParameters parameters;
    const ClothModel model = make_cloth_model(parameters);
    const Points x = make_rest_state(parameters).x;
    const auto tree = make_broad_phase({}, model.grid);
    const std::vector<ClothView> cloths{{model, x, x, {}, tree.get()}};
    Settings settings;
    settings.view.controls = true;
    StepReport report;
    FrameView view;
    view.cloths = cloths;
    view.settings = &settings;
    view.report = &report;

    OverlayPanels panels;
    panels.settings.set_scene(settings);
    const auto times_made = [&] {
        for (int frame = 0; frame < 3; ++frame) {
            ++report.step;
            report.time += 0.01;
            EXPECT_TRUE(panels.build(view, Camera(settings.view), {}, {}, 1280, 720));
        }
        return panels.settings.times_made();
    };
    EXPECT_EQ(times_made(), 1);
    int expected = 1;
    for (const Setting& setting : setting_table()) {
        if (!has_panel_row(setting) || section_count(settings, setting) == 0) continue;
        if (setting.full_name() == "view.controls") continue;
        const SettingValue value = setting.read(settings, 0);
        if (const bool* flag = std::get_if<bool>(&value)) {
            setting.write(settings, 0, !*flag);
        } else if (const double* number = std::get_if<double>(&value)) {
            setting.write(settings, 0, *number < setting.range.high ? *number + 1 : *number - 1);
        } else if (const auto* name = std::get_if<std::string>(&value)) {
            setting.write(settings, 0, *name == setting.choices.front() ? setting.choices[1] : setting.choices[0]);
        } else {
            continue;
        }
        if (setting.read(settings, 0) == value) continue;
        EXPECT_EQ(times_made(), ++expected) << setting.full_name();
        setting.write(settings, 0, value);
        EXPECT_EQ(times_made(), ++expected) << setting.full_name() << ", back again";
    }
    EXPECT_GT(expected, 60);
    panels.settings.set_scene(settings);
    EXPECT_EQ(times_made(), expected + 1);
}

}  // namespace
}  // namespace drape
