#include "../../src/app/crossing_news.h"

#include <gmock/gmock.h>

#include "drape/sim/comparison.h"
#include "drape/sim/scene.h"
#include "drape/sim/session.h"
#include "drape/sim/setting_table.h"

namespace drape {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr int calm_steps = 20, steps_to_danger = 60;

// A ball that becomes too fast for its time step as it falls
class CrossingNewsTest : public testing::Test {
protected:
    CrossingNewsTest() : session_(falling_ball()) { session_.keep_history({}); }

    static Simulation falling_ball() {
        Settings settings = load_scene("bullet");
        const char* changes =
            "contact.continuous=false,solver.dt=5e-3,solver.integrator=backward_euler,ball.velocity=0,-2,0,"
            "ball.position=0,50,-5,ground.solid=false";
        for (const std::string& assignment : split_assignments(changes)) assign(settings, assignment);
        return Simulation("bullet", settings);
    }

    // Makes steps one by one. @return what is told on the way
    std::string told_in(int steps) {
        std::string told;
        for (int k = 0; k < steps; ++k) {
            session_.send(command::Step{1});
            session_.advance(0, 1e9);
            told += news_.take(session_.simulation());
        }
        return told;
    }

    Session session_;
    CrossingNews news_;
};

TEST_F(CrossingNewsTest, TellsOfADangerOnceAlsoAfterGoingBack) {
    EXPECT_THAT(told_in(steps_to_danger), HasSubstr("may pass through"));
    ASSERT_EQ(session_.simulation().report().crossing.starts, 1);
    session_.go_to(calm_steps);
    session_.advance(0, 1e9);
    ASSERT_EQ(session_.simulation().report().crossing.starts, 0);
    EXPECT_THAT(news_.take(session_.simulation()), IsEmpty());
    EXPECT_THAT(told_in(steps_to_danger - calm_steps), IsEmpty()) << "played again";
    EXPECT_EQ(session_.simulation().report().crossing.starts, 1);
}

TEST_F(CrossingNewsTest, TellsOfItAgainInARunOfItsOwn) {
    told_in(steps_to_danger);
    session_.send(command::Reset{});
    news_.forget();
    EXPECT_THAT(told_in(steps_to_danger), HasSubstr("may pass through"));

    // Another run branches off before it
    session_.go_to(session_.timeline().newest - steps_to_danger + calm_steps);
    session_.advance(0, 1e9);
    ASSERT_EQ(session_.simulation().report().crossing.starts, 0);
    session_.send(parse_command("set contact.friction=0.7"));
    news_.go_on_from(session_.simulation());
    EXPECT_THAT(told_in(steps_to_danger), HasSubstr("may pass through"));
}

}  // namespace
}  // namespace drape
