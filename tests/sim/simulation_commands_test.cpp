#include <gmock/gmock.h>

#include <algorithm>
#include <tuple>

#include "drape/bounds/node_view.h"
#include "drape/integrate/stability.h"
#include "drape/model/forces.h"
#include "sim/small_scene.h"
#include "support/input_errors.h"

namespace drape {
namespace {

using test::input_error_of;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(ResetCommand, StartsAgainWithTheSettingsOfNow) {
    Simulation simulation = small_simulation(), fresh = small_simulation({"friction=0.9"});
    make_steps(simulation, 200);
    send(simulation, "grab 0 75");
    send(simulation, "steer 1 0 0");
    send(simulation, "set friction=0.9");
    make_steps(simulation, 20);
    send(simulation, "reset");
    EXPECT_EQ(simulation.report().step, 0);
    EXPECT_FALSE(simulation.view().held);
    make_steps(simulation, 300), make_steps(fresh, 300);
    EXPECT_EQ(simulation.hash(), fresh.hash());
}

TEST(SceneCommand, LoadsAnotherSceneAndKeepsThisOneIfThereIsNone) {
    Simulation simulation = small_simulation();
    make_steps(simulation, 10);
    const std::uint64_t hash = simulation.hash();
    EXPECT_THROW(send(simulation, "scene no_such_scene"), InputError);
    EXPECT_EQ(simulation.hash(), hash);
    EXPECT_EQ(simulation.scene(), "drop");
    send(simulation, "scene hang");
    EXPECT_EQ(simulation.scene(), "hang");
    EXPECT_EQ(simulation.settings().title, load_scene("hang").title);
    EXPECT_EQ(simulation.cloths()[0].model.grid, load_scene("hang").cloths[0].particles);
    EXPECT_TRUE(simulation.balls().empty());
    EXPECT_EQ(simulation.report().step, 0);
    make_steps(simulation, 5);
    Simulation fresh("hang", load_scene("hang"));
    make_steps(fresh, 5);
    EXPECT_EQ(simulation.hash(), fresh.hash());
}

/// Past the finest level all are shown; however often the key was pressed there, one press leads back.
TEST(AddCommand, GoesNoFurtherPastTheFinestLevelThanOne) {
    Simulation simulation = small_simulation({"leaf_cells=2"});
    const int levels = simulation.view().cloths[0].hierarchy->levels();
    ASSERT_GT(levels, 1);
    for (int press = 0; press < 40; ++press) send(simulation, "add view.level 1");
    EXPECT_GE(simulation.settings().view.level, levels);
    send(simulation, "add view.level -1");
    EXPECT_EQ(simulation.settings().view.level, levels - 1);
}

/// Without a step in between, and marked by the queries.
TEST(SetCommand, ShowsTheNewHierarchyAtOnce) {
    for (const char* change : {"set volume=obb", "set leaf_cells=3", "set sphere_fit=welzl", "set update=merge"}) {
        Simulation simulation = small_simulation({"view.bounds=true", "leaf_cells=2"});
        make_steps(simulation, 400);
        send(simulation, "pause");
        send(simulation, change);
        const ClothView cloth = simulation.view().cloths[0];
        const auto expected = make_broad_phase(broad_phase_of(simulation.settings()), cloth.model.grid);
        expected->build(cloth.x);
        std::vector<NodeView> shown, nodes;
        cloth.hierarchy->nodes_at(cloth.hierarchy->levels() - 1, shown);
        expected->nodes_at(expected->levels() - 1, nodes);
        ASSERT_EQ(shown.size(), nodes.size()) << change;
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            const auto middle = [](const auto& volume) { return volume.sphere().centre; };
            ASSERT_EQ(shown[n].volume.index(), nodes[n].volume.index()) << change;
            EXPECT_EQ(std::visit(middle, shown[n].volume), std::visit(middle, nodes[n].volume)) << change;
        }
        EXPECT_TRUE(std::ranges::any_of(shown, [](const NodeView& node) { return node.visit != NodeVisit::Unvisited; }))
            << change;
    }
}

/// Of the small scene in whose middle a command is given. @return its bits in the end
std::uint64_t hash_after(const char* change) {
    Simulation simulation = small_simulation();
    make_steps(simulation, 400);
    const std::uint64_t hash = simulation.hash();
    send(simulation, change);
    EXPECT_EQ(simulation.hash(), hash) << change << " keeps the state";
    make_steps(simulation, 400);
    EXPECT_EQ(simulation.report().step, 800) << change;
    EXPECT_EQ(simulation.report().status, Status::Ok) << change;
    return simulation.hash();
}

TEST(SetCommand, ChangesWhatFollows) {
    const std::uint64_t untouched = hash_after("release");
    for (const char* change : {"set integrator=rk4", "set friction=0", "set restitution=0.5", "set thickness=0.01",
                               "set cloth.structural.stiffness=300", "set cloth.shear.damping=0.01",
                               "set cloth.bend.stiffness=5", "set cloth.mass=0.3", "set cloth.drag=0.01",
                               "set cloth.pinned=none", "next wind.on", "set dt=0.0001", "add ball.radius 0.05"}) {
        EXPECT_NE(hash_after(change), untouched) << change;
    }
    for (const char* change : {"next volume", "set volume=brute", "set leaf_cells=2", "set title=x", "next view.bounds",
                               "set view.level=1", "set on_unstable=stop", "set needs.horizon=1", "set wind.gust=1"}) {
        EXPECT_EQ(hash_after(change), untouched) << change;
    }
}

TEST(SetCommand, StartsAgainWhenTheClothIsAnother) {
    for (const char* change : {"set cloth.particles=12,9", "set cloth.size=2,1", "set cloth.plane=xy",
                               "set cloth.origin=0,1,0", "set cloth.centre=0,1,0"}) {
        Simulation simulation = small_simulation();
        make_steps(simulation, 50);
        send(simulation, change);
        EXPECT_EQ(simulation.report().step, 0) << change;
        EXPECT_EQ(simulation.cloths()[0].state.v.norm(), 0) << change;
        make_steps(simulation, 50);
        EXPECT_EQ(simulation.view().report->status, Status::Ok) << change;
    }
}

TEST(SetCommand, ThatIsRefusedChangesNothing) {
    Simulation simulation = small_simulation();
    make_steps(simulation, 100);
    const std::uint64_t hash = simulation.hash();
    for (const char* bad : {"set dt=5", "set dt=nan", "set nothing=1", "set cloth.pinned=80", "set ball.motion=path",
                            "set cloth.particles=1,5", "next dt", "next ball[3].motion", "add title 1", "add dt nan"}) {
        EXPECT_THROW(send(simulation, bad), InputError) << bad;
    }
    EXPECT_EQ(simulation.hash(), hash);
    EXPECT_EQ(simulation.report().step, 100);
    EXPECT_EQ(simulation.settings().solver.dt, small_settings().solver.dt);
}

TEST(SteerCommand, BringsTheBallToItsSpeedAndLetsItStop) {
    Simulation simulation = small_simulation({"ball.position=0,-5,0", "ball.speed=2"});
    send(simulation, "steer 30 0 0");
    make_steps(simulation, 1024);
    EXPECT_NEAR(simulation.balls()[0].velocity[0], 2, 1e-4);
    EXPECT_NEAR(simulation.balls()[0].centre[0], 2 - 2 * 0.08, 0.01) << "but for the lag";
    send(simulation, "steer 0 0 0");
    make_steps(simulation, 1024);
    EXPECT_NEAR(simulation.balls()[0].velocity.norm(), 0, 1e-4);
    EXPECT_NEAR(simulation.balls()[0].centre[0], 2, 0.01);
}

TEST(Hand, DragsAParticleToItsTargetAndHoldsItThere) {
    Simulation simulation = small_simulation();
    make_steps(simulation, 500);
    const Vec3 before = position_of(simulation, 75), target = before + Vec3(0.05, 0.15, -0.1);
    send(simulation, "grab 0 75");
    EXPECT_TRUE(simulation.view().held);
    make_steps(simulation, 50);
    EXPECT_LT((position_of(simulation, 75) - before).norm(), 1e-9) << "held where it was taken";
    simulation.apply(command::Drag{target});
    make_steps(simulation, 500);
    EXPECT_LT((position_of(simulation, 75) - target).norm(), 1e-3);
    send(simulation, "set cloth.mass=0.2");
    make_steps(simulation, 100);
    EXPECT_LT((position_of(simulation, 75) - target).norm(), 1e-3) << "held through a change of the cloth";
    send(simulation, "release");
    EXPECT_FALSE(simulation.view().held);
    make_steps(simulation, 200);
    EXPECT_GT((position_of(simulation, 75) - target).norm(), 0.01);
    EXPECT_EQ(simulation.report().status, Status::Ok);
}

TEST(Hand, IsNeverFasterThanAHand) {
    Simulation simulation = small_simulation({"structural.stiffness=1", "shear.stiffness=1"});
    send(simulation, "grab 0 75");
    send(simulation, "drag 1e9 0 0");
    make_steps(simulation, 5);
    EXPECT_NEAR(simulation.cloths()[0].state.v.row(75).norm(), 3, 1e-9);
}

TEST(Hand, LeavesAPinWhereItPutIt) {
    Simulation simulation = small_simulation();
    send(simulation, "grab 0 0");
    send(simulation, "drag -0.4 0.6 0");
    make_steps(simulation, 300);
    send(simulation, "release");
    const Vec3 place = position_of(simulation, 0);
    EXPECT_LT((place - Vec3(-0.4, 0.6, 0)).norm(), 1e-3);
    make_steps(simulation, 100);
    EXPECT_EQ(position_of(simulation, 0), place);
    EXPECT_TRUE(simulation.cloths()[0].model.pinned(0));
}

TEST(Hand, LetsGoOfOneParticleToTakeAnother) {
    Simulation simulation = small_simulation();
    send(simulation, "grab 0 75");
    send(simulation, "grab 0 70");
    EXPECT_FALSE(simulation.cloths()[0].model.pinned(75));
    EXPECT_TRUE(simulation.cloths()[0].model.pinned(70));
    send(simulation, "release");
    send(simulation, "release");
    send(simulation, "drag 1 1 1");
    EXPECT_FALSE(simulation.cloths()[0].model.pinned(70));
}

/// What springs and gravity pull a particle by, of the cloth's weight.
Real pull_on(const Simulation& simulation, int particle) {
    const auto& [model, state] = std::tie(simulation.cloths()[0].model, simulation.cloths()[0].state);
    const Real weight = Real(80) * model.particle_mass * model.gravity.norm();
    return force_on(model, state.x, state.v, particle).norm() / weight;
}

/// Drags a particle ten metres away from where it is, and waits until the cloth is taut.
void drag_far(Simulation& simulation, int particle) {
    send(simulation, "grab 0 " + std::to_string(particle));
    simulation.apply(command::Drag{position_of(simulation, particle) + Vec3(3, -6, 8)});
    run_until(simulation, simulation.report().time + 2);
}

class HandUnderAMethod : public testing::TestWithParam<IntegratorKind> {};

INSTANTIATE_TEST_SUITE_P(One, HandUnderAMethod, testing::Values(IntegratorKind::BackwardEuler));
INSTANTIATE_TEST_SUITE_P(Nightly, HandUnderAMethod, testing::ValuesIn(methods_but({})), name_of_param);

TEST_P(HandUnderAMethod, PullsByABoundedForceAtShortAndLongSteps) {
    const IntegratorKind kind = GetParam();
    const bool any_step = !has_step_limit(kind) && kind != IntegratorKind::DormandPrince;
    for (const char* dt : {"5e-4", "0.0166667", "0.1"}) {
        const bool heats = kind == IntegratorKind::ImplicitMidpoint && dt == std::string("0.1");  // whatever moves it
        if (heats || (!any_step && dt[0] == '0')) continue;
        Simulation simulation =
            small_simulation({"solver.integrator=" + name_of(kind), std::string("dt=") + dt, "ball.position=0,-9,0",
                              "plane=xy", "drag=0.005", "structural.damping=0.2", "iterations=50"});
        drag_far(simulation, 75);
        EXPECT_LT(pull_on(simulation, 75), Real(3.3)) << dt;
        EXPECT_LT(simulation.view().report->stretch, 0.25) << dt;
        EXPECT_EQ(simulation.report().energy_gain_step, 0) << dt;
    }
}

TEST(Hand, DrawsAClothTautByThreeTimesItsWeight) {
    Simulation simulation = small_simulation({"ball.position=0,-9,0", "drag=0.005"});
    drag_far(simulation, 75);
    EXPECT_NEAR(pull_on(simulation, 75), 3, 0.1);
    EXPECT_LT(simulation.cloths()[0].state.v.row(75).norm(), 0.05) << "m/s: it is at rest";
}

TEST(Hand, StretchesNothingBeyondTheLimit) {
    for (const int particle : {75, 0}) {
        Simulation simulation = small_simulation(
            {"structural.stiffness=20", "shear.stiffness=5", "ball.position=0,-9,0", "cloth.stretch_limit=0.1"});
        send(simulation, "grab 0 " + std::to_string(particle));
        send(simulation, "drag 3 -6 8");
        double largest = 0;
        for (int step = 0; step < 3000; ++step) {
            simulation.step();
            largest = std::max(largest, simulation.view().report->stretch);
        }
        EXPECT_GT(largest, 0.1);
        EXPECT_LT(largest, 0.105) << particle;
        EXPECT_THAT(simulation.run_warning(), IsEmpty());
    }
}

}  // namespace
}  // namespace drape
