#include "../../src/app/outcome.h"

#include <gmock/gmock.h>

#include "drape/scene/scene.h"

namespace drape {
namespace {

using testing::HasSubstr;

std::string after(Simulation& simulation, const char* text) {
    const Command command = parse_command(text);
    simulation.apply(command);
    return outcome_of(command, simulation);
}

TEST(Outcome, NamesWhatAKeyHasChosen) {
    Simulation simulation("drop", load_scene("drop"));
    EXPECT_EQ(after(simulation, "next contact.volume"), "bounding volume: aabb");
    EXPECT_EQ(after(simulation, "set solver.dt=1e-4"), "time step: 1e-04 s");
    EXPECT_EQ(after(simulation, "next wind.on"), "wind: on");
    EXPECT_EQ(after(simulation, "next view.wireframe"), "");
    EXPECT_EQ(after(simulation, "pause"), "");
}

TEST(Outcome, SaysWhyAKeyShowsNothing) {
    Simulation simulation("drop", load_scene("drop"));
    EXPECT_THAT(after(simulation, "add view.level 1"), HasSubstr("B shows it"));
    EXPECT_THAT(after(simulation, "next solver.hessian"), HasSubstr("no effect with symplectic_euler"));
    EXPECT_THAT(after(simulation, "add solver.iterations 5"), HasSubstr("no effect with symplectic_euler"));
    EXPECT_THAT(after(simulation, "set ball.mass=2"), HasSubstr("no effect while the ball's motion is still"));
    simulation.apply(parse_command("set contact.volume=aabb"));
    EXPECT_THAT(after(simulation, "next contact.sphere_fit"), HasSubstr("no effect while the bounding volume is aabb"));
    simulation.apply(parse_command("set contact.volume=brute"));
    EXPECT_THAT(after(simulation, "next view.bounds"), HasSubstr("brute force has no hierarchy"));
}

}  // namespace
}  // namespace drape
