#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drape/contact/response.h"
#include "drape/contact/warm_start.h"
#include "drape/integrate/integrator.h"
#include "drape/integrate/stability.h"

namespace drape {
namespace {

/// A sheet of 6 x 6 particles over a solid ground at y = 0, and balls; no thickness, no drag.
struct SheetOnGround {
    ClothModel model;
    ClothState state;
    Points before;
    ResponseParameters parameters{.friction = 0, .restitution = 0, .thickness = 0, .ground = {.height = 0}};
    std::vector<Ball> balls;
    std::vector<Contact> contacts;
    std::vector<BallContact> ball_contacts;
    std::vector<CellRun> cells;
    WarmStart<Contact> warm_start;
    ResponseReport report;

    explicit SheetOnGround(Real height, SpringLaw springs = {}, Real side = Real(0.25)) {
        ClothParameters cloth;
        cloth.particles = {6, 6};
        cloth.width = cloth.height = side;
        cloth.centred = true;
        cloth.place = {0, height, 0};
        cloth.drag = 0;
        cloth.structural = cloth.shear = cloth.bend = springs;
        model = make_cloth_model(cloth);
        state = make_rest_state(cloth);
        list_all_cells(model.grid, cells);
        contacts.reserve(1000);
    }

    ClothInContact in_contact() { return {model, before, state, contacts}; }

    /// Contacts and their response, as a step has them.
    void respond(Real h) {
        contacts.clear();
        for (std::size_t b = 0; b < balls.size(); ++b) {
            find_contacts(model.grid, state.x, balls[b], static_cast<int>(b), parameters.thickness, cells, contacts,
                          Kernels::Vector);
        }
        if (parameters.ground.solid) {
            find_ground_contacts(model.grid, state.x, parameters.ground.height, parameters.thickness, contacts);
        }
        find_ball_contacts(balls, parameters.ground, ball_contacts);
        const ClothInContact sheet = in_contact();
        warm_start.carry_over(parameters, std::span(&sheet, 1), balls, contacts);
        report = resolve_contacts(parameters, h, std::span(&sheet, 1), {}, balls, ball_contacts, nullptr);
    }

    /// @param visit after each step, with its number
    template <class Visit>
    void run(IntegratorKind kind, Real h, Real time, Visit visit) {
        const auto integrator = make_integrator({.kind = kind}, model.grid);
        parameters.integrator = kind;
        const int steps = static_cast<int>(std::llround(time / h));
        for (int step = 1; step <= steps; ++step) {
            before = state.x;
            for (Ball& ball : balls) {
                if (ball.inverse_mass > 0) ball.velocity += h * model.gravity;
                ball.moved = h * ball.velocity;
                ball.turned = h * ball.spin;
                ball.centre += ball.moved;
            }
            const ClothInContact sheet = in_contact();
            warm_start.take(parameters, h, model.gravity.norm(), std::span(&sheet, 1), contacts);
            warm_start.before_step(std::span(&sheet, 1), balls);
            integrator->step(model, state, h, nullptr);
            warm_start.after_step(std::span(&sheet, 1), balls);
            respond(h);
            visit(step);
        }
    }
};

constexpr ResponseKind kinds[] = {ResponseKind::Projection, ResponseKind::Penalty, ResponseKind::Impulse,
                                  ResponseKind::Hybrid};

class EachResponse : public testing::TestWithParam<ResponseKind> {};

INSTANTIATE_TEST_SUITE_P(Kinds, EachResponse, testing::ValuesIn(kinds),
                         [](const auto& param) { return std::string(name_of(param.param)); });

// A fall of 0.5 m takes sqrt(2 H / g) = 0.319275428 s, and the n-th bounce comes to e^2n H
TEST_P(EachResponse, BouncesToTheHeightThatTheRestitutionLeaves) {
    constexpr Real height = Real(0.5), restitution = Real(0.6), h = Real(1e-4);
    SheetOnGround sheet(height);
    sheet.parameters.kind = GetParam();
    sheet.parameters.ground.restitution = restitution;
    sheet.parameters.stiffness = Real(2e4);
    Real touched = 0;
    std::vector<Real> peaks;
    Real last = height, speed = 0;
    sheet.run(IntegratorKind::VelocityVerlet, h, Real(1.2), [&](int step) {
        const Real y = sheet.state.x.col(1).mean(), now = y - last;
        if (touched == 0 && !sheet.contacts.empty()) touched = static_cast<Real>(step) * h;
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

TEST_P(EachResponse, KeepsTheMomentumOfBallAndClothTogether) {
    SheetOnGround sheet(Real(0.4), {200, Real(0.02)});
    sheet.parameters.kind = GetParam();
    sheet.parameters.friction = Real(0.5);
    sheet.parameters.restitution = Real(0.3);
    sheet.parameters.ground.solid = false;
    sheet.model.gravity.setZero();
    Ball ball{.centre = Vec3(Real(0.03), Real(0.3), Real(0.01)), .radius = Real(0.08), .velocity = Vec3(1, 2, 0)};
    ball.inverse_mass = Real(1) / Real(0.1);
    sheet.balls.push_back(ball);
    const auto momentum = [&] {
        return Vec3(sheet.model.particle_mass * sheet.state.v.colwise().sum().transpose() +
                    sheet.balls[0].velocity / sheet.balls[0].inverse_mass);
    };
    const Vec3 before = momentum();
    bool touched = false;
    sheet.run(IntegratorKind::SymplecticEuler, Real(1e-4), Real(0.2),
              [&](int) { touched = touched || !sheet.contacts.empty(); });
    EXPECT_TRUE(touched);
    EXPECT_GT((sheet.balls[0].velocity - ball.velocity).norm(), 0.1);
    EXPECT_GT(sheet.balls[0].spin.norm(), 0.1) << "friction turns the ball";
    EXPECT_LT((momentum() - before).norm(), 1e-10 * before.norm());
}

TEST_P(EachResponse, RestsWithoutAQuiver) {
    SheetOnGround sheet(Real(0.001), {200, Real(0.02)});
    sheet.parameters.kind = GetParam();
    sheet.parameters.ground.friction = Real(0.5);
    sheet.run(IntegratorKind::SymplecticEuler, Real(1e-4), Real(1), [](int) {});
    const Points there = sheet.state.x;
    Real farthest = 0;
    sheet.run(IntegratorKind::SymplecticEuler, Real(1e-4), Real(0.5),
              [&](int) { farthest = std::max(farthest, (sheet.state.x - there).rowwise().norm().maxCoeff()); });
    EXPECT_LT(farthest, 1e-7);
}

// Gravity that is tilted by the friction angle, 2 % to either side
TEST_P(EachResponse, SticksOnASlopeUpToTheFrictionCoefficientAndSlidesBeyond) {
    constexpr Real friction = Real(0.3), h = Real(1e-4), time = Real(0.5);
    for (const Real part : {Real(0.98), Real(1.02), Real(2)}) {
        SheetOnGround sheet(0, {200, Real(0.02)});
        sheet.parameters.kind = GetParam();
        sheet.parameters.ground.friction = friction;
        const Real slope = std::atan(part * friction);
        sheet.model.gravity = Real(9.81) * Vec3(std::sin(slope), -std::cos(slope), 0);
        const Real start = sheet.state.x.col(0).mean();
        sheet.run(IntegratorKind::SymplecticEuler, h, time, [](int) {});
        const Real way = sheet.state.x.col(0).mean() - start;
        const Real acceleration = std::max(Real(9.81) * (std::sin(slope) - friction * std::cos(slope)), Real(0));
        EXPECT_NEAR(way, acceleration * time * time / 2, 0.02 * way + 2e-4) << part;
    }
}

// A point that starts at the top leaves a frictionless ball where cos(a) = 2/3 + v^2 / (3 g R), R to the point
TEST_P(EachResponse, LetsAPatchLeaveAFrictionlessBallWhereTheFormulaSays) {
    constexpr Real radius = Real(0.3), speed = Real(0.1), h = Real(1e-4);
    SheetOnGround patch(radius, {200, Real(0.02)}, Real(0.01));
    patch.parameters.kind = GetParam();
    patch.parameters.ground.solid = false;
    patch.balls.push_back({.centre = Vec3::Zero(), .radius = radius});
    patch.state.v.col(0).setConstant(speed);
    bool pushed = false;
    Real angle = 0, time = 0;
    patch.run(IntegratorKind::SymplecticEuler, h, Real(0.8), [&](int step) {
        const Vec3 middle = patch.state.x.colwise().mean().transpose();
        const bool was_pushed = pushed;
        pushed = std::ranges::any_of(patch.contacts, [](const Contact& c) { return c.impulse.normal > 0; });
        // Twice in a row: a patch that has left quivers, and may brush the ball for a single step
        if (pushed && was_pushed) angle = std::atan2(middle.x(), middle.y()), time = static_cast<Real>(step) * h;
    });
    const Real expected = std::acos(Real(2) / 3 + speed * speed / (3 * Real(9.81) * radius));
    EXPECT_NEAR(angle, expected, 0.01) << "0.01 rad, 0.6 degrees; left at " << time << " s";
}

struct StepCase {
    IntegratorKind integrator;
    Real h;
};

class FrictionAtAnyStep : public testing::TestWithParam<StepCase> {};

std::vector<StepCase> step_cases() {
    std::vector<StepCase> cases{{IntegratorKind::ExplicitEuler, Real(1e-4)}};  // diverges at 1 ms
    for (const IntegratorKind kind :
         {IntegratorKind::SymplecticEuler, IntegratorKind::VelocityVerlet, IntegratorKind::Rk4}) {
        for (const Real h : {Real(1e-4), Real(1e-3)}) cases.push_back({kind, h});
    }
    for (const IntegratorKind kind :
         {IntegratorKind::BackwardEuler, IntegratorKind::ImplicitMidpoint, IntegratorKind::Bdf2, IntegratorKind::Xpbd,
          IntegratorKind::ProjectiveDynamics, IntegratorKind::DormandPrince}) {
        for (const Real h : {Real(1e-4), Real(1e-3), Real(1) / 60}) cases.push_back({kind, h});
    }
    return cases;
}

INSTANTIATE_TEST_SUITE_P(All, FrictionAtAnyStep, testing::ValuesIn(step_cases()), [](const auto& param) {
    return std::string(name_of(param.param.integrator)) + "_" + std::to_string(static_cast<int>(param.param.h * 1e6)) +
           "us";
});

TEST_P(FrictionAtAnyStep, SticksIffTheSlopeIsBelowTheFrictionAngle) {
    constexpr Real friction = Real(0.3);
    for (const Real part : {Real(0.98), Real(1.02), Real(2)}) {
        SheetOnGround sheet(0, {50, Real(0.02)});
        sheet.parameters.ground.friction = friction;
        const Real slope = std::atan(part * friction);
        sheet.model.gravity = Real(9.81) * Vec3(std::sin(slope), -std::cos(slope), 0);
        sheet.run(GetParam().integrator, GetParam().h, Real(0.5), [](int) {});
        const Real half = sheet.state.x.col(0).mean();
        sheet.run(GetParam().integrator, GetParam().h, Real(0.5), [](int) {});
        const Real way = sheet.state.x.col(0).mean() - half;
        const Real acceleration = std::max(Real(9.81) * (std::sin(slope) - friction * std::cos(slope)), Real(0));
        // From 0.5 s to 1 s
        EXPECT_NEAR(way, acceleration * Real(0.375), 0.02 * way + 1e-6) << part;
    }
}

/// One spring that also pulls: x' = v, v' = -w^2 x - 2 zeta w v, force from the start of the step.
/// @param damping share of its velocity that the damper takes in a step
/// @return what it has grown to from 1e-4 m [m]
Real swing(Real w, Real damping, Real h) {
    Real x = Real(1e-4), v = 0;
    for (int step = 0; step < 2000; ++step) {
        v += -h * w * w * x - damping * v;
        x += h * v;
    }
    return std::abs(x) + std::abs(v) / w;
}

TEST(PenaltyStepLimit, IsWhereASwingOfTheSpringGrows) {
    constexpr Real stiffness = 1000, inverse_mass = 180;
    const Real w = std::sqrt(stiffness * inverse_mass), pi = std::acos(Real(-1));
    for (const Real restitution : {Real(1), Real(0.5), Real(0)}) {
        const Real decay = restitution > 0 ? -std::log(restitution) : 0;
        const Real zeta = restitution > 0 ? decay / std::sqrt(pi * pi + decay * decay) : 1;
        for (const Real part : {Real(0.95), Real(1.05)}) {
            const Real h = part * penalty_step_limit(stiffness, restitution, inverse_mass);
            EXPECT_EQ(swing(w, 2 * zeta * w * h, h) < 1e-3, part < 1) << restitution;
            // A damper that sees the mean of what was and what it leaves
            const Real longer = part * penalty_step_limit(stiffness, restitution, inverse_mass, Real(0.5));
            EXPECT_EQ(swing(w, 2 * zeta * w * longer / (1 + zeta * w * longer), longer) < 1e-3, part < 1)
                << restitution;
        }
    }
}

}  // namespace
}  // namespace drape
