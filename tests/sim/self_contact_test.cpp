// Cloth against itself and against other cloths, in whole scenes: an exact count of crossings is zero all along.

#include <gmock/gmock.h>

#include "drape/integrate/stability.h"
#include "sim/small_scene.h"
#include "support/sanitized.h"
#include "support/scene_crossings.h"

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

ClothParameters sheet_at(const Vec3& centre, Real side, int particles) {
    ClothParameters cloth;
    cloth.particles = {particles, particles};
    cloth.width = cloth.height = side;
    cloth.centred = true;
    cloth.place = centre;
    return cloth;
}

/// Three sheets that fall on a ball at the origin, which stays there, one onto the other.
Settings stacked_sheets() {
    Settings settings = base_settings();
    BallSettings& ball = settings.balls.emplace_back();
    ball.radius = Real(0.2);
    ball.motion = BallMotion::Still;
    settings.ground.height = -1;
    for (const Vec3& centre : {Vec3(0, Real(0.24), 0), Vec3(Real(0.03), Real(0.27), Real(0.02)),
                               Vec3(Real(-0.02), Real(0.30), Real(-0.04))}) {
        settings.cloths.push_back(sheet_at(centre, Real(0.6), 9));
    }
    return settings;
}

std::int64_t crossings_in(const Simulation& simulation) { return test::SceneCrossings().count(simulation.cloths()); }

struct Tally {
    std::int64_t crossings = 0, pairs = 0;
};

/// @param looks steps from one exact count to the next
Tally run(Settings settings, double time, std::int64_t looks) {
    Simulation simulation("self contact", std::move(settings));
    Tally tally;
    run_until(simulation, time, [&] {
        tally.pairs += simulation.report().pairs;
        if (simulation.report().step % looks == 0) tally.crossings += crossings_in(simulation);
    });
    EXPECT_TRUE(only_few_rounds(simulation.run_warning())) << simulation.run_warning();
    return tally;
}

class SelfContactMethod : public testing::TestWithParam<std::tuple<IntegratorKind, ResponseKind>> {};

INSTANTIATE_TEST_SUITE_P(OneMethod, SelfContactMethod,
                         testing::Values(std::tuple(IntegratorKind::BackwardEuler, ResponseKind::Projection)),
                         name_of_param);

/// Each integrator that is stable there, and each response to the ball.
INSTANTIATE_TEST_SUITE_P(
    Nightly, SelfContactMethod,
    testing::Combine(testing::ValuesIn(methods_but({IntegratorKind::ExplicitEuler, IntegratorKind::Rk4,
                                                    IntegratorKind::DormandPrince})),
                     testing::Values(ResponseKind::Projection, ResponseKind::Penalty, ResponseKind::Impulse)),
    name_of_param);

TEST_P(SelfContactMethod, NeverHasACrossing) {
    Settings settings = stacked_sheets();
    std::tie(settings.solver.integrator, settings.contact.response) = GetParam();
    settings.solver.dt = has_step_limit(settings.solver.integrator) ? 5e-4 : 1.0 / 120;
    // Steps of explicit methods are many
    const std::int64_t looks = has_step_limit(settings.solver.integrator) ? 20 : 1;
    const Tally tally = run(std::move(settings), test::sanitized ? 0.3 : 0.7, looks);
    EXPECT_EQ(tally.crossings, 0);
    EXPECT_GT(tally.pairs, 100) << "cloth has touched cloth";
}

class ShippedSelfContact : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Long, ShippedSelfContact, testing::Values("fold", "stack", "pinch", "twist"), name_of_param);

TEST_P(ShippedSelfContact, NeverHasACrossing) {
    Settings settings = load_scene(GetParam());
    const bool is_late = GetParam() == "pinch" || GetParam() == "twist";
    const double time = is_late ? 2.6 : test::sanitized ? 0.45 : 0.6;
    const Tally tally = run(std::move(settings), time, is_late ? 400 : 100);
    EXPECT_EQ(tally.crossings, 0);
    EXPECT_GT(tally.pairs, 100) << "cloth has touched cloth";
}

TEST(SelfContact, ChangesNoBitWhereNothingComesNear) {
    // A sheet in free fall moves fast, but as a whole
    const auto hash_of = [](bool self) {
        Settings settings = base_settings();
        settings.contact.self = self;
        settings.solver.integrator = IntegratorKind::BackwardEuler;
        settings.solver.dt = 1.0 / 60;
        settings.ground.solid = false;
        settings.cloths.emplace_back();
        Simulation simulation("fall", std::move(settings));
        for (int step = 0; step < 120; ++step) simulation.step();
        EXPECT_EQ(simulation.report().substeps, 1);
        return simulation.hash();
    };
    EXPECT_EQ(hash_of(true), hash_of(false));
}

TEST(SelfContact, HoldsNothingOnceItIsOffOrTheClothIsThinner) {
    for (const char* change : {"set contact.self=false", "set contact.thickness=0.0001"}) {
        Simulation simulation("stack", stacked_sheets());
        run_until(simulation, 0.4);
        EXPECT_GT(simulation.report().pairs, 0);
        send(simulation, change);
        simulation.step();
        const bool is_off = std::string(change).ends_with("false");
        for (const ContactRow& row : simulation.contacts()) {
            EXPECT_FALSE(row.kind == RowKind::Pair && (is_off || row.distance > Real(0.001))) << change;
        }
    }
}

/// A ball that presses three sheets onto the ground, and leaves them no room.
Settings pressed_sheets() {
    Settings settings = stacked_sheets();
    settings.ground.height = 0;
    settings.balls[0].motion = BallMotion::Path;
    settings.balls[0].path = {{0, {0, Real(0.3), 0}}, {Real(0.15), {0, Real(0.203), 0}}, {1, {0, Real(0.203), 0}}};
    for (std::size_t c = 0; c < 3; ++c) settings.cloths[c].place = {0, Real(0.012) * static_cast<Real>(c + 1), 0};
    return settings;
}

TEST(LongSelfContact, HasNoCrossingWhereSheetsHaveNoRoom) {
    Simulation simulation("pressed", pressed_sheets());
    std::int64_t held_back = 0;
    while (simulation.report().time < (test::sanitized ? 0.2 : 0.3)) {
        simulation.step();
        if (simulation.report().status != Status::Ok) break;
        held_back += simulation.report().failsafe_particles;
        if (simulation.report().step % 10 == 0) {
            ASSERT_EQ(crossings_in(simulation), 0) << simulation.report().time << " s";
        }
    }
    EXPECT_GT(held_back, 0);
}

TEST(SelfContact, LeavesPinsWhereTheyAreWhateverTheHandPulls) {
    Settings settings = base_settings();
    settings.ground.solid = false;
    for (const Real height : {Real(0), Real(0.03)}) {
        settings.cloths.push_back(sheet_at({0, height, 0}, Real(0.2), 3));
        if (height == 0) settings.cloths[0].pinned = {Pins::Kind::List, {0, 1, 2, 3, 5, 6, 7, 8}};
    }
    Simulation simulation("pins", std::move(settings));
    const Points before = simulation.cloths()[0].state.x;
    simulation.apply(parse_command("grab 1 4"));
    simulation.apply(parse_command("drag 0.02 -0.4 0.03"));
    run_until(simulation, 0.5);
    for (const int pin : {0, 1, 2, 3, 5, 6, 7, 8}) {
        EXPECT_EQ(simulation.cloths()[0].state.x.row(pin), before.row(pin)) << pin;
    }
    EXPECT_EQ(crossings_in(simulation), 0);
}

TEST(SelfContact, EndsTheRunWhereTooMuchIsNear) {
    Settings settings = base_settings();
    for (int k = 0; k < 64; ++k) {
        ClothParameters cloth;
        cloth.particles = {6, 6};
        cloth.width = cloth.height = Real(0.1);
        cloth.place = {0, Real(1e-4) * static_cast<Real>(k), 0};
        settings.cloths.push_back(cloth);
    }
    Simulation simulation("layers", std::move(settings));
    simulation.step();
    EXPECT_EQ(simulation.report().status, Status::Diverged);
    EXPECT_THAT(simulation.report().error, testing::HasSubstr("contact.self"));
}

TEST(SelfContact, IsRefusedWhereClothWouldKeepNextToNothingApart) {
    Settings settings = stacked_sheets();
    settings.contact.thickness = Real(1e-5);
    EXPECT_THROW(check(settings), InconsistentSettings);
}

/// Nothing parts cloths that have crossed, but nothing throws them apart either.
TEST(SelfContact, GoesOnCalmlyWithSheetsThatStartCrossed) {
    for (const IntegratorKind method : {IntegratorKind::SymplecticEuler, IntegratorKind::BackwardEuler}) {
        Settings settings = stacked_sheets();
        settings.cloths.pop_back();
        settings.balls.clear();
        for (ClothParameters& cloth : settings.cloths) cloth.particles = {17, 17};
        settings.cloths[1].plane = Plane::XY;
        settings.cloths[1].place = settings.cloths[0].place + Vec3(Real(0.013), Real(0.02), Real(0.011));
        settings.contact.thickness = Real(0.004);
        settings.solver.integrator = method;
        settings.solver.dt = 2.5e-4;
        Simulation simulation("crossed", std::move(settings));
        EXPECT_THAT(simulation.step_warning(), testing::HasSubstr("at the start"));
        run_until(simulation, 0.4, [&] {
            for (const Cloth& cloth : simulation.cloths()) {
                ASSERT_LT(cloth.state.v.rowwise().norm().maxCoeff(), 5) << simulation.report().time << " s";
            }
        });
        EXPECT_EQ(simulation.report().energy_gain_step, 0);
    }
}

}  // namespace
}  // namespace drape
