// The ball that the user leads, drops and throws, and what the user is told of balls that are too fast.

#include <gmock/gmock.h>

#include "sim/small_scene.h"
#include "support/input_errors.h"

namespace drape {
namespace {

using test::input_error_of;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(UsersBall, IsLedByTheKeysWhateverMovedItAndGivenBackByAReset) {
    for (const std::string scene : {"drop", "curtain", "trampoline"}) {
        Simulation simulation = shipped_simulation(scene);
        const BallMotion motion = simulation.settings().balls[0].motion;
        const Vec3 start = simulation.balls()[0].centre;
        send(simulation, "steer 0 1 0");
        make_steps(simulation, 500);
        EXPECT_GT(simulation.balls()[0].velocity.y(), 0.3) << scene;
        send(simulation, "reset");
        EXPECT_EQ(simulation.settings().balls[0].motion, motion) << scene;
        EXPECT_EQ(simulation.balls()[0].centre, start) << scene;
    }
}

TEST(UsersBall, IsTheOneThatIsGivenToTheKeys) {
    Simulation simulation = shipped_simulation("three_balls");
    for (const char* change : {"ball[0].motion=still", "ball[1].motion=keys"})
        send(simulation, "set " + std::string(change));
    send(simulation, "steer 1 0 0");
    EXPECT_EQ(simulation.settings().balls[0].motion, BallMotion::Still);
    make_steps(simulation, 100);
    EXPECT_GT(simulation.balls()[1].velocity.x(), 0);
    send(simulation, "set ball[0].motion=free");
    EXPECT_EQ(simulation.settings().balls[1].motion, BallMotion::Keys);
}

TEST(UsersBall, FallsWhenItIsLetGo) {
    Simulation simulation = shipped_simulation("original", {"ball.position=5,0,0"});
    send(simulation, "fall");
    make_steps(simulation, 320);
    EXPECT_NEAR(simulation.balls()[0].centre.y(), -9.81 * 0.01 / 2, 1e-3);
    send(simulation, "steer 1 0 0");
    make_steps(simulation, 1000);
    EXPECT_NEAR(simulation.balls()[0].velocity.y(), 0, 0.05) << "the keys have it again";
}

TEST(UsersBall, FliesWhereItIsThrown) {
    Simulation simulation = shipped_simulation("drop");
    send(simulation, "throw 5 1 0 3 2 0");
    make_steps(simulation, 320);
    const Ball& ball = simulation.balls()[0];
    EXPECT_NEAR(ball.centre.x(), 5.3, 1e-6);
    EXPECT_NEAR(ball.centre.y(), 1.2 - 9.81 * 0.01 / 2, 1e-3);
}

TEST(UsersBall, CannotBeThrownWhereThereIsNone) {
    Simulation simulation = shipped_simulation("hang");
    EXPECT_THAT(input_error_of([&] { send(simulation, "throw 0 1 0 0 0 0"); }), HasSubstr("no ball"));
    EXPECT_THAT(input_error_of([&] { send(simulation, "fall"); }), HasSubstr("no ball"));
    send(simulation, "steer 1 0 0");
}

/// Warned of where balls and solids are so fast that they may cross unseen, and only there.
TEST(CrossingWarning, NamesTheSpeedsOnceForEachDanger) {
    struct Danger {
        const char* scene;
        std::vector<std::string> fast;
        const char *what, *limit;
        int more_steps;
    };
    const Danger ball{"curtain",
                      {"ball.motion=free", "ball.position=0,0.75,-3", "ball.velocity=0,0,30",
                       "integrator=backward_euler", "dt=0.016666666666666666"},
                      "30",
                      "above 6.66 m/s",
                      5};
    const Danger solid{"table",
                       {"integrator=backward_euler", "dt=0.05", "solid.motion=path", "solid.path=0,0,-3,0,1,0,40,0"},
                       "a solid",
                       "above 2.27 m/s",
                       0};
    for (Danger danger : {ball, solid}) {
        SCOPED_TRACE(danger.scene);
        Simulation automatic = shipped_simulation(danger.scene, danger.fast);
        danger.fast.emplace_back("contact.continuous=false");
        Simulation blind = shipped_simulation(danger.scene, danger.fast);
        Simulation slow = shipped_simulation(danger.scene, {"contact.continuous=false"});
        EXPECT_THAT(blind.crossing_warning(), IsEmpty());
        blind.step();
        EXPECT_THAT(blind.crossing_warning(), AllOf(HasSubstr(danger.what), HasSubstr(danger.limit)));
        make_steps(blind, danger.more_steps), make_steps(automatic, 1 + danger.more_steps), make_steps(slow, 100);
        EXPECT_EQ(blind.report().crossing.starts, 1);
        EXPECT_THAT(automatic.crossing_warning(), IsEmpty());
        EXPECT_THAT(slow.crossing_warning(), IsEmpty());
    }
}

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

TEST(StartWarning, SaysHowDeepClothStartsInSomething) {
    const auto warning_of = [](const std::string& scene, const std::string& change) {
        return shipped_simulation(scene, {change}).step_warning();
    };
    EXPECT_THAT(warning_of("drop", "ball.position=0,0.8,0"), HasSubstr("cloth starts 0."));
    EXPECT_THAT(warning_of("table", "cloth.centre=0,0.4,0"), HasSubstr("cloth starts 0.1 m deep"));
    EXPECT_THAT(warning_of("drop", "ground.height=2"), HasSubstr("deep inside a ball, a solid or the ground"));
    EXPECT_THAT(shipped_simulation(
                    "table", {"cloth.centre=0,0.4,0", "cloth.size=0.2,0.2", "cloth.pinned=four", "cloth.particles=2,2"})
                    .step_warning(),
                testing::Not(HasSubstr("cloth starts")))
        << "pins stay";
    for (const std::string& scene : scene_names()) {
        EXPECT_THAT(warning_of(scene, "view.speed=1"), testing::Not(HasSubstr("cloth starts"))) << scene;
    }
}

TEST(PenaltyLimit, JoinsTheWarningOfTheStep) {
    const std::vector<std::string> stiff{"contact.stiffness=4000", "contact.response=penalty"};
    EXPECT_THAT(shipped_simulation("drop", stiff).step_warning(),
                AllOf(HasSubstr("1.6 times the step limit of the penalty"), HasSubstr("4000 N/m")));
    EXPECT_THAT(shipped_simulation("drop", {"contact.stiffness=1500", "contact.response=hybrid"}).step_warning(),
                IsEmpty());
    EXPECT_THAT(shipped_simulation("drop", {"contact.stiffness=4000"}).step_warning(), IsEmpty())
        << "projection has no limit";
}

}  // namespace
}  // namespace drape
