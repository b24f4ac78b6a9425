// Cloths that start in each other at distance 0, which is said, and sheets that come to rest on each other.

#include <gmock/gmock.h>

#include "drape/sim/simulation.h"
#include "support/scene_crossings.h"

namespace drape {
namespace {

using testing::HasSubstr;

constexpr Real room = Real(0.005);

Settings sheets_at(const std::vector<ClothParameters>& cloths) {
    Settings settings;
    settings.cloths = cloths;
    settings.balls.clear();
    settings.contact.self = true;
    settings.contact.thickness = room;
    settings.solver.integrator = IntegratorKind::SymplecticEuler;
    settings.solver.dt = 5e-4;
    settings.ground = {.height = Real(-0.6)};
    return settings;
}

ClothParameters sheet(Plane plane, Grid grid = {7, 7}) {
    ClothParameters cloth;
    cloth.particles = grid;
    cloth.width = cloth.height = Real(0.5);
    cloth.plane = plane;
    cloth.centred = true;
    cloth.pinned.kind = Pins::Kind::Row;
    return cloth;
}

std::int64_t crossings_of(const Simulation& simulation) { return test::SceneCrossings().count(simulation.cloths()); }

/// Sheets in one place, and one whose lower edge is in the plane of another.
TEST(CoincidentCloths, AreSaidAndRunOn) {
    ClothParameters hanging = sheet(Plane::XY);
    hanging.place = {Real(0.01), hanging.height / 2, Real(0.017)};
    for (const ClothParameters& second : {sheet(Plane::XZ), sheet(Plane::XZ, {6, 9}), hanging}) {
        Simulation simulation("touching", sheets_at({sheet(Plane::XZ), second}));
        EXPECT_THAT(simulation.step_warning(), HasSubstr("cloth touches cloth at distance 0"));
        for (int step = 0; step < 200; ++step) simulation.step();
        EXPECT_EQ(simulation.report().status, Status::Ok) << simulation.report().error;
    }
}

// Every cell is in one place with every other: a list of all such pairs would not fit
TEST(CoincidentCloths, MayHaveAllTheirCellsInOnePlace) {
    Settings settings = sheets_at({sheet(Plane::XZ, {24, 24})});
    settings.cloths[0].pinned.kind = Pins::Kind::None;
    StartState start{0, {make_rest_state(settings.cloths[0])}};
    start.states[0].x.rowwise() = Vec3(Real(0.1), Real(0.2), Real(0.3)).transpose();
    const Simulation simulation("speck", settings, start);
    EXPECT_THAT(simulation.step_warning(), HasSubstr("cloth touches cloth at distance 0"));
}

/// Parallel, one above the other.
TEST(SheetsOnSheets, ComeToRestAThicknessApart) {
    Settings settings = sheets_at({sheet(Plane::XZ), sheet(Plane::XZ, {6, 8}), sheet(Plane::XZ)});
    settings.ground.height = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        settings.cloths[c].pinned.kind = Pins::Kind::None;
        settings.cloths[c].place = {Real(0.01) * static_cast<Real>(c), Real(0.01) * static_cast<Real>(c + 1), 0};
    }
    Simulation simulation("layers", settings);
    while (simulation.report().time < 5 && !simulation.report().asleep) simulation.step();
    EXPECT_TRUE(simulation.report().asleep);
    EXPECT_EQ(crossings_of(simulation), 0);
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(simulation.cloths()[c].state.x.col(1).mean(), room * static_cast<Real>(c + 1), Real(0.1) * room);
    }
}

}  // namespace
}  // namespace drape
