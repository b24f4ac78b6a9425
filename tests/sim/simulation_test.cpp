#include "drape/sim/simulation.h"

#include <gmock/gmock.h>

#include <set>

#include "sim/small_scene.h"
#include "support/allocations.h"

namespace drape {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

void expect_no_allocation(const std::string& setting, const std::string& other) {
    Simulation simulation = small_simulation({setting, other, "leaf_cells=2"});
    while (simulation.report().contacts == 0) simulation.step();
    const auto before = test::allocations();
    make_steps(simulation, 500);
    EXPECT_EQ(test::allocations(), before) << setting << " " << other;
}

TEST(Simulation, AllocatesNothingInAStepOnceItHasContacts) {
    for (const std::string& volume : names_of<VolumeKind>()) {
        for (const std::string& update : names_of<UpdateKind>()) {
            expect_no_allocation("volume=" + volume, "update=" + update);
        }
    }
    for (const char* setting : {"search_level=2", "search_tests=16", "sphere_fit=box", "sphere_fit=ritter",
                                "sphere_fit=epos26", "sphere_fit=welzl"}) {
        expect_no_allocation(setting, "update=rebuild");
    }
}

TEST(Simulation, CountsTheCandidatesOfWhichNoTriangleTouches) {
    Simulation simulation = small_simulation();
    make_steps(simulation, 700);
    std::set<int> touching;
    for (const ContactRow& contact : simulation.contacts()) touching.insert(contact.triangle / 2);
    const StepReport& report = simulation.report();
    EXPECT_GE(simulation.contacts().size(), touching.size());
    EXPECT_GT(report.false_candidates, 0);
    EXPECT_EQ(report.false_candidates, report.traversal.candidates - static_cast<std::int64_t>(touching.size()));
}

TEST(Simulation, ReportsWhatTheLastStepDid) {
    Simulation simulation = small_simulation({"ledger=true"}), without_ledger = small_simulation();
    make_steps(simulation, 700);
    const StepReport& report = *simulation.view().report;
    EXPECT_EQ(report.step, 700);
    EXPECT_DOUBLE_EQ(report.time, 700.0 / 1024);
    EXPECT_EQ(report.solve.force_evaluations, 1);
    EXPECT_GT(report.contacts, 0);
    EXPECT_GE(report.traversal.candidates, report.contacts / 2);
    EXPECT_LE(report.traversal.candidates, 63);
    EXPECT_GT(report.traversal.visited, 0);
    EXPECT_GT(report.times.total(), 0);
    EXPECT_NEAR(report.rms_speed, std::sqrt(simulation.cloths()[0].state.v.squaredNorm() / 80), 1e-12);
    for (const ReportField& field : report_fields()) {
        EXPECT_TRUE(std::isfinite(field.read(report))) << field.name;
        const bool known = std::isfinite(field.read(*without_ledger.view().report));
        EXPECT_EQ(known, field.group != ReportGroup::Balance) << field.name;
    }
}

TEST(Simulation, KeepsItsTimeWhenTheStepChanges) {
    Simulation simulation = small_simulation();
    make_steps(simulation, 512);
    simulation.apply(command::Set{"dt=0.000244140625"});
    EXPECT_DOUBLE_EQ(simulation.report().time, 0.5);
    make_steps(simulation, 1024);
    EXPECT_DOUBLE_EQ(simulation.report().time, 0.75);
    EXPECT_EQ(simulation.report().step, 1536);
    simulation.apply(command::Reset{});
    make_steps(simulation, 1);
    EXPECT_DOUBLE_EQ(simulation.report().time, 0.000244140625);
}

TEST(Simulation, NeverMovesPinnedParticles) {
    for (const char* pins : {"two", "four", "row", "border", "[3, 40, 41]"}) {
        Simulation simulation = small_simulation({std::string("cloth.pinned=") + pins, "wind.on=true"});
        const ClothState start = simulation.cloths()[0].state;
        make_steps(simulation, 800);
        const auto& [x, v] = simulation.cloths()[0].state;
        for (int p = 0; p < 80; ++p) {
            if (!simulation.cloths()[0].model.pinned(p)) continue;
            EXPECT_EQ(x.row(p), start.x.row(p)) << pins;
            EXPECT_EQ(v.row(p), start.v.row(p)) << pins;
        }
        EXPECT_NE(x, start.x) << pins;
    }
}

TEST(Simulation, MovesTheClothWithTheWindOnly) {
    const std::vector<std::string> settings{"ball.position=0,-9,0", "wind.velocity=0,0,8"};
    Simulation calm = small_simulation(settings), windy = small_simulation(settings);
    windy.apply(command::Next{"wind.on"});
    make_steps(calm, 3000), make_steps(windy, 3000);
    EXPECT_GT(windy.cloths()[0].state.x.col(2).mean(), calm.cloths()[0].state.x.col(2).mean() + 0.05);
}

TEST(Simulation, LosesAClothWithTooLargeAStepAndFreezesItsLastGoodState) {
    Simulation simulation = small_simulation({"dt=0.02", "integrator=explicit_euler"});
    int steps = 0;
    for (; simulation.report().status == Status::Ok && steps < 10'000; ++steps) simulation.step();
    ASSERT_EQ(simulation.report().status, Status::Diverged);
    EXPECT_THAT(simulation.report().error, AllOf(HasSubstr("particle "), HasSubstr("row "), HasSubstr("explicit_euler"),
                                                 HasSubstr("after step " + std::to_string(steps - 1) + " ")));
    const Cloth& cloth = simulation.cloths()[0];
    EXPECT_TRUE(cloth.state.x.allFinite() && cloth.state.v.allFinite());
    const std::uint64_t frozen = simulation.hash();
    make_steps(simulation, 10);
    EXPECT_EQ(simulation.hash(), frozen);
    EXPECT_EQ(simulation.report().step, steps - 1);

    Simulation same = small_simulation({"dt=0.02", "integrator=explicit_euler"});
    make_steps(same, steps - 1);
    EXPECT_EQ(same.hash(), frozen) << "the state before the step that failed";

    simulation.apply(command::Set{"dt=0.0009765625"});
    simulation.apply(command::Set{"integrator=symplectic_euler"});
    simulation.apply(command::Reset{});
    Simulation fresh = small_simulation();
    make_steps(simulation, 100), make_steps(fresh, 100);
    EXPECT_EQ(simulation.report().error, "");
    EXPECT_EQ(simulation.hash(), fresh.hash());
}

TEST(Simulation, DoesNotTakeALongFallForDivergence) {
    Simulation simulation = small_simulation({"cloth.pinned=none", "cloth.drag=0", "ball.position=50,0,0"});
    make_steps(simulation, 20 * 1024);
    EXPECT_EQ(simulation.report().status, Status::Ok) << simulation.report().error;
    EXPECT_NEAR(simulation.cloths()[0].state.v.col(1).mean(), -9.81 * 20, 0.5);
}

TEST(Simulation, HashesEveryBitOfClothAndBall) {
    Simulation one = small_simulation(), other = small_simulation({"ball.position=0,0.2,0.4000000000000001"});
    EXPECT_NE(one.hash(), other.hash());
    EXPECT_NE(one.hash(), small_simulation({"ball.velocity=1e-300,0,0"}).hash());
    EXPECT_NE(one.hash(), small_simulation({"cloth.origin=-0.5,0.6,1e-300"}).hash());
    EXPECT_EQ(one.hash(), small_simulation().hash());
}

TEST(Simulation, StepsSeveralClothsAsIfEachWereAlone) {
    Settings settings = small_settings();
    settings.cloths.push_back(settings.cloths[0]);
    settings.cloths[1].place = Vec3(-0.5, 0.6, 5);
    Simulation two("drop", settings), one = small_simulation();
    make_steps(two, 700), make_steps(one, 700);
    EXPECT_EQ(two.cloths()[0].state.x, one.cloths()[0].state.x);
    EXPECT_NE(two.cloths()[1].state.x, one.cloths()[0].state.x);
    EXPECT_EQ(two.report().contacts, one.report().contacts);
}

TEST(ReportFields, HaveNamesOfTheirOwnAndUnitsThatThePanelKnows) {
    const std::set<std::string_view> units{"", "1", "s", "us", "m", "m/s", "J"};
    std::set<std::string_view> names, labels;
    for (const ReportField& field : report_fields()) {
        EXPECT_TRUE(names.insert(field.name).second) << field.name;
        EXPECT_TRUE(units.contains(field.unit)) << field.name;
        if (field.label.empty()) continue;
        EXPECT_TRUE(labels.insert(field.label).second) << field.label;
        EXPECT_LE(field.label.size(), 15u) << field.label << " runs into its value";
        EXPECT_GE(field.importance, 1) << field.label;
    }
}

TEST(ReportFields, AreNeverMoreThanTheirWhole) {
    Simulation simulation = small_simulation({"search_tests=9", "leaf_cells=1"});
    int parts = 0;
    for (int step = 0; step < 1000; ++step) {
        simulation.step();
        for (const ReportField& field : report_fields()) {
            if (field.whole == nullptr) continue;
            ++parts;
            EXPECT_LE(field.read(simulation.report()), field.whole(simulation.report())) << field.name;
        }
    }
    EXPECT_GT(parts, 5000);
}

}  // namespace
}  // namespace drape
