// Every row of the settings panel does something: it changes the motion, or the picture.

#include "render/setting_editor.h"

#include <gtest/gtest.h>

#include <set>

#include "drawn_scene.h"

namespace drape::test {
namespace {

// What changes neither: how fast the same motion is computed, and how fast or how often it is shown. And which cloth
// pins are of, for no shipped scene of several cloths moves any.
const std::set<std::string> left_out{"pins.cloth",     "solver.sleep_speed", "solver.threads",
                                     "solver.kernels", "view.speed",         "view.repeat"};

// Scenes that have between them balls, solids, several cloths, wind, a penalty, and limits of the search
struct Trial {
    const char* scene;
    std::vector<const char*> changes;
    const char* command = nullptr;  // before the first step
};
const Trial trials[] = {
    {"drop", {"view.panel=full", "view.bounds=true", "view.level=0"}},
    {"drop", {}, "steer 1 0 0"},
    {"drop", {"solver.integrator=xpbd", "contact.search_level=3", "view.panel=full"}},
    {"drop", {"solver.integrator=backward_euler", "solver.dt=0.01", "contact.response=penalty"}},
    {"drop", {"solver.integrator=dormand_prince", "solver.dt=0.005", "solver.tolerance=1e-9"}},
    {"trampoline", {"ball.position=0.03,0.69,0.02", "ball.velocity=0.5,0,0"}},
    {"trampoline", {"ball.position=0,0.12,1.2", "ball.velocity=1,0,0", "ground.rolling=0.02"}},
    {"table", {"solid.angle=20"}},
    {"table", {"solid.shape=capsule"}},
    {"table", {"solid.path=0,0,0.4,0,1,0,0.6,0"}},
    {"bullet",
     {"ball.position=0.05,0.72,-31.2", "ball.velocity=0,2.55,60", "solver.dt=5e-4", "contact.continuous=false"}},
    {"flag", {}},
    {"fails_rk4", {}},
    {"fold", {}},
    {"twist", {}},
};

// Another value of a setting, as a user of the panel might choose
std::string other_value(const Setting& setting, const Settings& settings) {
    const SettingRow row = make_setting_row(setting, 0, settings, settings);
    const SettingValue value = row.value, other = another_value(row);
    if (other != value) return value_text(other);
    if (const double* number = std::get_if<double>(&value)) {
        const SliderScale& scale = row.scale;
        double moved = *number == 0 ? (scale.low + scale.high) / 3 : 1.7 * *number;
        if (setting.kind == SettingKind::Integer) moved = std::round(*number > 5 ? *number - 4 : *number + 2);
        return value_text(std::clamp(moved, scale.low, scale.high));
    }
    auto list = std::get<std::vector<double>>(value);
    if (setting.kind == SettingKind::Pins) return setting.choices.front();
    for (double& number : list) {
        number = setting.kind == SettingKind::Grid ? number + 1 : 1.2 * number + 0.05;
        number = std::clamp(number, setting.range.low, setting.range.high);
    }
    return value_text(list);
}

class SettingsPanelRows : public testing::Test {
protected:
    std::vector<std::uint8_t> picture_of(Simulation& simulation) {
        Renderer renderer;  // a new one, whose figures of the frame before are all zero
        renderer.resize(480, 640);
        renderer.panels().help = {{"H", "Help"}};
        FrameView view = simulation.view();
        StepReport report = *view.report;
        report.times = {};  // of the clock, which is never the same
        view.report = &report;
        const Camera camera(view.settings->view);
        renderer.draw(view, camera, {});
        return renderer.read_back().rgb;
    }

    // Whether a change shows in a scene after some steps, by which cloth, balls and solids have met
    bool shows(const Trial& trial, const Setting& setting) {
        Settings settings = load_scene(trial.scene);
        settings.view.panel = PanelSize::Off;
        if (settings.cloths[0].pinned.kind != Pins::Kind::List) assign(settings, "cloth.particles=16,16");
        for (const char* change : trial.changes) assign(settings, change);
        if (section_count(settings, setting) == 0) return false;
        const std::string name =
            section_count(settings, setting) > 1 ? setting.section + "[0]." + setting.name : setting.full_name();
        const std::string change = name + "=" + other_value(setting, settings);
        Simulation as_it_is(trial.scene, settings), changed(trial.scene, settings);
        if (trial.command != nullptr) {
            for (Simulation* one : {&as_it_is, &changed}) one->apply(parse_command(trial.command));
        }
        const auto steps = static_cast<int>(0.5 / settings.solver.dt);
        for (int step = 0; step < steps; ++step) as_it_is.step(), changed.step();
        try {
            changed.apply(command::Set{change});
        } catch (const InputError&) {
            return false;  // it does not fit this scene
        }
        for (int step = 0; step < steps / 6; ++step) as_it_is.step(), changed.step();
        const bool moves_otherwise = as_it_is.hash() != changed.hash();
        // What touches a solid that changes in any way is searched again
        const bool stays = setting.section == "solid" || !moves_otherwise;
        EXPECT_TRUE(stays || why_without_effect(setting, as_it_is.settings(), 0).empty()) << change;
        return moves_otherwise || picture_of(as_it_is) != picture_of(changed);
    }

    GlContext context_ = make_context();
};

TEST_F(SettingsPanelRows, AreNotAliveByThePictureAlone) {
    Settings settings = load_scene("drop");
    settings.view.panel = PanelSize::Full;
    Simulation one("drop", settings), other("drop", settings);
    EXPECT_EQ(picture_of(one), picture_of(other));
}

using NightlySettingsPanelRows = SettingsPanelRows;

TEST_F(NightlySettingsPanelRows, EachChangesMotionOrPicture) {
    int rows = 0;
    for (const Setting& setting : setting_table()) {
        if (!has_panel_row(setting) || left_out.contains(setting.full_name())) continue;
        ++rows;
        const bool alive = std::ranges::any_of(trials, [&](const Trial& trial) { return shows(trial, setting); });
        EXPECT_TRUE(alive) << setting.full_name();
    }
    EXPECT_GT(rows, 50);
}

TEST(SliderScale, LeadsToTenTimesAboutTheScenesValueOrAsFarAsCoefficientsDo) {
    const SliderScale stiffness = slider_scale(find_setting("cloth.structural.stiffness"), 1000);
    EXPECT_TRUE(stiffness.logarithmic);
    EXPECT_EQ(stiffness.high, 1e4);
    const SliderScale step = slider_scale(find_setting("solver.dt"), 1e-3);
    EXPECT_EQ(step.low, 1e-4);
    EXPECT_EQ(step.high, 0.01);
    EXPECT_EQ(slider_scale(find_setting("contact.restitution"), 0).high, 1);
    const Setting& friction = find_setting("contact.friction");
    const SliderScale scale = slider_scale(friction, 0.5);
    EXPECT_FALSE(scale.logarithmic);
    EXPECT_EQ(scale.low, 0);
    EXPECT_EQ(scale.high, 2);
    EXPECT_EQ(slider_scale(friction, 3).high, 3) << "the scene's own";
    EXPECT_EQ(friction.range.high, 10) << "what can be typed";
}

}  // namespace
}  // namespace drape::test
