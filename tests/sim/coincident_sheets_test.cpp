// Cloths that start in each other at distance 0: said, moved apart, and calm from then on.

#include <gmock/gmock.h>

#include "drape/sim/simulation.h"
#include "support/sanitized.h"
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

/// Two sheets in the same place.
Settings in_one_place(Plane plane) { return sheets_at({sheet(plane), sheet(plane)}); }

/// Two sheets in one plane, whose edges and particles lie between those of the other.
Settings in_one_plane(Plane plane) {
    Settings settings = sheets_at({sheet(plane), sheet(plane, {6, 9})});
    const Real aside = Real(0.013);
    settings.cloths[1].place = plane == Plane::XZ ? Vec3(aside, 0, Real(0.021)) : Vec3(aside, Real(0.021), 0);
    return settings;
}

Settings three_in_one_place(Plane plane) { return sheets_at({sheet(plane), sheet(plane), sheet(plane)}); }

struct Start {
    const char* name;
    Settings (*settings)(Plane);
};

std::int64_t crossings_of(const Simulation& simulation) { return test::SceneCrossings().count(simulation); }

Real fastest(const Simulation& simulation) {
    Real speed = 0;
    for (const Cloth& cloth : simulation.cloths()) {
        speed = std::max(speed, cloth.state.v.rowwise().norm().maxCoeff());
    }
    return speed;
}

/// Two seconds under gravity, wind and the hand.
/// @return the highest speed of any particle, but for the first 50 ms, in which the thickness is made [m/s]
Real run_disturbed(Simulation& simulation) {
    const double time = test::sanitized ? 0.3 : 2;
    Real speed = 0;
    simulation.apply(parse_command("grab 0 " + std::to_string(simulation.cloths()[0].model.grid.particles() - 1)));
    while (simulation.report().time < time) {
        if (simulation.report().step == 400) simulation.apply(parse_command("drag 0.2 -0.1 0.3"));
        if (simulation.report().step == 1600) simulation.apply(parse_command("release"));
        if (simulation.report().step == 2000) simulation.apply(parse_command("set wind.on=true"));
        simulation.step();
        if (simulation.report().status != Status::Ok) break;
        if (simulation.report().time >= 0.05) speed = std::max(speed, fastest(simulation));
        EXPECT_LT(fastest(simulation), 20) << simulation.report().time << " s";
    }
    EXPECT_EQ(simulation.report().status, Status::Ok) << simulation.report().error;
    return speed;
}

/// They touch at the start, which is said, and are soon as calm as others that start a thickness apart.
void expect_calm_as(Simulation& touching, Simulation& apart) {
    EXPECT_THAT(touching.step_warning(), HasSubstr("cloth touches cloth at distance 0"));
    EXPECT_EQ(apart.step_warning(), "");
    const Real speed = run_disturbed(touching), speed_apart = run_disturbed(apart);
    EXPECT_LT(speed, 1.5 * speed_apart);
    EXPECT_EQ(crossings_of(touching), 0);
}

class CoincidentSheets : public testing::TestWithParam<std::tuple<Start, Plane>> {};

const auto name_of_start = [](const auto& param) {
    return std::get<0>(param.param).name + std::string(std::get<1>(param.param) == Plane::XZ ? "_lying" : "_hanging");
};
INSTANTIATE_TEST_SUITE_P(One, CoincidentSheets,
                         testing::Values(std::tuple(Start{"in_one_place", in_one_place}, Plane::XZ)), name_of_start);
INSTANTIATE_TEST_SUITE_P(Nightly, CoincidentSheets,
                         testing::Combine(testing::Values(Start{"in_one_place", in_one_place},
                                                          Start{"in_one_plane", in_one_plane},
                                                          Start{"three_in_one_place", three_in_one_place}),
                                          testing::Values(Plane::XZ, Plane::XY)),
                         name_of_start);

TEST_P(CoincidentSheets, AreSaidMovedApartAndCalm) {
    const auto& [start, plane] = GetParam();
    Settings settings = start.settings(plane);
    Simulation simulation(start.name, settings);
    EXPECT_THAT(simulation.step_warning(), testing::Not(HasSubstr("crosses")));
    for (std::size_t c = 0; c < settings.cloths.size(); ++c) {
        settings.cloths[c].place[plane == Plane::XZ ? 1 : 2] += static_cast<Real>(c) * room;
    }
    Simulation apart("apart", settings);
    expect_calm_as(simulation, apart);
}

/// A sheet that is folded in the middle.
/// @param turn about the z axis [rad]
/// @param gap between the halves, which are in one place without it [m]
StartState folded_state(const ClothParameters& cloth, Real turn, Real gap) {
    StartState start{0, {make_rest_state(cloth)}};
    const auto [nx, ny] = cloth.particles;
    const Real hx = cloth.width / static_cast<Real>(nx - 1), hy = cloth.height / static_cast<Real>(ny - 1);
    for (int p = 0; p < nx * ny; ++p) {
        const Real along = static_cast<Real>(std::abs(p % nx - nx / 2)) * hx, z = static_cast<Real>(p / nx) * hy;
        const Real up = p % nx < nx / 2 ? gap : Real(0);
        start.states[0].x.row(p) << along * std::cos(turn) - up * std::sin(turn),
            along * std::sin(turn) + up * std::cos(turn), z;
    }
    return start;
}

TEST(CoincidentFold, IsSaidMovedApartAndCalm) {
    for (const Real turn : {Real(0), Real(0.7), Real(-1.2)}) {
        SCOPED_TRACE(turn);
        Settings settings = sheets_at({sheet(Plane::XZ)});
        settings.cloths[0].pinned.kind = Pins::Kind::None;
        settings.cloths[0].bend.stiffness = 5;
        Simulation simulation("fold", settings, folded_state(settings.cloths[0], turn, 0));
        Simulation apart("fold", settings, folded_state(settings.cloths[0], turn, room));
        expect_calm_as(simulation, apart);
    }
}

// Of such a narrow cloth, a diagonal's particles are as far apart in number as those along a row
TEST(CoincidentCloths, MayBeOneCellWide) {
    for (const Grid grid : {Grid{2, 2}, Grid{2, 6}, Grid{6, 2}}) {
        Settings settings = sheets_at({sheet(Plane::XZ, grid), sheet(Plane::XZ, grid)});
        Simulation simulation("narrow", settings);
        EXPECT_THAT(simulation.step_warning(), HasSubstr("cloth touches cloth at distance 0"));
        run_disturbed(simulation);
        EXPECT_EQ(crossings_of(simulation), 0) << grid.nx << " x " << grid.ny;
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

/// Its lower edge, or a corner, in the plane of the other sheet.
TEST(TouchingSheets, StayOnTheSideWhereTheyAre) {
    for (const Real side : {Real(1), Real(-1)}) {
        Settings settings = sheets_at({sheet(Plane::XZ), sheet(Plane::XY, {7, 7})});
        settings.cloths[0].pinned.kind = Pins::Kind::Border;
        settings.cloths[1].pinned.kind = Pins::Kind::None;
        settings.cloths[1].width = settings.cloths[1].height = Real(0.3);
        settings.cloths[1].place = {Real(0.01), side * Real(0.15), Real(0.017)};
        Simulation simulation("touch", settings);
        EXPECT_THAT(simulation.step_warning(), HasSubstr("cloth touches cloth at distance 0"));
        for (int step = 0; step < 100; ++step) simulation.step();
        EXPECT_EQ(crossings_of(simulation), 0);
        const Real middle = simulation.cloths()[1].state.x.col(1).mean();
        EXPECT_GT(side * middle, 0.1);
    }
}

}  // namespace
}  // namespace drape
