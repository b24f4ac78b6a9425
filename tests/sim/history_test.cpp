#include "drape/session/history.h"

#include <gmock/gmock.h>

#include <random>

#include "drape/base/numbers.h"
#include "drape/scene/memory.h"
#include "drape/session/session.h"
#include "sim/small_scene.h"
#include "support/process.h"
#include "support/scratch_file.h"

namespace drape {
namespace {

using test::ScratchFile;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double no_hurry = 1e9;  // s of wall time that the steps may take

/// A session that keeps its past, and the hash of each step that it has made.
struct Traveller {
    Session session;
    std::vector<std::uint64_t> hashes;

    explicit Traveller(Simulation simulation, HistoryLimits limits = {}) : session(std::move(simulation)) {
        session.keep_history(limits);
        hashes.push_back(session.simulation().hash());
    }

    void run(int steps) {
        hashes.back() = session.simulation().hash();  // after what was done before the next step
        for (int k = 0; k < steps; ++k) {
            make_steps(session, 1);
            hashes.push_back(session.simulation().hash());
        }
    }

    /// Goes to a step, and tells whether it is what it was.
    bool finds_again(std::int64_t step) {
        go_to(session, step);
        return session.timeline().now == step && session.simulation().hash() == hashes[static_cast<std::size_t>(step)];
    }
};

/// What a user does, of all that the motion follows from.
void play_with(Traveller& traveller) {
    Session& session = traveller.session;
    traveller.run(90);
    session.send(command::Grab{0, 75});
    session.send(command::Drag{Vec3(0.2, 0.5, 0.5)});
    traveller.run(80);
    session.send(command::Release{});
    session.send(parse_command("steer 1 0 -1"));
    traveller.run(70);
    session.send(parse_command("set wind.on=true"));
    session.send(parse_command("set view.wireframe=true"));
    traveller.run(60);
    session.send(parse_command("pin 0 40"));
    session.send(parse_command("set solver.dt=0.0004"));
    traveller.run(300);
    session.send(command::Reset{});
    traveller.run(40);
}

class TimeTravel : public testing::TestWithParam<const char*> {};

TEST_P(TimeTravel, HasTheSameBitsBackAndForth) {
    std::vector<std::string> assignments;
    for (const std::string_view word : split_at_commas(GetParam())) assignments.emplace_back(word);
    Traveller traveller(small_simulation(assignments));
    play_with(traveller);
    const auto newest = static_cast<std::int64_t>(traveller.hashes.size()) - 1;
    ASSERT_EQ(traveller.session.timeline().newest, newest);
    ASSERT_EQ(traveller.session.timeline().oldest, 0);
    for (std::int64_t step = newest - 1; step > newest - 60; --step) {
        ASSERT_TRUE(traveller.finds_again(step)) << "one back, to " << step;
    }
    std::mt19937 random(3);
    for (int k = 0; k < 40; ++k) {
        const auto step = std::uniform_int_distribution<std::int64_t>(0, newest)(random);
        ASSERT_TRUE(traveller.finds_again(step)) << "anywhere, to " << step;
    }
    ASSERT_TRUE(traveller.finds_again(200));
    Session& session = traveller.session;
    session.send(command::Pause{});
    while (session.timeline().now < newest) session.advance(session.simulation().settings().solver.dt, no_hurry);
    EXPECT_EQ(session.simulation().hash(), traveller.hashes.back()) << "played again";
    EXPECT_THAT(session.take_news(), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    Settings, TimeTravel,
    testing::Values("solver.integrator=bdf2,solver.hessian=exact", "solver.integrator=projective_dynamics",
                    "solver.integrator=xpbd,contact.volume=obb,contact.update=refit",
                    "solver.integrator=velocity_verlet,contact.update=none,contact.search_level=2",
                    "solver.integrator=symplectic_euler,contact.self=true",
                    "solver.integrator=implicit_midpoint,contact.response=hybrid,contact.volume=brute",
                    "solver.integrator=dormand_prince,solver.ledger=true,contact.update=insertion"));

// Time steps are powers of two: sums of them are exact.
TEST(History, TellsTheTimeOfStepsOfSeveralLengths) {
    Traveller traveller(small_simulation());
    Session& session = traveller.session;
    const double dt = 1.0 / 1024;
    traveller.run(64);
    session.send(parse_command("set solver.dt=0.001953125"));
    traveller.run(32);
    session.send(parse_command("set solver.dt=0.00048828125"));
    traveller.run(128);
    EXPECT_EQ(session.timeline().passed, 192 * dt);
    EXPECT_EQ(session.timeline().back, 0);
    EXPECT_EQ(session.timeline().kept, 192 * dt);

    // In the past, where the time step is another
    for (const auto& [step, passed] : {std::pair{160, 160}, {96, 128}, {80, 96}, {64, 64}, {10, 10}}) {
        ASSERT_TRUE(traveller.finds_again(step));
        EXPECT_EQ(session.timeline().passed, passed * dt) << step;
        EXPECT_EQ(session.timeline().back, (192 - passed) * dt) << step;
        EXPECT_EQ(session.timeline().kept, 192 * dt) << step;
    }
    ASSERT_TRUE(traveller.finds_again(80));
    session.send(parse_command("set solver.dt=0.00048828125"));
    EXPECT_THAT(session.take_news(), ElementsAre(Field(&News::text, HasSubstr("the 0.0938 s that came after"))));
    traveller.hashes.resize(81);
    traveller.run(16);
    EXPECT_EQ(session.timeline().kept, 104 * dt) << "the last change of the step came earlier than before";
}

TEST(History, HasNoTimeOfSleep) {
    // Between its pins nothing moves
    Traveller traveller(small_simulation({"cloth.particles=2,2", "cloth.pinned=four"}), {.seconds = 2});
    Session& session = traveller.session;
    const double dt = session.simulation().settings().solver.dt;
    while (!session.simulation().report().asleep) traveller.run(1);
    const std::int64_t awake = session.timeline().newest;
    const double kept = session.timeline().kept;
    traveller.run(static_cast<int>(5 / dt));
    EXPECT_NEAR(session.timeline().kept, kept, 1.5 * dt);
    EXPECT_EQ(session.timeline().oldest, 0) << "nothing is forgotten meanwhile";
    session.send(parse_command("set wind.on=true"));
    traveller.run(20);
    EXPECT_NEAR(session.timeline().kept, kept + 20 * dt, 1.5 * dt);

    // The bar of time, back over what was slept through
    EXPECT_EQ(session.step_before_newest(0), session.timeline().newest);
    EXPECT_EQ(session.step_before_newest(10 * dt), session.timeline().newest - 10);
    EXPECT_NEAR(static_cast<double>(session.step_before_newest(kept + 10 * dt)), 10, 1);
    EXPECT_TRUE(traveller.finds_again(awake - 5));
    session.send(command::Pause{});
    for (int k = 0; k < 20; ++k) session.advance(dt, no_hurry);
    EXPECT_GT(session.timeline().now, awake + 1000) << "it plays the sleep at once";
    EXPECT_EQ(session.dropped(), 0);

    // From a moment in the sleep
    go_to(session, session.timeline().newest);
    session.go_to(session.timeline().newest - 1);
    int calls = 0;
    for (; !session.timeline().is_computed; ++calls) session.advance(dt, 0);
    EXPECT_LT(calls, 1.5 / dt);
}

TEST(History, HasTheTimeOfAComparedRunThatMovesWhileTheOtherSleeps) {
    Session session(small_simulation({"cloth.particles=2,2", "cloth.pinned=four"}));
    session.keep_history({});
    session.send(command::Compare{"cloth.pinned=none"});
    const double dt = session.simulation().settings().solver.dt;
    while (!session.simulation().report().asleep) make_steps(session, 1);
    const double kept = session.timeline().kept;
    make_steps(session, 100);
    EXPECT_NEAR(session.timeline().kept, kept + 100 * dt, 1e-9);
}

TEST(History, OfAReplayHasTheTimeOfWhatIsAheadWhileItSleeps) {
    Recording recording{.scene = "drop", .assignments = {}, .entries = {}, .last_step = 3000, .notice = {}};
    Session session(small_simulation({"cloth.particles=2,2", "cloth.pinned=four"}));
    session.keep_history({});
    session.replay(recording);
    const double dt = session.simulation().settings().solver.dt;
    while (!session.simulation().report().asleep) make_steps(session, 1);
    make_steps(session, 10);
    const Timeline timeline = session.timeline();
    EXPECT_NEAR(timeline.back, static_cast<double>(3000 - timeline.now) * dt, 1e-9);
    EXPECT_EQ(session.step_before_newest(100 * dt), 2900);
}

TEST(History, ALeftPastStaysWhereItIsWithoutAFileToRecord) {
    Traveller traveller(small_simulation());
    traveller.session.record("", {});
    traveller.run(500);
    go_to(traveller.session, 200);
    traveller.session.close();
    EXPECT_EQ(traveller.session.simulation().hash(), traveller.hashes[200]);
}

TEST(History, SaysThatAStepIsStillComputed) {
    Traveller traveller(small_simulation());
    traveller.run(500);
    traveller.session.go_to(450);
    EXPECT_FALSE(traveller.session.timeline().is_computed);
    go_to(traveller.session, 450);
    EXPECT_TRUE(traveller.session.timeline().is_computed);
}

/// Of the state at the end of a recording that is replayed as it was made.
std::uint64_t hash_of_replay(const std::string& file) {
    Session again(small_simulation());
    again.replay(read_recording(file));
    EXPECT_TRUE(again.run_replay());
    EXPECT_EQ(again.replay_notice(), "");
    return again.simulation().hash();
}

TEST(History, LetsTheUserGoOnFromAnEarlierStep) {
    const ScratchFile file("travel.txt");
    Traveller traveller(small_simulation());
    traveller.session.record(file.name(), {});
    play_with(traveller);
    ASSERT_TRUE(traveller.finds_again(130));  // the hand holds a particle there
    EXPECT_THAT(traveller.session.take_news(), IsEmpty());
    traveller.session.send(parse_command("set view.bounds=true"));
    EXPECT_GT(traveller.session.timeline().newest, 600) << "what is seen takes nothing over";
    EXPECT_THROW(traveller.session.send(parse_command("set solver.dt=-1")), InputError);
    EXPECT_GT(traveller.session.timeline().newest, 600) << "nor does what is refused";

    traveller.session.send(parse_command("set wind.on=true"));
    EXPECT_EQ(traveller.session.timeline().newest, 130);
    EXPECT_THAT(traveller.session.take_news(), ElementsAre(Field(&News::text, HasSubstr("forgotten"))));
    EXPECT_FALSE(traveller.session.view().held) << "nobody's hand";
    traveller.hashes.resize(131);
    traveller.run(50);
    EXPECT_EQ(traveller.session.timeline().newest, 180);
    const std::uint64_t end = traveller.session.simulation().hash();
    EXPECT_TRUE(traveller.finds_again(150));
    EXPECT_TRUE(traveller.finds_again(180)) << "what was done first is forgotten";
    traveller.session.close();
    EXPECT_THAT(test::read_file(file.name()), testing::Not(HasSubstr("reset")));

    // The recording is of the run that the user has made of it
    EXPECT_EQ(hash_of_replay(file.name()), end);
}

TEST(History, RecordsThatAPauseHasEnded) {
    const ScratchFile file("pause.txt");
    Session session(small_simulation());
    session.keep_history({});
    session.record(file.name(), {});
    const double dt = session.simulation().settings().solver.dt;
    for (int k = 0; k < 20; ++k) session.advance(dt, no_hurry);
    session.send(command::Pause{});
    session.go_to(10);
    session.send(command::Pause{});
    while (session.timeline().newest < 40) session.advance(dt, no_hurry);
    const std::uint64_t end = session.simulation().hash();
    session.close();
    Session again(small_simulation());
    again.replay(read_recording(file.name()));
    for (int k = 0; k < 40; ++k) again.advance(dt, no_hurry);
    EXPECT_EQ(again.simulation().hash(), end);
}

TEST(History, RecordsARunThatIsLeftInItsPast) {
    const ScratchFile file("left.txt");
    Traveller traveller(small_simulation());
    traveller.session.record(file.name(), {});
    traveller.run(700);
    go_to(traveller.session, 300);
    traveller.session.close();
    EXPECT_EQ(hash_of_replay(file.name()), traveller.hashes.back()) << "all of it is there";
}

TEST(History, SavesARecordingOfAllThatWasDoneFromAnyMoment) {
    const ScratchFile file("saved.txt");
    Traveller traveller(small_simulation());
    traveller.session.record("", {});
    play_with(traveller);
    go_to(traveller.session, 300);
    ASSERT_TRUE(traveller.session.save_recording(file.name()));
    EXPECT_EQ(hash_of_replay(file.name()), traveller.hashes.back());
}

/// A session that plays commands at their steps, until another step.
Session replaying(const std::vector<std::pair<std::int64_t, const char*>>& commands, std::int64_t last) {
    Recording recording{.scene = "drop", .assignments = {}, .entries = {}, .last_step = last, .notice = {}};
    for (const auto& [step, text] : commands) recording.entries.push_back({step, parse_command(text)});
    Session session(small_simulation());
    session.keep_history({});
    session.replay(recording);
    return session;
}

TEST(History, LetsTheUserTakeOverFromAReplay) {
    Session session = replaying({{100, "set wind.on=true"}}, 500);
    EXPECT_EQ(session.timeline().newest, 500);
    EXPECT_TRUE(session.timeline().replay);
    session.send(command::Pause{});
    make_steps(session, 50);
    EXPECT_TRUE(session.timeline().replay) << "a pause takes nothing over";
    session.send(parse_command("steer 1 0 0"));
    EXPECT_FALSE(session.timeline().replay);
    EXPECT_THAT(session.take_news(), ElementsAre(Field(&News::text, HasSubstr("replay"))));
    make_steps(session, 100);
    EXPECT_FALSE(session.simulation().settings().wind.on);
}

TEST(History, LetsTheUserLeaveAReplay) {
    Session session = replaying({{100, "set wind.on=true"}}, 500);
    make_steps(session, 50);
    session.leave_replay();
    EXPECT_FALSE(session.timeline().replay);
    make_steps(session, 100);
    EXPECT_FALSE(session.simulation().settings().wind.on);
    session.leave_replay();
    EXPECT_EQ(session.timeline().newest, 150) << "there is none";
}

TEST(History, GoesForthAndBackInAReplayAndLeavesItsPausesAlone) {
    Session session = replaying(
        {{100, "pause"}, {100, "step 5"}, {100, "set wind.on=true"}, {100, "next view.bounds"}, {105, "pause"}}, 300);
    go_to(session, 200);
    EXPECT_TRUE(session.simulation().settings().wind.on);
    const bool bounds = session.simulation().settings().view.bounds;
    for (const std::int64_t step : {50, 200, 102, 300}) {
        go_to(session, step);
        EXPECT_EQ(session.timeline().now, step);
        EXPECT_TRUE(session.simulation().paused());
        EXPECT_EQ(session.simulation().steps_wanted(), 0);
        EXPECT_EQ(session.simulation().settings().view.bounds, bounds) << "as it is seen now";
    }
}

TEST(History, StaysWithinItsMemoryAndItsTime) {
    const double moment = moment_bytes(small_simulation());
    Traveller traveller(small_simulation(), {.seconds = 2, .bytes = 6 * moment});
    const int steps_a_second = static_cast<int>(1 / traveller.session.simulation().settings().solver.dt);
    for (int second = 0; second < 8; ++second) {
        traveller.run(steps_a_second);
        EXPECT_LE(traveller.session.timeline().bytes, 6 * moment);
    }
    const Timeline full = traveller.session.timeline();
    EXPECT_GT(full.oldest, 5 * steps_a_second);
    EXPECT_LE(full.oldest, 6 * steps_a_second) << "two seconds and what is before the next moment";
    EXPECT_TRUE(traveller.finds_again(full.oldest));
    EXPECT_TRUE(traveller.finds_again(full.newest - 1));
    EXPECT_LE(traveller.session.timeline().bytes, 6 * moment) << "on the way back too";
    EXPECT_FALSE(traveller.finds_again(full.oldest - 1)) << "forgotten";
}

TEST(History, OfASceneThatIsTooLargeIsEmptyAndGoingBackOnlyPauses) {
    Traveller traveller(small_simulation(), {.bytes = moment_bytes(small_simulation())});
    traveller.run(50);
    EXPECT_TRUE(traveller.session.timeline().is_too_large());
    EXPECT_FALSE(traveller.finds_again(40));
    EXPECT_TRUE(traveller.session.simulation().paused());
    EXPECT_EQ(traveller.session.timeline().now, 50);
}

TEST(History, GoesBackToTheStartOfARunHoweverLongAgo) {
    Traveller traveller(small_simulation(), {.seconds = 0.5});
    Session& session = traveller.session;
    play_with(traveller);
    constexpr std::int64_t start = 600;  // its reset
    EXPECT_EQ(session.timeline().start, start);
    session.send(parse_command("steer 0 1 0"));
    traveller.run(2000);
    session.send(parse_command("set contact.friction=0.9"));
    traveller.run(2000);
    const Timeline live = session.timeline();
    ASSERT_GT(live.oldest, start + 1500);
    EXPECT_FALSE(traveller.finds_again(live.oldest - 1)) << "nothing between is kept";
    ASSERT_TRUE(traveller.finds_again(start));
    EXPECT_EQ(session.timeline().oldest, start);
    const auto play_until = [&](std::int64_t step) {
        session.send(command::Pause{});
        while (session.timeline().now < step) session.advance(session.simulation().settings().solver.dt, no_hurry);
        return session.simulation().hash() == traveller.hashes[static_cast<std::size_t>(step)];
    };
    EXPECT_TRUE(play_until(live.newest));
    EXPECT_EQ(session.timeline().oldest, live.oldest) << "as before";

    ASSERT_TRUE(traveller.finds_again(start));
    ASSERT_TRUE(play_until(start + 1000));
    session.send(parse_command("set wind.on=true"));
    EXPECT_EQ(session.timeline().newest, start + 1000) << "the user goes on from there";
    traveller.hashes.resize(start + 1001);
    traveller.run(500);
    EXPECT_TRUE(traveller.finds_again(start + 700));
    EXPECT_TRUE(traveller.finds_again(start + 1500));
    session.send(parse_command("scene drop"));
    EXPECT_EQ(session.timeline().start, start + 1500) << "another run";
}

// Watched in slow motion, in which a second is few steps
TEST(History, KeepsSomeSecondsOfTheLargestScene) {
    Settings settings = load_scene("large");
    settings.view.speed = 0.02;
    Session session(Simulation("large", std::move(settings)));
    session.keep_history({});
    const int steps_a_second = static_cast<int>(0.02 / session.simulation().settings().solver.dt);
    make_steps(session, 12 * steps_a_second);
    const Timeline timeline = session.timeline();
    EXPECT_GE(timeline.newest - timeline.oldest, 5 * steps_a_second);
    EXPECT_LE(timeline.bytes, HistoryLimits{}.bytes);
}

TEST(History, KnowsTheStartOfEachRunBetweenResets) {
    Session session(small_simulation());
    session.keep_history({});
    make_steps(session, 100);
    session.send(command::Reset{});
    make_steps(session, 100);
    for (const auto& [step, start] : {std::pair(150, 100), std::pair(50, 0)}) {
        go_to(session, step);
        EXPECT_EQ(session.timeline().start, start) << step;
    }
}

TEST(History, NamesTheStepOfARecordingAtWhichAReplayInTheMidstDiffers) {
    const ScratchFile file("false.txt", "drape-recording 1\nscene drop\n5 hash 0123456789abcdef\n12 end\n");
    Session session(small_simulation());
    session.keep_history({});
    make_steps(session, 137);
    Recording recording = read_recording(file.name());
    load_scene_first(recording);
    session.replay(std::move(recording));
    ASSERT_FALSE(session.run_replay() && !session.replay_differs());
    EXPECT_THAT(session.replay_notice(), HasSubstr("before step 5"));
}

TEST(History, PlaysARecordingInTheMidstOfAnotherRun) {
    const ScratchFile file("midst.txt");
    Traveller recorded(shipped_simulation("drop", {"contact.friction=0.9", "ball.position=0.1,0,0"}));
    recorded.session.record(file.name(), {"contact.friction=0.9", "ball.position=0.1,0,0"});
    recorded.session.send(parse_command("steer 0 1 0"));
    recorded.run(200);
    recorded.session.send(parse_command("set wind.on=true"));
    recorded.run(400);
    recorded.session.close();

    Session session(small_simulation());
    session.keep_history({});
    const ScratchFile both("both.txt");
    session.record(both.name(), {});
    make_steps(session, 137);
    go_to(session, 100);
    Recording recording = read_recording(file.name());
    load_scene_first(recording);
    session.send(command::Pause{});
    session.replay(std::move(recording));
    EXPECT_THAT(session.take_news(), ElementsAre(Field(&News::text, HasSubstr("forgotten"))));
    const Timeline timeline = session.timeline();
    EXPECT_TRUE(timeline.replay);
    EXPECT_EQ(timeline.newest - timeline.replay_from, 600);
    EXPECT_EQ(timeline.passed, 0);
    ASSERT_TRUE(session.run_replay());
    EXPECT_EQ(session.simulation().hash(), recorded.hashes.back());
    EXPECT_EQ(session.replay_notice(), "") << "its hashes were those of the states";
    go_to(session, session.timeline().start);
    EXPECT_EQ(session.simulation().settings().contact.friction, Real(0.9)) << "the start of the run that was played";
    EXPECT_FALSE(session.simulation().settings().wind.on);
    session.close();
    EXPECT_EQ(hash_of_replay(both.name()), recorded.hashes.back()) << "a recording has all of it";
}

TEST(History, FinishesItsWayBeforeACommand) {
    Traveller traveller(small_simulation());
    traveller.run(200);
    traveller.session.go_to(150);
    traveller.session.send(parse_command("steer 0 0 0"));
    EXPECT_EQ(traveller.session.timeline().newest, 200) << "the keys steer nothing: nothing is taken over";
    traveller.session.send(parse_command("set wind.on=true"));
    EXPECT_EQ(traveller.session.timeline().newest, 150) << "not where the way had come to";
}

}  // namespace
}  // namespace drape
