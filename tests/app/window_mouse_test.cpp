// The mouse over the picture.

#include "app/window_fixture.h"

namespace drape {
namespace {

using test::WindowTest;

TEST_F(WindowTest, TheMousePullsTheClothAndMovesTheView) {
    start({"curtain"});
    desktop_.drag({}, 1, {320, 200}, {380, 210});
    ASSERT_TRUE(recorded("grab "));
    EXPECT_TRUE(recorded("drag "));
    ASSERT_TRUE(recorded("release"));
    const std::size_t released = commands().size();
    desktop_.drag({}, 2, {320, 240}, {350, 220});
    EXPECT_TRUE(recorded("pan ", released)) << "by the middle button";
    const std::size_t before = commands().size();
    desktop_.drag({"shift"}, 1, {320, 240}, {350, 220});
    EXPECT_TRUE(recorded("pan ", before)) << "with Shift";
    desktop_.click(4);
    EXPECT_TRUE(recorded("zoom 0.9"));
    desktop_.click(5);
    EXPECT_TRUE(recorded("zoom 1.1"));
    desktop_.drag({}, 1, {620, 460}, {560, 440});
    EXPECT_TRUE(recorded("orbit ")) << "beside the cloth";
    EXPECT_FALSE(recorded_now("grab ", released));
    quit();
}

}  // namespace
}  // namespace drape
