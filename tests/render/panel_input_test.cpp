// What a user does to the settings panel, without a window: slides, types, chooses, changes their mind.

#include <gmock/gmock.h>

#include <set>

#include "drape/scene/scene.h"
#include "drape/sim/simulation.h"
#include "render/overlay_panels.h"

namespace drape {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr int page_width = 1280, page_height = 1400;
constexpr int first_row = 24, row_height = 18;  // of the panel
constexpr unsigned char backspace = 8, enter = 13, escape = 27;

Settings shown_settings(const std::string& scene) {
    Settings settings = load_scene(scene);
    settings.view.panel = PanelSize::Off;
    settings.view.controls = true;
    return settings;
}

class PanelInput : public testing::Test {
protected:
    explicit PanelInput(const std::string& scene = "drop") : simulation_(scene, shown_settings(scene)) {
        panels_.settings.set_scene(simulation_.settings());
        frames();
        left_ = static_cast<int>(panels_.settings.window.left);
    }

    void frames(int count = 6) {
        for (int f = 0; f < count; ++f) {
            const Camera camera(simulation_.settings().view);
            panels_.build(simulation_.view(), camera, {}, {}, page_width, page_height);
        }
    }

    void point(int x, int y, bool down, bool control = false) {
        panels_.point({.x = x, .y = y, .down = down, .control = control});
        frames(4);
    }

    void click(int x, int y, bool control = false) {
        point(x, y, false);
        point(x, y, true, control);
        point(x, y, false);
    }

    void type(const std::string& text) {
        for (const char c : text) panels_.type(static_cast<unsigned char>(c));
        frames(4 + 2 * static_cast<int>(text.size()));
    }

    void type(unsigned char key) { type(std::string(1, static_cast<char>(key))); }

    /// Types a number into what is there, and closes a list that opens in its place.
    void type_at(int y, const std::string& number) {
        click(widget(), y, true);
        close_list();
        type(number);
        type(enter);
    }

    /// @return whether one was open
    bool close_list() {
        const bool is_open = panels_.close_list();
        frames();
        return is_open;
    }

    std::vector<std::string> changes() { return std::exchange(panels_.wishes.changes, {}); }

    /// What the window does with them.
    void carry_out_changes() {
        for (const std::string& change : changes()) simulation_.apply(command::Set{change});
        frames();
    }

    /// The height at which a number that is typed is one of the solver's settings: below the headers of comparison,
    /// cloth and ball, which are closed, and solver.
    int row_of(const std::string& name) {
        for (int y = first_row + 4 * row_height; y < page_height / 2; y += 6) {
            type_at(y, "7");
            for (const std::string& change : changes()) {
                if (change.starts_with(name + "=")) return y + row_height / 3;
            }
        }
        ADD_FAILURE() << "no row takes a number for " << name;
        return 0;
    }

    /// Where sliders and lists are.
    [[nodiscard]] int widget() const { return left_ + 60; }

    OverlayPanels panels_;
    Simulation simulation_;
    int left_ = 0;
};

TEST_F(PanelInput, ATypedValueCountsOnceItIsWhole) {
    const int y = row_of("solver.dt");
    const auto open_field = [&] {
        click(widget(), y, true);
        EXPECT_TRUE(panels_.have_keyboard());
    };
    open_field();
    type("2e-4");
    EXPECT_THAT(changes(), IsEmpty()) << "half a number is none";
    type(enter);
    EXPECT_THAT(changes(), ElementsAre("solver.dt=2e-04"));
    EXPECT_FALSE(panels_.have_keyboard());
    open_field();
    // Each takes a character, also where they come together
    type("1e-4444" + std::string(3, static_cast<char>(backspace)) + static_cast<char>(enter));
    carry_out_changes();
    EXPECT_EQ(simulation_.settings().solver.dt, 1e-4) << "it replaces the first";
    open_field();
    type("2e-4");
    type(escape);
    EXPECT_THAT(changes(), IsEmpty());
    EXPECT_FALSE(panels_.have_keyboard());
}

TEST_F(PanelInput, TheButtonLeadsBackToTheScenesValue) {
    const int y = row_of("solver.dt");
    const double of_the_scene = simulation_.settings().solver.dt;
    simulation_.apply(parse_command("set solver.dt=1e-4"));
    frames();
    std::vector<std::string> given;
    for (int x = page_width - 20; x > page_width - 120 && given.empty(); x -= 5) {
        click(x, y);
        given = changes();
    }
    ASSERT_EQ(given.size(), 1u);
    simulation_.apply(command::Set{given.front()});
    EXPECT_EQ(simulation_.settings().solver.dt, of_the_scene);
    frames();
    for (int x = page_width - 20; x > page_width - 120; x -= 5) click(x, y);
    EXPECT_THAT(changes(), IsEmpty()) << "there is no button where nothing is changed";
}

TEST_F(PanelInput, AListThatIsDraggedOverCountsAsTheButtonGoesUp) {
    click(widget(), first_row + 3 * row_height / 2);  // the second header
    std::vector<std::string> given;
    for (int y = first_row + 2 * row_height; y < page_height / 2 && given.empty(); y += 6) {
        point(widget(), y, false);
        point(widget(), y, true);
        for (int x = 0; x < 60; x += 10) point(widget() + x, y, true);
        const std::vector<std::string> meanwhile = changes();
        point(widget() + 60, y, false);
        given = changes();
        const bool is_list = !given.empty() && given.front().starts_with("cloth.size=");
        if (!is_list) {
            given.clear();
            continue;
        }
        EXPECT_THAT(meanwhile, IsEmpty());
        EXPECT_EQ(given.size(), 1u);
    }
    EXPECT_FALSE(given.empty()) << "no list of numbers was found";
}

TEST_F(PanelInput, HiddenInMidDragItForgetsTheDrag) {
    const int y = row_of("solver.dt");
    point(widget(), y, true);
    point(widget() + 20, y, true);
    carry_out_changes();
    const double slid = simulation_.settings().solver.dt;
    simulation_.apply(parse_command("set view.controls=false"));
    frames();
    EXPECT_FALSE(panels_.have_pointer());
    point(widget() + 40, y, false);
    simulation_.apply(parse_command("set view.controls=true"));
    frames();
    point(widget() + 80, y, false);
    EXPECT_THAT(changes(), IsEmpty());
    EXPECT_EQ(simulation_.settings().solver.dt, slid);
    click(widget() + 90, y);
    EXPECT_FALSE(changes().empty()) << "it works again";
}

TEST_F(PanelInput, AListOfNamesIsClosedFromOutside) {
    std::vector<std::string> given;
    int y = 0;
    bool is_open = false;
    while (!(is_open = close_list()) && (y += 6) < page_height) {
        static_cast<void>(changes());
        click(widget(), y);
    }
    ASSERT_TRUE(is_open);
    EXPECT_FALSE(close_list());
    EXPECT_THAT(changes(), IsEmpty());
    click(widget(), y);
    EXPECT_TRUE(close_list()) << "it opens again";
}

TEST(CompareSection, BeginsWithAnotherNameThanTheRunsAndWithItsNumbers) {
    for (const std::string& scene : scene_names()) {
        const Settings settings = load_scene(scene);
        for (const Setting& setting : setting_table()) {
            if (!has_panel_row(setting) || section_count(settings, setting) == 0) continue;
            const SettingRow row = make_setting_row(setting, 0, settings, settings);
            const SettingValue other = another_value(row);
            const bool is_name =
                std::holds_alternative<bool>(row.value) || std::holds_alternative<std::string>(row.value);
            EXPECT_EQ(other != row.value, is_name) << scene << ": " << setting.full_name();
            EXPECT_EQ(refusal(setting, other), "") << scene;
        }
    }
}

TEST_F(PanelInput, AnotherMethodIsOfferedAStepThatSuitsIt) {
    const int below = row_of("solver.dt") + row_height;
    const auto offered = [&] {
        click(left_ + 40, below);
        close_list();
        std::vector<std::string> of_step = changes();
        std::erase_if(of_step, [](const std::string& change) { return !change.starts_with("solver.dt="); });
        return of_step;
    };
    EXPECT_THAT(offered(), IsEmpty()) << "the scene's own";
    simulation_.apply(command::Set{"solver.integrator=xpbd"});
    frames();
    EXPECT_THAT(offered(), ElementsAre("solver.dt=0.0167"));

    simulation_.apply(command::Set{"solver.integrator=explicit_euler"});
    frames();
    const auto step = offered();
    ASSERT_EQ(step.size(), 1u);
    simulation_.apply(command::Set{step[0]});
    frames();
    EXPECT_NEAR(simulation_.report().step_limit_ratio, 0.9, 0.01);
    EXPECT_LE(simulation_.report().step_limit_ratio, 0.9);
    EXPECT_THAT(offered(), IsEmpty()) << "it is taken";
}

struct PanelOfSeveral : PanelInput {
    PanelOfSeveral() : PanelInput("three_balls") {}
};

TEST_F(PanelOfSeveral, ShowsTheOneThatIsChosen) {
    ASSERT_EQ(simulation_.settings().balls.size(), 4u);
    const auto balls_typed_into = [this] {
        std::set<std::string> balls;
        for (int y = first_row; y < page_height; y += 6) {
            type_at(y, "7");
            for (const std::string& change : changes()) {
                if (change.starts_with("ball[")) balls.insert(change.substr(0, change.find('.')));
            }
        }
        return balls;
    };
    click(widget(), first_row + 5 * row_height / 2);  // the third header
    const int selector = first_row + 7 * row_height / 2;
    for (int x = left_ + 90; x < left_ + 160; x += 12) click(x, selector);
    EXPECT_THAT(balls_typed_into(), testing::AllOf(testing::SizeIs(1), testing::Not(testing::Contains("ball[0]"))))
        << "the button leads on";
    panels_.settings.show("ball", 2);
    EXPECT_THAT(balls_typed_into(), ElementsAre("ball[2]"));
    panels_.settings.set_scene(simulation_.settings());
    EXPECT_THAT(balls_typed_into(), ElementsAre("ball[0]"));
}

}  // namespace
}  // namespace drape
