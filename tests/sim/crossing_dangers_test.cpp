#include <gtest/gtest.h>

#include "sim/small_scene.h"

namespace drape {
namespace {

// By a ball that becomes too fast for its time step as it falls
TEST(CrossingDangers, CountOnceHoweverOftenTheyArePlayedAndAreNewWhereTheUserGoesOnInAnotherWay) {
    constexpr int calm_steps = 20, steps_to_danger = 60;
    Session session(
        shipped_simulation("bullet", {"contact.continuous=false", "dt=5e-3", "integrator=backward_euler",
                                      "ball.velocity=0,-2,0", "ball.position=0,50,-5", "ground.solid=false"}));
    session.keep_history({});
    const auto of_the_run = [&] { return session.simulation().report().crossing.starts; };
    using Topics = std::vector<News::Topic>;
    const auto topics = [&] {
        Topics all;
        for (const News& news : session.take_news()) all.push_back(news.topic);
        return all;
    };
    make_steps(session, steps_to_danger);
    EXPECT_EQ(topics(), Topics{News::Topic::Crossing});
    go_to(session, calm_steps);
    ASSERT_EQ(of_the_run(), 0);
    make_steps(session, steps_to_danger - calm_steps);
    ASSERT_EQ(of_the_run(), 1);
    EXPECT_EQ(topics(), Topics{}) << "played again";

    go_to(session, calm_steps);
    session.send(parse_command("set contact.friction=0.7"));
    EXPECT_EQ(topics(), Topics{News::Topic::Takeover}) << "what came after is forgotten";
    make_steps(session, steps_to_danger);
    EXPECT_EQ(topics(), Topics{News::Topic::Crossing});

    session.send(parse_command("reset"));
    make_steps(session, steps_to_danger);
    EXPECT_EQ(of_the_run(), 1);
    session.send(parse_command("reset"));
    EXPECT_EQ(topics(), Topics{}) << "of a run that is no more";
}

}  // namespace
}  // namespace drape
