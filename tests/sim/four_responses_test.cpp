#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drape/integrate/stability.h"
#include "sim/small_scene.h"

namespace drape {
namespace {

constexpr double earth_g = 9.81;

/// A sheet of 6 x 6 particles at that height over solid ground at y = 0; no thickness, no drag, no friction.
Settings sheet_at(Real height, SpringLaw springs = {}) {
    Settings settings;
    settings.balls.clear();
    ClothParameters& cloth = settings.cloths[0];
    cloth.particles = {6, 6};
    cloth.width = cloth.height = Real(0.25);
    cloth.centred = true;
    cloth.place = {0, height, 0};
    cloth.drag = 0;
    cloth.structural = cloth.shear = cloth.bend = springs;
    settings.contact.friction = settings.contact.thickness = 0;
    settings.ground = {.height = 0};
    settings.ground.friction = 0;
    settings.solver.integrator = IntegratorKind::SymplecticEuler;
    settings.solver.dt = 1e-4;
    settings.solver.sleep_speed = 0;
    return settings;
}

Vec3 centre_of(const Simulation& simulation) { return simulation.cloths()[0].state.x.colwise().mean().transpose(); }

/// How far a sheet has gone down a slope between two times.
struct Slide {
    double way = 0, expected = 0;  ///< [m]
};

/// @param part of the friction coefficient, the tangent of the slope
Slide slide_down(Settings settings, double part, double from, double to) {
    const double friction = 0.3, slope = std::atan(part * friction);
    SolidSettings& box = settings.solids.emplace_back();
    box.size = {20, 1, 20};
    box.axis = {0, 0, 1};
    box.angle = static_cast<Real>(-slope * 180 / std::acos(-1.));
    const Vec3 up(static_cast<Real>(std::sin(slope)), static_cast<Real>(std::cos(slope)), 0), down(up.y(), -up.x(), 0);
    box.position = -up / 2;
    settings.contact.friction = static_cast<Real>(friction);
    settings.ground.solid = false;
    StartState start;
    const ClothState flat = make_rest_state(settings.cloths[0]);
    ClothState& tilted = start.states.emplace_back(flat);
    tilted.x = flat.x.col(0) * down.transpose() + flat.x.col(1) * up.transpose();
    tilted.x.col(2) = flat.x.col(2);
    Simulation simulation("slope", std::move(settings), std::move(start));
    run_until(simulation, from);
    const Real before = centre_of(simulation).dot(down);
    const double began = simulation.report().time;
    run_until(simulation, to);
    const double ended = simulation.report().time;
    const double acceleration = std::max(earth_g * (std::sin(slope) - friction * std::cos(slope)), 0.);
    return {.way = static_cast<double>(centre_of(simulation).dot(down) - before),
            .expected = acceleration * (ended * ended - began * began) / 2};
}

class EachResponse : public testing::TestWithParam<ResponseKind> {};

INSTANTIATE_TEST_SUITE_P(Kinds, EachResponse, testing::ValuesIn(values_of<ResponseKind>()), name_of_param);

// A fall of 0.5 m takes sqrt(2 H / g) = 0.319275428 s, and the n-th bounce comes to e^2n H
TEST_P(EachResponse, BouncesToTheHeightThatTheRestitutionLeaves) {
    constexpr Real height = Real(0.5), restitution = Real(0.6);
    Settings settings = sheet_at(height);
    settings.contact.response = GetParam();
    settings.contact.stiffness = Real(2e4);
    settings.ground.restitution = restitution;
    settings.solver.integrator = IntegratorKind::VelocityVerlet;
    Simulation sheet("sheet", std::move(settings));
    double touched = 0;
    std::vector<Real> peaks;
    Real last = height, speed = 0;
    run_until(sheet, 1.2, [&] {
        const Real y = centre_of(sheet).y(), now = y - last;
        if (touched == 0 && sheet.report().contacts > 0) touched = sheet.report().time;
        if (touched > 0 && speed > 0 && now <= 0) peaks.push_back(last);
        speed = now;
        last = y;
    });
    EXPECT_NEAR(touched, 0.319275428, 2e-4);
    ASSERT_GE(peaks.size(), 2u);
    // A spring that pushes but does not pull lets go a little early, and leaves more speed than it should
    const Real tolerance = (GetParam() == ResponseKind::Penalty ? Real(0.04) : Real(0.02)) * height;
    EXPECT_NEAR(peaks[0], restitution * restitution * height, tolerance);
    EXPECT_NEAR(peaks[1], std::pow(restitution, Real(4)) * height, tolerance);
}

// But for the fall. Without gravity no push would be that of a contact at rest, and none would be carried on: after a
// step of symplectic Euler, and within one of velocity Verlet
TEST_P(EachResponse, KeepsTheMomentumOfBallAndClothTogether) {
    for (const IntegratorKind kind : {IntegratorKind::SymplecticEuler, IntegratorKind::VelocityVerlet}) {
        Settings settings = sheet_at(Real(0.4), {200, Real(0.02)});
        settings.contact.response = GetParam();
        settings.contact.friction = Real(0.5);
        settings.contact.restitution = Real(0.3);
        settings.ground.solid = false;
        settings.solver.integrator = kind;
        BallSettings& ball = settings.balls.emplace_back();
        ball.radius = Real(0.08);
        ball.position = {Real(0.03), Real(0.3), Real(0.01)};
        ball.velocity = {1, 2, 0};
        ball.motion = BallMotion::Free;
        ball.mass = Real(0.1);
        Simulation simulation("ball", std::move(settings));
        const Vec3 before = whole_momentum(simulation);
        bool touched = false;
        run_until(simulation, 0.2, [&] { touched = touched || simulation.report().contacts > 0; });
        EXPECT_TRUE(touched);
        EXPECT_GT((simulation.balls()[0].velocity - Vec3(1, 2, 0)).norm(), 0.1);
        EXPECT_GT(simulation.balls()[0].spin.norm(), 0.1) << "friction turns the ball";
        const Real mass = simulation.settings().cloths[0].mass + simulation.settings().balls[0].mass;
        const Vec3 fallen = static_cast<Real>(simulation.report().time) * mass * simulation.cloths()[0].model.gravity;
        EXPECT_LT((whole_momentum(simulation) - before - fallen).norm(), 1e-10 * before.norm()) << name_of(kind);
    }
}

TEST_P(EachResponse, RestsWithoutAQuiver) {
    Settings settings = sheet_at(Real(0.001), {200, Real(0.02)});
    settings.contact.response = GetParam();
    settings.ground.friction = Real(0.5);
    Simulation sheet("sheet", std::move(settings));
    run_until(sheet, 1);
    const Points there = sheet.cloths()[0].state.x;
    Real farthest = 0;
    run_until(sheet, 1.5,
              [&] { farthest = std::max(farthest, (sheet.cloths()[0].state.x - there).rowwise().norm().maxCoeff()); });
    EXPECT_LT(farthest, 1e-7);
}

// The tangent of the slope is 2 % to either side of the friction coefficient, and twice that
TEST_P(EachResponse, SticksOnASlopeUpToTheFrictionCoefficientAndSlidesBeyond) {
    for (const double part : {0.98, 1.02, 2.}) {
        Settings settings = sheet_at(0, {200, Real(0.02)});
        settings.contact.response = GetParam();
        const Slide slide = slide_down(std::move(settings), part, 0, 0.5);
        EXPECT_NEAR(slide.way, slide.expected, 0.02 * slide.expected + 2e-4) << part;
    }
}

TEST(Penalty, HoldsASheetAtLongerStepsWhereDampersSeeWhatHasMoved) {
    for (const IntegratorKind kind : {IntegratorKind::VelocityVerlet, IntegratorKind::SymplecticEuler}) {
        Settings settings = sheet_at(0);
        settings.contact.response = ResponseKind::Penalty;
        settings.contact.stiffness = 1000;
        settings.solver.integrator = kind;
        settings.solver.dt = 2.9e-3;
        Simulation sheet("sheet", std::move(settings));
        Real highest = 0;
        run_until(sheet, 3, [&] { highest = std::max(highest, centre_of(sheet).y()); });
        EXPECT_EQ(highest > Real(0.01), kind == IntegratorKind::SymplecticEuler) << highest << " m";
    }
}

class FrictionOfEachMethod : public testing::TestWithParam<IntegratorKind> {};

INSTANTIATE_TEST_SUITE_P(One, FrictionOfEachMethod, testing::Values(IntegratorKind::BackwardEuler));
INSTANTIATE_TEST_SUITE_P(Nightly, FrictionOfEachMethod, testing::ValuesIn(methods_but({})), name_of_param);

TEST_P(FrictionOfEachMethod, SticksIffTheSlopeIsBelowTheFrictionAngle) {
    for (const double part : {0.98, 1.02, 2.}) {
        Settings settings = sheet_at(0, {50, Real(0.02)});
        const IntegratorKind kind = GetParam();
        settings.solver.integrator = kind;
        // Steps without a limit are divided in contact; explicit Euler diverges at 1 ms
        settings.solver.dt = !has_step_limit(kind) ? 1. / 60 : kind == IntegratorKind::ExplicitEuler ? 1e-4 : 1e-3;
        const Slide slide = slide_down(std::move(settings), part, 0.5, 1);
        EXPECT_NEAR(slide.way, slide.expected, 0.02 * slide.expected + 1e-6) << part;
    }
}

}  // namespace
}  // namespace drape
