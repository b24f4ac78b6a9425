// The mouse over the picture.

#include "app/window_fixture.h"
#include "drape/session/start.h"

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

TEST_F(WindowTest, TheMouseLeadsTheBallAndTheRecordingHasIt) {
    start({"trampoline", "--set", "ball.motion=keys"});
    desktop_.move_to(324, 64);
    desktop_.act({"mousedown", "1"});
    desktop_.move_to(424, 64);
    ASSERT_TRUE(recorded("drag "));
    EXPECT_TRUE(recorded_now("hold 0"));
    const long long dragged = last_step();
    ASSERT_TRUE(test::eventually([&] { return last_step() > dragged + 1000; })) << "it follows";
    desktop_.act({"mouseup", "1"});
    ASSERT_TRUE(recorded("release"));
    EXPECT_FALSE(recorded_now("orbit "));
    quit();
    Session replay = make_session(make_start({.replay = file("session.txt")}));
    EXPECT_TRUE(replay.run_replay());
    EXPECT_FALSE(replay.replay_differs()) << replay.replay_notice();
    EXPECT_GT((replay.simulation().balls()[0].centre - Vec3(0.03, 1.12, 0.02)).norm(), 0.1) << "m";
}

}  // namespace
}  // namespace drape
