#include "drape/session/session.h"

#include <gmock/gmock.h>

#include <random>

#include "sim/small_scene.h"
#include "support/scratch_file.h"

namespace drape {
namespace {

using test::ScratchFile;
using testing::HasSubstr;

constexpr double unlimited = 1e9;  // s of wall time that the steps may take
constexpr double step_length = 1.0 / 1024;

Session small_session() { return Session(small_simulation()); }

/// Commands of all kinds that change the state, at given steps.
Recording busy_recording() {
    Recording recording{.scene = "drop", .assignments = {}, .entries = {}, .last_step = {}, .notice = {}};
    const auto at = [&](std::int64_t step, const char* text) {
        recording.entries.push_back({step, parse_command(text)});
    };
    at(0, "steer 1 0 -1");
    at(20, "set wind.on=true");
    at(40, "grab 0 75");
    at(40, "drag 0.2 0.5 0.5");
    at(60, "next integrator");
    at(80, "orbit 0.1 0.2");
    at(90, "release");
    at(100, "set solver.dt=0.00048828125");
    at(120, "next volume");
    at(140, "pause");
    at(140, "step 3");
    at(143, "pause");
    at(150, "hold 0");
    at(150, "drag 0.3 0.4 0.3");
    at(180, "release");
    return recording;
}

std::int64_t steps_made(Session& session) { return session.simulation().report().step; }

TEST(Session, MakesTheSameStatesWhateverTheFrameLengths) {
    Session steady = small_session(), jerky = small_session(), at_once = small_session();
    for (Session* session : {&steady, &jerky, &at_once}) session->replay(busy_recording());
    std::mt19937 random(5);
    while (steps_made(steady) < 200) steady.advance(1.0 / 2048, unlimited);
    while (steps_made(jerky) < 200) {
        const double left = (200 - static_cast<double>(steps_made(jerky))) / 2048;
        jerky.advance(std::min(std::uniform_real_distribution<double>(0, 0.02)(random), left), unlimited);
    }
    for (double time = 0; steps_made(at_once) < 200; time += 1.0 / 2048) at_once.run_until(time);
    EXPECT_EQ(steps_made(steady), 200);
    EXPECT_EQ(steps_made(jerky), 200);
    EXPECT_EQ(steps_made(at_once), 200);
    EXPECT_EQ(steady.simulation().hash(), jerky.simulation().hash());
    EXPECT_EQ(steady.simulation().hash(), at_once.simulation().hash());
    Session alone = small_session();
    alone.run_until(200 * step_length);
    EXPECT_NE(alone.simulation().hash(), steady.simulation().hash()) << "the commands did nothing";
}

TEST(Session, MakesAsManyStepsAsTimePassesAndFewerOrMoreInSlowMotionAndFasterThanReal) {
    for (const double speed : {1.0, 0.25, 4.0}) {
        Session session = small_session();
        session.send(command::Set{"view.speed=" + std::to_string(speed)});
        for (int frame = 0; frame < 64; ++frame) session.advance(1.0 / 64, unlimited);
        EXPECT_EQ(steps_made(session), static_cast<std::int64_t>(1024 * speed));
        EXPECT_EQ(session.dropped(), 0);
    }
}

TEST(Session, RunsUntilTheLastStepNotBeyondATime) {
    Session session = small_session();
    session.run_until(2.75 * step_length);
    EXPECT_EQ(steps_made(session), 2);
    EXPECT_DOUBLE_EQ(static_cast<double>(session.blend()), 0.75);
    session.run_until(3 * step_length);
    EXPECT_EQ(steps_made(session), 3);
    session.run_until(2 * step_length);
    EXPECT_EQ(steps_made(session), 3);
    Session decimal(small_simulation({"dt=1e-4"}));
    decimal.run_until(0.3);
    EXPECT_EQ(steps_made(decimal), 3000) << "0.3 / 1e-4 is a little less than 3000 in floating point";
}

TEST(Session, StopsAtATimeOfTheSceneThatStartsLater) {
    const ScratchFile file("state.csv");
    Simulation first = small_simulation();
    make_steps(first, 100);
    file.write(state_text(first));
    Session session(small_simulation({"start=" + file.name()}));
    EXPECT_EQ(session.start_time(), 100 * step_length);
    session.run_until(100 * step_length);
    EXPECT_EQ(steps_made(session), 0) << "it is there already";
    session.run_until(150.5 * step_length);
    EXPECT_EQ(steps_made(session), 50);
    EXPECT_EQ(session.simulation().report().time, 150 * step_length);
    EXPECT_DOUBLE_EQ(static_cast<double>(session.blend()), 0.5);
    EXPECT_EQ(session.time(), 150 * step_length);
    EXPECT_EQ(session.steps_to(150.5 * step_length), 0.5);
    EXPECT_EQ(session.steps_to((155 - 1e-7) * step_length), 5) << "rounding";
}

TEST(Session, MakesUpForAQuarterOfASecondAfterAStallAndSaysWhatItDropped) {
    Session session = small_session();
    session.advance(10, unlimited);
    EXPECT_EQ(steps_made(session), 256);
    EXPECT_DOUBLE_EQ(session.dropped(), 9.75);
    session.advance(step_length, unlimited);
    EXPECT_EQ(steps_made(session), 257);
    session.advance(-5, unlimited);
    EXPECT_EQ(steps_made(session), 257) << "a clock that goes back makes no steps and takes none";
    session.send(command::Reset{});
    EXPECT_EQ(session.dropped(), 0);
}

TEST(Session, GivesUpWholeStepsThatItsBudgetDoesNotCover) {
    Session session = small_session();
    session.advance(10.5 * step_length, 0);
    EXPECT_EQ(steps_made(session), 1);
    EXPECT_NEAR(session.dropped(), 9 * step_length, 1e-12);
    EXPECT_NEAR(static_cast<double>(session.blend()), 0.5, 1e-9);
}

TEST(Session, StandsStillWhilePausedAndGoesOnWithoutALeap) {
    Session session = small_session();
    session.advance(10 * step_length, unlimited);
    session.send(command::Pause{});
    EXPECT_EQ(session.blend(), 1);
    const std::uint64_t hash = session.simulation().hash();
    session.advance(100, unlimited);
    EXPECT_EQ(session.simulation().hash(), hash);
    EXPECT_EQ(session.dropped(), 0);
    session.send(command::Pause{});
    session.advance(step_length, unlimited);
    EXPECT_EQ(steps_made(session), 11);
}

TEST(Session, MakesTheStepsAskedForAndThenStandsStill) {
    Session session = small_session();
    session.send(command::Step{3});
    for (int frame = 0; frame < 5; ++frame) session.advance(1, unlimited);
    EXPECT_EQ(steps_made(session), 3);
    EXPECT_TRUE(session.simulation().paused());
    EXPECT_EQ(session.simulation().steps_wanted(), 0);
    session.send(command::Step{2});
    session.send(command::Pause{});
    EXPECT_EQ(session.simulation().steps_wanted(), 0) << "going on forgets them";
}

TEST(RecordedSession, DoesNotRecordWhatWasRefused) {
    const ScratchFile file("session.txt");
    Session session = small_session();
    session.record(file.name(), {"dt=1e-4"});
    EXPECT_THROW(session.send(command::Set{"dt=5"}), InputError);
    EXPECT_THROW(session.send(command::Grab{0, 80}), InputError);
    session.send(command::Pause{});
    session.close();
    const Recording recording = read_recording(file.name());
    EXPECT_EQ(recording.assignments, std::vector<std::string>{"dt=1e-4"});
    ASSERT_EQ(recording.entries.size(), 2u) << "the pause and the closing hash";
    EXPECT_EQ(command_text(std::get<Command>(recording.entries[0].content)), "pause");
}

TEST(ReplayedSession, NamesTheFirstStepThatDiffersAndThatItsRecordingWasCutOnceItHasPlayedIt) {
    Session session = small_session();
    Session reference = small_session();
    reference.run_until(10 * step_length);
    Recording recording;
    recording.entries = {{10, reference.simulation().hash()}, {30, std::uint64_t{1}}, {40, std::uint64_t{2}}};
    recording.notice = "cut off";
    session.replay(recording);
    session.run_until(29 * step_length);
    EXPECT_EQ(session.replay_notice(), "");
    session.run_until(50 * step_length);
    EXPECT_THAT(session.replay_notice(), testing::AllOf(HasSubstr("before step 30"), testing::EndsWith("; cut off")));
}

TEST(ReplayedSession, EndsWhereItWasClosedOrAtItsLastWholeLine) {
    Recording recording;
    recording.entries = {{5, Command(command::Orbit{})}, {7, Command(command::Pause{})}};
    Session cut = small_session();
    cut.replay(recording);
    cut.run_replay();
    EXPECT_EQ(steps_made(cut), 7);
    const std::vector<Command> seen = cut.take_view_commands();
    EXPECT_TRUE(std::holds_alternative<command::Orbit>(seen.at(0))) << "for the camera";
    EXPECT_TRUE(cut.simulation().paused()) << "the last command is carried out too";
    recording.last_step = 9;
    Session whole = small_session();
    whole.replay(recording);
    whole.run_replay();
    EXPECT_EQ(steps_made(whole), 9);
}

TEST(ReplayedSession, SaysWhichCommandItCouldNotCarryOut) {
    Session session = small_session();
    Recording recording;
    recording.file = "session.txt";
    recording.entries = {{1, Command(command::Grab{7, 0}), 3}, {2, Command(command::Pause{}), 4}};
    session.replay(recording);
    session.run_until(5 * step_length);
    EXPECT_EQ(session.replay_notice(),
              "the replay differs from its recording: session.txt:3: 'grab 7 0' is refused: grab: cloth 7: allowed 0 "
              "to 0");
    EXPECT_TRUE(session.replay_differs());
    EXPECT_TRUE(session.simulation().paused()) << "what follows is played";
}

TEST(Session, StopsBetweenTwoStepsWhenItIsToldToAndGoesOnWithTheSameBits) {
    Session whole(small_simulation()), stopped(small_simulation());
    whole.run_until(20 * step_length);
    int asked = 0;
    EXPECT_FALSE(stopped.run_until(20 * step_length, [&asked] { return ++asked == 6; }));
    EXPECT_EQ(stopped.simulation().report().step, 5);
    EXPECT_TRUE(stopped.run_until(20 * step_length, [] { return false; }));
    EXPECT_EQ(stopped.simulation().hash(), whole.simulation().hash());
}

}  // namespace
}  // namespace drape
