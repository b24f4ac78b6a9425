#include <gtest/gtest.h>

#include "drape/session/session.h"
#include "sim/small_scene.h"

namespace drape {
namespace {

constexpr int calm_steps = 20, steps_to_danger = 60;

// A ball that becomes too fast for its time step as it falls
class CrossingDangersTest : public testing::Test {
protected:
    CrossingDangersTest() : session_(falling_ball()) { session_.keep_history({}); }

    static Simulation falling_ball() {
        return shipped_simulation("bullet", {"contact.continuous=false", "dt=5e-3", "integrator=backward_euler",
                                             "ball.velocity=0,-2,0", "ball.position=0,50,-5", "ground.solid=false"});
    }

    void make_steps(int count) {
        session_.send(command::Step{count});
        session_.advance(0, 1e9);
    }

    void go_to(std::int64_t step) {
        session_.go_to(step);
        session_.advance(0, 1e9);
    }

    /// Dangers since the start of the present run.
    [[nodiscard]] std::int64_t of_the_run() { return session_.simulation().report().crossing.starts; }

    Session session_;
};

TEST_F(CrossingDangersTest, CountOnceHoweverOftenTheyArePlayed) {
    make_steps(steps_to_danger);
    EXPECT_EQ(session_.crossing_dangers(), 1);
    go_to(calm_steps);
    ASSERT_EQ(of_the_run(), 0);
    make_steps(steps_to_danger - calm_steps);
    ASSERT_EQ(of_the_run(), 1);
    EXPECT_EQ(session_.crossing_dangers(), 1) << "played again";
}

TEST_F(CrossingDangersTest, AreNewWhereTheUserGoesOnInAnotherWay) {
    make_steps(steps_to_danger);
    go_to(calm_steps);
    session_.send(parse_command("set contact.friction=0.7"));
    EXPECT_EQ(session_.crossing_dangers(), 1);
    make_steps(steps_to_danger);
    EXPECT_EQ(session_.crossing_dangers(), 2);
}

}  // namespace
}  // namespace drape
