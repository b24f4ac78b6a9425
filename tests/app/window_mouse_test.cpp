// The mouse over the picture.

#include "app/window_fixture.h"

namespace drape {
namespace {

using test::WindowTest;

TEST_F(WindowTest, DraggingTheBackgroundTurnsTheView) {
    start({"hang"});
    desktop_.drag({}, 1, {620, 460}, {560, 440});
    EXPECT_TRUE(recorded("orbit "));
    EXPECT_FALSE(recorded_now("grab "));
    quit();
}

TEST_F(WindowTest, DraggingTheClothPullsItUntilTheButtonGoesUp) {
    start({"curtain"});
    desktop_.drag({}, 1, {320, 200}, {380, 210});
    ASSERT_TRUE(recorded("grab "));
    EXPECT_TRUE(recorded("drag "));
    EXPECT_TRUE(recorded("release"));
    quit();
}

TEST_F(WindowTest, ShiftOrTheMiddleButtonMovesTheView) {
    start({"hang"});
    desktop_.drag({}, 2, {320, 240}, {350, 220});
    EXPECT_TRUE(recorded("pan "));
    const std::size_t before = commands().size();
    desktop_.drag({"shift"}, 1, {320, 240}, {350, 220});
    EXPECT_TRUE(recorded("pan ", before));
    EXPECT_FALSE(recorded_now("grab "));
    quit();
}

TEST_F(WindowTest, TheWheelZooms) {
    start({"hang"});
    desktop_.click(4);
    EXPECT_TRUE(recorded("zoom 0.9"));
    desktop_.click(5);
    EXPECT_TRUE(recorded("zoom 1.1", 1));
    quit();
}

}  // namespace
}  // namespace drape
