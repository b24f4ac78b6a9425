#include "../../src/app/ball_watch.h"

#include <gtest/gtest.h>

#include "sim/small_scene.h"

namespace drape {
namespace {

// How often the thrown ball of a scene is lost in three seconds
int losses(const std::string& thrown, bool is_seen, bool paused = false) {
    Simulation simulation("small", small_settings());
    simulation.apply(parse_command(thrown));
    if (paused) simulation.apply(command::Pause{});
    BallWatch watch;
    int count = 0;
    for (int tick = 0; tick < 30; ++tick) count += watch.loses(simulation, is_seen, Vec3::Zero(), 0.1) ? 1 : 0;
    return count;
}

TEST(BallWatch, TellsOnceOfABallThatMovesAwayUnseen) {
    EXPECT_EQ(losses("throw 3 0 0 4 0 0", false), 1);
    EXPECT_EQ(losses("throw 3 0 0 4 0 0", true), 0);
    EXPECT_EQ(losses("throw 3 0 0 -4 0 0", false), 0) << "it comes back";
    EXPECT_EQ(losses("throw 3 0 0 4 0 0", false, true), 0) << "nothing moves";
}

}  // namespace
}  // namespace drape
