// The settings panel, under the pointer.

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <span>

#include "app/window_fixture.h"
#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"

namespace drape {
namespace {

using test::WindowTest;
using testing::ElementsAre;

// Where the panel has the label of its first row, once it is drawn.
bool has_label(const Image& picture) {
    for (int pixel = 0; pixel < 115 * 14; ++pixel) {
        if (*picture.pixel(485 + pixel % 115, 60 + pixel / 115) > 200) return true;
    }
    return false;
}

// The window is 640 x 480 pixels, and the panel has its right half; without its mark, a setting's section is closed.
TEST_F(WindowTest, TheDrawnMenuCarriesOutAnEntryAndShowsASettingWhereItIsChanged) {
    start({"hang"});
    const auto choose = [this](const char* query, const std::vector<std::string>& keys) {
        desktop_.key("slash");
        desktop_.act({"type", query});
        for (const std::string& key : keys) desktop_.key(key);
    };
    choose("winx", {"BackSpace", "d", "Return"});
    ASSERT_TRUE(recorded("next wind.on"));
    choose("table", {"Escape", "c"});
    ASSERT_TRUE(recorded("next view.contacts")) << "the menu stays";
    choose("kdop", {"Down", "Return"});
    ASSERT_TRUE(recorded("set contact.volume=kdop14"));
    choose("shear", {"Return"});
    ASSERT_TRUE(recorded("set view.controls=true"));
    desktop_.move_to(400, 187);
    desktop_.act({"mousedown", "1"});
    int x = 400;
    const bool slid = test::eventually([&] {
        desktop_.move_to(x = x < 460 ? x + 4 : 360, 187);
        return recorded_now("set cloth.shear.stiffness=");
    });
    desktop_.act({"mouseup", "1"});
    ASSERT_TRUE(slid);
    EXPECT_TRUE(commands()[4].starts_with("set cloth.shear.")) << "letters are no keys, and the cloth is not grabbed";
    desktop_.key("ctrl+z");
    const std::string before = assignments_of(load_scene("hang"), "cloth.shear.stiffness").front();
    EXPECT_TRUE(recorded("set " + before)) << "a drag is one change, however many commands it gave";
    quit();
}

TEST_F(WindowTest, TheDrawnMenuReplaysTheRunAndTheRecordingsOfItsFolder) {
    std::ofstream(file("first.txt"))
        << "drape-recording 1\nscene drop\nset contact.friction=0.7\n0 next wind.on\n9 end\n";
    std::ofstream(file("second.txt")) << "drape-recording 1\nscene nowhere\n0 end\n";
    start({"hang", "--set", "view.speed=0.1"});
    const auto choose = [this](const char* query) {
        desktop_.key("slash");
        desktop_.act({"type", query});
        desktop_.key("Return");
    };
    ASSERT_TRUE(test::eventually([this] { return last_step() > 0; })) << "a hash tells of steps before the wind";
    desktop_.key("v");
    ASSERT_TRUE(recorded("next wind.on"));
    choose("replay this");
    desktop_.key("t");
    ASSERT_TRUE(recorded("next contact.volume"));
    EXPECT_THAT(commands(), ElementsAre("next contact.volume")) << "taken over before the wind came again";

    choose("second.txt");
    desktop_.key("c");
    ASSERT_TRUE(recorded("next view.contacts"));
    EXPECT_EQ(commands().size(), 2u) << "a bad file changes nothing";
    choose("first.txt");
    ASSERT_TRUE(recorded("next wind.on"));
    const std::vector<std::string> all = commands();
    EXPECT_THAT(std::vector(all.begin() + 2, all.end()),
                ElementsAre("scene drop", "set contact.friction=0.7", "reset", "next wind.on"));
    quit();
}

TEST_F(WindowTest, ARecordingIsSavedAndReplayedFromTheMenu) {
    start({"hang"});
    desktop_.key("3");
    ASSERT_TRUE(recorded("scene " + scene_names()[2]));
    desktop_.key("v");
    ASSERT_TRUE(recorded("next wind.on"));
    desktop_.key("ctrl+s");
    ASSERT_TRUE(test::eventually([this] { return std::filesystem::exists(file("drape-0001.txt")); }));
    const std::size_t before = commands().size();
    desktop_.key("slash");
    desktop_.act({"type", "drape-0001"});
    desktop_.key("Return");
    EXPECT_TRUE(recorded("next wind.on", before));
    quit();
}

// The section Compare is closed at first; open, it has its button where the label of a row was before.
TEST_F(WindowTest, TheSettingsPanelComparesTheRunWithTheValueThatIsChosen) {
    start({"hang", "--set", "view.controls=true"});
    const auto label_shown = [this] { return has_label(desktop_.picture_of(window_)); };
    ASSERT_TRUE(test::eventually(label_shown));
    desktop_.move_to(400, 22);
    desktop_.click(1);
    ASSERT_TRUE(test::eventually([&] { return !label_shown(); }));
    desktop_.move_to(400, 67);
    desktop_.click(1);
    EXPECT_TRUE(recorded("compare solver.integrator=velocity_verlet")) << "the one after symplectic_euler";
    const long long begun = last_step();
    EXPECT_TRUE(test::eventually([&] { return last_step() > begun; })) << "no hash of a later step";

    const std::size_t before = commands().size();
    desktop_.move_to(500, 240);
    desktop_.click(5);
    const long long scrolled = last_step();
    EXPECT_TRUE(test::eventually([&] { return last_step() > scrolled; })) << "no hash of a later step";
    EXPECT_EQ(commands().size(), before) << "over the panel the wheel scrolls it";
    // A turn of the wheel is lost where the panel still has the pointer
    ASSERT_TRUE(test::eventually([&] {
        desktop_.move_to(100, 300);
        desktop_.click(4);
        return test::eventually([&] { return recorded_now("zoom ", before); }, 5);
    }));
    const std::vector<std::string> zooms = commands();
    for (std::size_t k = before; k < zooms.size(); ++k) {
        EXPECT_EQ(zooms[k], zooms.back()) << "of the turns beside the panel, none of that over it";
    }
    quit();
}

TEST_F(WindowTest, ABackspaceThatIsHeldRepeatsInAField) {
    start({"hang", "--set", "view.controls=true"});
    desktop_.move_to(400, 157);
    desktop_.act({"keydown", "ctrl", "click", "1", "keyup", "ctrl"});
    // A letter that no number has is a command as long as no field has the keyboard; the wheel always is one
    const bool field_open = test::eventually([&] {
        const std::size_t before = commands().size();
        desktop_.key("v");
        desktop_.move_to(20, 300);
        desktop_.click(4);
        // The wheel too is lost where the panel still has the pointer
        const bool zoomed = test::eventually([&] { return recorded_now("zoom ", before); }, 5);
        return zoomed && !recorded_now("next wind.on", before);
    });
    ASSERT_TRUE(field_open);
    for (int digit = 0; digit < 8; ++digit) desktop_.key("4");
    desktop_.hold("BackSpace", window_, 12);
    for (const char* key : {"3", "e", "minus", "4", "Return"}) desktop_.key(key);
    EXPECT_TRUE(recorded("set solver.dt=3e-04"));
    // The field may have the keyboard for another frame
    desktop_.ask_to_close(window_);
    EXPECT_EQ(drape_->wait(60), 0) << drape_->standard_error();
}

// The bar of time lies along the lower edge, with a white knob where the run stands.
TEST_F(WindowTest, AScreenshotDoesNotEndADragOfTheTimeBar) {
    start({"hang"});
    ASSERT_TRUE(test::eventually([&] { return last_step() >= 500; })) << "no hash of a later step";
    desktop_.key("space");
    constexpr int bar = 464;
    const auto knob_comes_to = [&](int x) {
        return test::eventually([&] {
            const Image picture = desktop_.picture_of(window_);
            return std::ranges::all_of(std::span(picture.pixel(x, bar), 3), [](int colour) { return colour > 200; });
        });
    };
    ASSERT_TRUE(knob_comes_to(621)) << "at the end";
    desktop_.move_to(400, bar);
    desktop_.act({"mousedown", "1"});
    ASSERT_TRUE(knob_comes_to(400));
    desktop_.key("F12");
    ASSERT_TRUE(test::eventually([&] { return std::filesystem::exists(file("drape-0001.png")); }));
    desktop_.move_to(200, bar - 150);  // beside the bar, where no new drag of it would begin
    EXPECT_TRUE(knob_comes_to(200));
    desktop_.act({"mouseup", "1"});
    quit();
}

}  // namespace
}  // namespace drape
