#include "drape/session/comparison.h"

#include <gmock/gmock.h>

#include "drape/base/input_error.h"
#include "drape/session/session.h"
#include "sim/small_scene.h"
#include "support/scratch_file.h"

namespace drape {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Session compared(const std::string& versus, const std::vector<std::string>& assignments = {}) {
    Session session(small_simulation(assignments));
    session.send(command::Compare{versus});
    return session;
}

TEST(Comparison, KnowsWhereAnAssignmentEnds) {
    EXPECT_THAT(split_assignments("a=1,2,b.c=x"), ElementsAre("a=1,2", "b.c=x"));
    EXPECT_THROW(static_cast<void>(split_assignments("1,a=2")), InputError);
    Session session(small_simulation());
    EXPECT_THROW(session.send(command::Compare{"solver.integratr=rk4"}), InputError);
    EXPECT_THROW(session.send(command::Compare{"solver.dt=-1"}), InputError);
    EXPECT_EQ(session.view().comparison, nullptr);
}

TEST(Comparison, FindsNoDifferenceWhereThereIsNone) {
    Session session = compared("contact.volume=aabb");
    make_steps(session, 100);
    session.send(command::Grab{0, 75});
    session.send(command::Drag{Vec3(0.2, 0.5, 0.5)});
    make_steps(session, 100);
    session.send(command::Release{});
    session.send(parse_command("steer 1 0 -1"));
    session.send(parse_command("set wind.on=true"));
    make_steps(session, 100);
    session.send(parse_command("pin 0 40"));
    session.send(parse_command("set solver.dt=0.0005"));
    make_steps(session, 300);
    const FrameView view = session.view();
    ASSERT_NE(view.comparison, nullptr);
    EXPECT_EQ(view.comparison->other.settings->contact.volume, VolumeKind::Aabb);
    EXPECT_EQ(view.comparison->largest, 0);
    EXPECT_GT(view.report->traversal.visited, 0);
    session.send(command::Compare{"none"});
    EXPECT_EQ(session.view().comparison, nullptr);
}

TEST(Comparison, LeavesTheFirstSimulationAsItIs) {
    Session session = compared("solver.integrator=backward_euler"), alone(small_simulation());
    make_steps(session, 200);
    make_steps(alone, 200);
    EXPECT_EQ(session.simulation().hash(), alone.simulation().hash());
    const FrameView view = session.view();
    EXPECT_GT(view.comparison->rms, 1e-5);
    EXPECT_GT(view.comparison->largest, view.comparison->rms);
}

// A cloth that begins a decimetre higher stays there
TEST(Comparison, MeasuresADistanceThatIsKnown) {
    Session session = compared("cloth.origin=-0.5,0.7,0", {"ball.position=0,-5,0"});
    make_steps(session, 50);
    const FrameView view = session.view();
    EXPECT_NEAR(view.comparison->rms, 0.1, 1e-6);
    EXPECT_NEAR(view.comparison->largest, 0.1, 1e-6);
    for (const float distance : view.comparison->distances[0]) EXPECT_NEAR(distance, 0.1, 1e-6);
}

TEST(Comparison, ComparesGridsWhereTheirParticlesLie) {
    Session session = compared("cloth.particles=19,15", {"integrator=backward_euler"});
    EXPECT_NEAR(session.view().comparison->largest, 0, 1e-12) << "both are flat";
    make_steps(session, 100);
    EXPECT_GT(session.view().comparison->largest, 1e-4);
    EXPECT_LT(session.view().comparison->largest, 0.1);

    // Another corner is another place of the other grid
    session.send(command::Grab{0, 79});
    EXPECT_EQ(session.view().comparison->other.cloths[0].grabbed, 19 * 15 - 1);
}

TEST(Comparison, ComparesTheSameTimeWhateverTheSteps) {
    Session session = compared("solver.dt=0.002");
    make_steps(session, 100);
    const FrameView& other = session.view().comparison->other;
    const double ahead = other.report->time - session.simulation().report().time;
    EXPECT_LT(ahead, 0.002);
    EXPECT_GE(ahead, 0);
    EXPECT_NEAR(static_cast<double>(other.blend), 1 - ahead / 0.002, 1e-6);
}

/// A setting of all and that of one of them are the same setting here.
TEST(Comparison, KeepsWhatIsComparedApart) {
    struct Change {
        const char *compared, *set;
        bool of_cloth = false;
    };
    for (const Change& change : {Change{"ball.radius", "ball[0].radius"}, Change{"ball[0].radius", "radius"},
                                 Change{"cloth.mass", "cloth[0].mass", true}}) {
        Session session = compared(std::string(change.compared) + "=0.11");
        session.send(command::Set{std::string(change.set) + "=0.23"});
        session.send(parse_command("set friction=0.7"));
        const Settings& other = *session.view().comparison->other.settings;
        EXPECT_EQ(change.of_cloth ? other.cloths[0].mass : other.balls[0].radius, Real(0.11)) << change.compared;
        EXPECT_EQ(other.contact.friction, Real(0.7)) << "the rest is the same in both";
    }
}

TEST(Comparison, OutlivesAResetButNotItsScene) {
    Session session = compared("solver.integrator=backward_euler");
    session.send(command::Reset{});
    make_steps(session, 20);
    ASSERT_TRUE(session.compares());
    EXPECT_LT(session.view().comparison->largest, 0.1) << "both have begun again";
    EXPECT_THROW(session.send(command::LoadScene{"no such scene"}), InputError);
    EXPECT_TRUE(session.compares());
    session.send(command::LoadScene{"hang"});
    EXPECT_FALSE(session.compares());
    EXPECT_EQ(session.view().comparison, nullptr);
    EXPECT_EQ(session.view().settings->view.colour, load_scene("hang").view.colour);
}

TEST(Comparison, IsPartOfARecording) {
    const test::ScratchFile file("compared.txt");
    Session session(small_simulation());
    session.record(file.name(), {});
    make_steps(session, 40);
    session.send(command::Compare{"solver.integrator=backward_euler,contact.friction=0.7"});
    EXPECT_EQ(session.view().report->step, 0) << "both begin again";
    make_steps(session, 150);
    const double apart = session.view().comparison->rms;
    EXPECT_GT(apart, 1e-6);
    session.close();

    Session again(small_simulation());
    again.keep_history({});
    again.replay(read_recording(file.name()));
    EXPECT_TRUE(again.run_replay());
    EXPECT_FALSE(again.replay_differs()) << again.replay_notice();
    ASSERT_NE(again.view().comparison, nullptr);
    EXPECT_EQ(again.view().comparison->rms, apart);
    EXPECT_EQ(again.view().settings->view.colour, ColourBy::Difference);
    go_to(again, 0);
    EXPECT_EQ(again.timeline().now, 40) << "nothing is kept of what was before";
    EXPECT_NE(again.view().comparison, nullptr);
    go_to(again, 190);
    EXPECT_EQ(again.view().comparison->rms, apart);
}

TEST(Comparison, EndsInAReplayWhereItEnded) {
    const test::ScratchFile file("ended.txt");
    Session session(small_simulation());
    session.record(file.name(), {});
    session.send(command::Compare{"contact.friction=0.7"});
    make_steps(session, 20);
    session.send(command::Compare{"none"});
    make_steps(session, 20);
    EXPECT_EQ(session.view().report->step, 40) << "the run goes on";
    session.close();

    Session again(small_simulation());
    again.replay(read_recording(file.name()));
    EXPECT_TRUE(again.run_until(19.0 / 1024));
    EXPECT_NE(again.view().comparison, nullptr);
    EXPECT_TRUE(again.run_replay());
    EXPECT_EQ(again.view().comparison, nullptr);
    EXPECT_FALSE(again.replay_differs()) << again.replay_notice();
}

// A recording may come from anywhere
TEST(Comparison, OfARecordingIsCheckedBeforeAnythingChanges) {
    for (const std::string versus :
         {"solver.dt=-1", "solver.dt=1e-9", "solver.integratr=rk4", "cloth.particles=1,1", "1,a=2", "cloth.mass=nan"}) {
        std::istringstream text("drape-recording 1\nscene small\n30 compare " + versus + "\n60 end\n");
        Session session(small_simulation());
        session.replay(read_recording(text, "foreign.txt"));
        EXPECT_TRUE(session.run_replay());
        EXPECT_TRUE(session.replay_differs()) << versus;
        EXPECT_THAT(session.replay_notice(), HasSubstr("foreign.txt:3: 'compare " + versus + "' is refused"));
        EXPECT_EQ(session.view().comparison, nullptr);
        EXPECT_EQ(session.view().report->step, 60) << "and nothing has begun again";
    }
}

}  // namespace
}  // namespace drape
