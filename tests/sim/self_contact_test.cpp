// Cloth against itself and against other cloths, in whole scenes: an exact count of crossings is zero all along.

#include <gtest/gtest.h>

#include "drape/sim/scene.h"
#include "drape/sim/simulation.h"
#include "support/crossings.h"
#include "support/sanitized.h"

namespace drape {
namespace {

constexpr Real thickness = Real(0.01);

Settings base_settings() {
    Settings settings;
    settings.cloths.clear();
    settings.balls.clear();
    settings.contact.self = true;
    settings.contact.thickness = thickness;
    settings.solver.integrator = IntegratorKind::SymplecticEuler;
    settings.solver.dt = 5e-4;
    settings.ground.solid = true;
    return settings;
}

/// A sheet that slips off a ball, and comes to lie folded on the ground.
Settings folding_sheet() {
    Settings settings = base_settings();
    ClothParameters cloth;
    cloth.particles = {13, 13};
    cloth.width = cloth.height = Real(0.8);
    cloth.centred = true;
    cloth.place = {Real(0.17), Real(0.1), Real(0.11)};
    cloth.bend.stiffness = 2;
    settings.cloths.push_back(cloth);
    BallSettings ball;
    ball.radius = Real(0.12);
    ball.motion = BallMotion::Still;
    settings.balls.push_back(ball);
    settings.contact.friction = Real(0.6);
    settings.ground.height = -1;
    return settings;
}

/// Three sheets that fall on a ball, one onto the other.
Settings stacked_sheets() {
    Settings settings = base_settings();
    for (const Vec3& centre : {Vec3(0, Real(0.24), 0), Vec3(Real(0.03), Real(0.27), Real(0.02)),
                               Vec3(Real(-0.02), Real(0.30), Real(-0.04))}) {
        ClothParameters cloth;
        cloth.particles = {9, 9};
        cloth.width = cloth.height = Real(0.6);
        cloth.centred = true;
        cloth.place = centre;
        settings.cloths.push_back(cloth);
    }
    BallSettings ball;
    ball.radius = Real(0.2);
    ball.motion = BallMotion::Still;
    settings.balls.push_back(ball);
    settings.ground.height = -1;
    return settings;
}

std::int64_t crossings_in(const Simulation& simulation) {
    const auto& cloths = simulation.cloths();
    std::vector<CellBoxes> boxes(cloths.size());
    std::vector<BoxedCloth> boxed;
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        boxes[c].build(cloths[c].model.grid, cloths[c].state.x);
        boxed.push_back({{static_cast<int>(c), cloths[c].model.grid, cloths[c].state.x}, boxes[c]});
    }
    std::int64_t count = 0;
    for (std::size_t a = 0; a < boxed.size(); ++a) {
        for (std::size_t b = a; b < boxed.size(); ++b) count += test::crossings(boxed[a], boxed[b]);
    }
    return count;
}

struct Tally {
    std::int64_t crossings = 0, pairs = 0;
};

Tally run(Settings settings, double time) {
    Simulation simulation("self contact", std::move(settings));
    Tally tally;
    while (simulation.report().time < time) {
        simulation.step();
        EXPECT_EQ(simulation.report().status, Status::Ok) << simulation.report().trouble;
        if (simulation.report().status != Status::Ok) break;
        tally.pairs += simulation.report().pairs;
        if (simulation.report().step % 20 == 0) tally.crossings += crossings_in(simulation);
    }
    return tally;
}

/// For cloth to come onto cloth [s].
double time_of(Settings (*scene)()) { return scene == folding_sheet ? 1.8 : test::sanitized ? 0.4 : 1.0; }

class SelfContactScene : public testing::TestWithParam<Settings (*)()> {};

INSTANTIATE_TEST_SUITE_P(All, SelfContactScene, testing::Values(folding_sheet, stacked_sheets),
                         [](const auto& param) { return param.index == 0 ? "fold" : "stack"; });

TEST_P(SelfContactScene, NeverHasACrossing) {
    const Tally tally = run(GetParam()(), time_of(GetParam()));
    EXPECT_EQ(tally.crossings, 0);
    EXPECT_GT(tally.pairs, 100) << "cloth has touched cloth";
}

TEST_P(SelfContactScene, HasCrossingsWithoutTheSearch) {
    Settings settings = GetParam()();
    settings.contact.self = false;
    const Tally tally = run(std::move(settings), time_of(GetParam()));
    EXPECT_GT(tally.crossings, 100);
    EXPECT_EQ(tally.pairs, 0);
}

}  // namespace
}  // namespace drape
