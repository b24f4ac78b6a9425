#include "drape/sim/snapshot.h"

#include <gmock/gmock.h>

#include <sstream>

#include "drape/base/numbers.h"
#include "drape/session/start.h"
#include "sim/small_scene.h"
#include "support/input_errors.h"
#include "support/scratch_file.h"

namespace drape {
namespace {

using test::input_error_of;
using test::ScratchFile;
using testing::HasSubstr;

std::string snapshot_of(Simulation& simulation) {
    std::ostringstream out;
    write_snapshot(out, simulation);
    return out.str();
}

Simulation read(const std::string& text) {
    std::istringstream in(text);
    return read_snapshot(in, "run.snapshot");
}

/// What a report says but for wall times, and for what a search of cloth against itself costs that begins anew.
std::string figures_of(Simulation& simulation) {
    FrameView view = simulation.view();
    StepReport report = *view.report;
    report.times = {};
    report.between_cloths = {};
    report.listed_pairs = 0;
    view.report = &report;
    std::vector<StatsColumn> columns;
    add_report_columns(columns);
    add_ball_columns(columns, view.balls.size());
    std::ostringstream out;
    write_stats_row(out, columns, view);
    return out.str();
}

/// Makes the same steps with a run and with one that goes on from its snapshot.
/// @return whether their bits and figures are the same after each of them
bool go_on_alike(Simulation& run, int steps) {
    Simulation other = read(snapshot_of(run));
    if (other.hash() != run.hash() || snapshot_of(other) != snapshot_of(run)) return false;
    for (int k = 0; k < steps; ++k) {
        run.step(), other.step();
        if (other.hash() != run.hash() || figures_of(other) != figures_of(run)) return false;
    }
    return true;
}

int steps_of(const Simulation& simulation, double time) {
    return static_cast<int>(std::lround(time / simulation.settings().solver.dt));
}

class Snapshot : public testing::TestWithParam<std::string> {};

TEST_P(Snapshot, OfAShippedSceneGoesOnWithTheSameBits) {
    Simulation run = shipped_simulation(GetParam(), {"solver.ledger=true"});
    for (const double time : {0.05, 0.3}) {
        make_steps(run, steps_of(run, time));
        EXPECT_TRUE(go_on_alike(run, steps_of(run, 0.05))) << "at " << run.report().time;
    }
}

INSTANTIATE_TEST_SUITE_P(Long, Snapshot, testing::ValuesIn(scenes_that_fail(false)), name_of_param);

class SnapshotOfAMethod : public testing::TestWithParam<std::string> {};

TEST_P(SnapshotOfAMethod, GoesOnWithTheSameBits) {
    for (const char* const response : {"projection", "penalty", "impulse", "hybrid"}) {
        Simulation run =
            shipped_simulation("trampoline", {"solver.dt=0.005", "on_unstable=substep", "integrator=" + GetParam(),
                                              std::string("contact.response=") + response});
        for (const int steps : {3, 100, 20}) {
            make_steps(run, steps);
            EXPECT_TRUE(go_on_alike(run, 5)) << response << " at " << run.report().time;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Nightly, SnapshotOfAMethod, testing::ValuesIn(names_of<IntegratorKind>()), name_of_param);
INSTANTIATE_TEST_SUITE_P(Bdf2, SnapshotOfAMethod, testing::Values("bdf2"));

TEST(SnapshotOfALimitedSearch, GoesOnWithTheSameBits) {
    Simulation run = shipped_simulation("drop", {"contact.search_level=2"});
    run_until(run, 0.1);
    const auto is_of_node = [](const ContactRow& row) { return row.kind == RowKind::Node; };
    EXPECT_GT(std::ranges::count_if(run.contacts(), is_of_node), 3);
    EXPECT_TRUE(go_on_alike(run, 10));
}

TEST(SnapshotOfAUser, GoesOnWithWhatIsBeingDone) {
    Simulation run = shipped_simulation("drop");
    const auto check = [&](const std::string& command) {
        send(run, command);
        make_steps(run, 20);
        EXPECT_TRUE(go_on_alike(run, 40)) << command;
    };
    check("steer 1 0 -1");
    check("grab 0 75");
    check("drag 0.2 0.6 0.5");
    check("set integrator=bdf2");
    check("pin 0 40");
    check("set cloth.mass=0.3");
    check("set wind.on=true");
    check("hold 0");
    check("drag 0.3 0.6 0.2");
    check("release");
    check("set dt=0.001");
    check("throw 0 2 0 0.5 0 0.5");
    check("next contact.update");
    Simulation other = read(snapshot_of(run));
    for (Simulation* const simulation : {&run, &other}) send(*simulation, "reset"), make_steps(*simulation, 30);
    EXPECT_EQ(other.hash(), run.hash()) << "the user's ball is the scene's again";
}

TEST(SnapshotOfAUser, SleepsOnAndWakesAlike) {
    Simulation run = shipped_simulation("drop", {"solver.sleep_speed=0.01"});
    run_until(run, 1);
    EXPECT_TRUE(go_on_alike(run, steps_of(run, 0.6))) << "the watch goes on";
    while (!run.report().asleep && run.report().time < 6) run.step();
    ASSERT_TRUE(run.report().asleep);
    Simulation other = read(snapshot_of(run));
    EXPECT_TRUE(other.report().asleep);
    for (Simulation* const simulation : {&run, &other}) {
        make_steps(*simulation, 10);
        send(*simulation, "grab 0 3");
        make_steps(*simulation, 10);
    }
    EXPECT_EQ(other.hash(), run.hash());
}

TEST(SnapshotFile, IsRefusedWithItsLineWhereItIsNoneOrDamaged) {
    Simulation run = shipped_simulation("three_balls", {"cloth.particles=4,3", "solver.ledger=true"});
    send(run, "grab 0 3");
    make_steps(run, 300);
    const std::string whole = snapshot_of(run);
    EXPECT_THAT(whole, testing::StartsWith("drape-snapshot 1 8\nscene three_balls\n"));
    EXPECT_THAT(input_error_of([] { read("drape-recording 1\n"); }), HasSubstr("run.snapshot:1: drape-snapshot: "));
    EXPECT_THAT(input_error_of([] { read("drape-snapshot 2 8\n"); }), HasSubstr("allowed 1, not 2"));
    EXPECT_THAT(input_error_of([] { read("drape-snapshot 1 8\nscene none\nchanges 0\nsettings 0\n"); }),
                HasSubstr("run.snapshot:4: settings: "));
    int lines = 0;
    for (std::size_t end = whole.find('\n'); end != std::string::npos; end = whole.find('\n', end + 1)) {
        ++lines;
        if (end + 1 == whole.size()) break;
        const std::string place = "run.snapshot:" + std::to_string(lines + 1) + ": ";
        EXPECT_THAT(input_error_of([&] { read(whole.substr(0, end + 1)); }), HasSubstr(place));
        // The next line with a value more, and with its last one spoiled
        const std::size_t next = whole.find('\n', end + 1);
        std::string longer = whole, spoiled = whole;
        longer.insert(next, " 1");
        spoiled.replace(whole.rfind(' ', next) + 1, 1, "x");
        const bool is_text = lines < 8, is_last = whole.substr(end + 1, 4) == "end\n";
        if (is_text || is_last) continue;
        EXPECT_THAT(input_error_of([&] { read(longer); }), HasSubstr(place));
        EXPECT_THAT(input_error_of([&] { read(spoiled); }), HasSubstr(place));
    }
}

TEST(SnapshotFile, NamesNoParticleOrBodyThatThereIsNot) {
    Simulation run = shipped_simulation("table", {"cloth.particles=6,5"});
    const auto is_of_particle = [](const ContactRow& row) { return row.kind == RowKind::Particle; };
    for (int k = 0; k < 5000 && std::ranges::none_of(run.contacts(), is_of_particle); ++k) run.step();
    const std::string whole = snapshot_of(run);
    const std::size_t row = whole.find("\nrow 0 ") + 1, of = whole.find("\nof ", row) + 1;
    ASSERT_GT(row, 0u);
    ASSERT_GT(of, row);
    const auto with_word = [&](std::size_t line, int number, const std::string& word) {
        std::string text = whole;
        std::size_t begin = line;
        for (int k = 0; k < number; ++k) begin = text.find(' ', begin) + 1;
        text.replace(begin, text.find_first_of(" \n", begin) - begin, word);
        return input_error_of([&] { read(text); });
    };
    const int kind = 1, count = 2, triangle = 6, first_body = 7, body = 8, cloth = 1, particle = 2;
    EXPECT_EQ(with_word(row, kind, whole.substr(row + 4, 1)), "");
    for (const auto& [number, word] : {std::pair{kind, "3"},
                                       {kind, "4"},
                                       {count, "5"},
                                       {count, "0"},
                                       {triangle, "40"},
                                       {first_body, "0"},
                                       {body, "7"},
                                       {body, "-1"}}) {
        EXPECT_NE(with_word(row, number, word), "") << number << ": " << word;
    }
    for (const auto& [number, word] : {std::pair{cloth, "1"}, {particle, "30"}, {particle, "1e9"}}) {
        EXPECT_NE(with_word(of, number, word), "") << number << ": " << word;
    }
}

TEST(SnapshotFile, IsNotWrittenWhereItCouldNotBeRead) {
    Simulation ended = shipped_simulation("fails_explicit_euler");
    for (int k = 0; k < 20'000 && ended.report().status == Status::Ok; ++k) ended.step();
    ASSERT_EQ(ended.report().status, Status::Diverged);
    EXPECT_THROW(snapshot_of(ended), RunError);
    Simulation twisted = shipped_simulation("twist");
    send(twisted, "set cloth.pinned=none");
    EXPECT_THROW(snapshot_of(twisted), RunError);
}

TEST(SnapshotFile, IsRefusedOnceItsSceneHasChanged) {
    const ScratchFile scene("scene.toml");
    const std::string text = "[cloth]\nparticles = [4, 3]\nmass = ";
    scene.write(text + "0.1\n");
    Simulation run = shipped_simulation(scene.name());
    const std::string snapshot = snapshot_of(run);
    EXPECT_EQ(read(snapshot).hash(), run.hash());
    scene.write(text + "0.2\n");
    EXPECT_THAT(input_error_of([&] { read(snapshot); }), HasSubstr("has changed since"));
}

TEST(SnapshotInASession, BeginsARecordingWhichGivesTheSameBits) {
    const ScratchFile snapshot("run.snapshot"), recorded("recording.txt");
    Session whole(shipped_simulation("trampoline", {"cloth.mass=0.3"}));
    whole.run_until(0.4);
    write_snapshot(snapshot.name(), whole.simulation());
    whole.send(command::Set{"wind.on=true"});
    whole.run_until(0.6);
    {
        Session on =
            make_session(make_start({.assignments = {"wind.on=true"}, .load = snapshot.name()}), recorded.name());
        EXPECT_EQ(on.start_time(), 0.4);
        on.run_until(0.6);
        EXPECT_EQ(on.simulation().hash(), whole.simulation().hash());
    }
    Session again = make_session(make_start({.replay = recorded.name()}));
    EXPECT_TRUE(again.run_replay());
    EXPECT_EQ(again.replay_notice(), "");
    EXPECT_EQ(again.simulation().hash(), whole.simulation().hash());
    EXPECT_EQ(again.simulation().report().time, 0.6);
    EXPECT_THROW(make_start({.scene = "drop", .load = snapshot.name()}), InputError);
    EXPECT_THROW(make_start({.load = snapshot.name(), .versus = "dt=1e-4"}), InputError);
    EXPECT_THROW(make_start({.assignments = {"cloth.particles=9,9"}, .load = snapshot.name()}), InputError);
}

TEST(SnapshotInASession, IsWhatTimeGoesBackTo) {
    const ScratchFile snapshot("run.snapshot");
    Simulation run = shipped_simulation("drop");
    run_until(run, 0.3);
    write_snapshot(snapshot.name(), run);
    Session session(shipped_simulation("fold"));
    session.keep_history({});
    session.send(command::Load{snapshot.name()});
    EXPECT_EQ(session.simulation().scene(), "drop");
    make_steps(session, 20);
    go_to(session, 0);
    EXPECT_EQ(session.simulation().hash(), run.hash());
}

}  // namespace
}  // namespace drape
