// Pins that the user sets and takes out in mid-run.

#include <gmock/gmock.h>

#include "sim/small_scene.h"
#include "support/input_errors.h"

namespace drape {
namespace {

Simulation pinned_simulation() { return small_simulation({"cloth.pinned=0,5", "ball.position=0,-50,0"}); }

TEST(PinCommand, HoldsAParticleWhereItIs) {
    Simulation simulation = pinned_simulation();
    make_steps(simulation, 200);
    const Vec3 before = position_of(simulation, 40);
    send(simulation, "pin 0 40");
    make_steps(simulation, 200);
    EXPECT_EQ(position_of(simulation, 40), before);
    EXPECT_THAT(simulation.settings().cloths[0].pinned.list, testing::ElementsAre(0, 5, 40));
}

TEST(PinCommand, FreesAPinnedParticle) {
    Simulation simulation = pinned_simulation();
    make_steps(simulation, 200);
    const std::uint64_t before = simulation.hash();
    send(simulation, "pin 0 5");
    EXPECT_EQ(simulation.hash(), before);
    const Vec3 held = position_of(simulation, 0), freed = position_of(simulation, 5);
    make_steps(simulation, 200);
    EXPECT_EQ(position_of(simulation, 0), held);
    EXPECT_LT(position_of(simulation, 5).y(), freed.y() - Real(0.01));
    send(simulation, "pin 0 0");
    EXPECT_EQ(simulation.settings().cloths[0].pinned, Pins{});
}

TEST(PinCommand, CountsForWhatTheHandHolds) {
    Simulation simulation = pinned_simulation();
    send(simulation, "grab 0 0");
    send(simulation, "set cloth.pinned=none");
    EXPECT_TRUE(simulation.settings().cloths[0].pinned.list.empty());
    send(simulation, "release");
    EXPECT_FALSE(simulation.cloths()[0].model.pinned(0));
    send(simulation, "grab 0 40");
    send(simulation, "pin 0 40");
    send(simulation, "release");
    EXPECT_TRUE(simulation.cloths()[0].model.pinned(40));
}

TEST(PinCommand, AndGrabNameWhatThereIsWhereThereIsNoSuchParticle) {
    Simulation simulation = pinned_simulation();
    for (const std::string word : {"pin", "grab"}) {
        EXPECT_THAT(test::input_error_of([&] { send(simulation, word + " 1 0"); }),
                    testing::AllOf(testing::HasSubstr(word + ": cloth 1"), testing::HasSubstr("0 to 0")));
        EXPECT_THAT(test::input_error_of([&] { send(simulation, word + " 0 80"); }),
                    testing::AllOf(testing::HasSubstr(word + ": particle 80"), testing::HasSubstr("0 to 79")));
    }
    EXPECT_THAT(simulation.settings().cloths[0].pinned.list, testing::ElementsAre(0, 5));
}

}  // namespace
}  // namespace drape
