// The settings panel, under the pointer.

#include "app/window_fixture.h"

namespace drape {
namespace {

using test::WindowTest;

// The window is 640 x 480 pixels, and the panel has its right half: there the solver's and the contact's rows are open.
TEST_F(WindowTest, TheSettingsPanelMakesCommandsOfWhatItIsTold) {
    start({"hang", "--set", "view.controls=true"});
    const std::size_t before = commands().size();
    // Along the middle of the left part, from row to row: some of them are sliders
    for (int y = 60; y < 440; y += 13) desktop_.drag({}, 1, {380, y}, {440, y});
    EXPECT_TRUE(recorded("set ", before));
    EXPECT_FALSE(recorded_now("grab "));
    EXPECT_FALSE(recorded_now("orbit "));
    quit();
}

TEST_F(WindowTest, TheWheelOverTheSettingsPanelScrollsItAndBesideItZooms) {
    start({"hang", "--set", "view.controls=true"});
    desktop_.move_to(500, 240);
    desktop_.click(5);
    desktop_.move_to(100, 300);
    desktop_.click(4);
    ASSERT_TRUE(recorded("zoom "));
    EXPECT_EQ(commands().size(), 1u);
    quit();
}

}  // namespace
}  // namespace drape
