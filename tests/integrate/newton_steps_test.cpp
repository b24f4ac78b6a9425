#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "drape/integrate/integrator.h"
#include "drape/model/forces.h"

namespace drape {
namespace {

constexpr Real picture = Real(1) / 60;  // s

ClothParameters hung_sheet() {
    ClothParameters sheet;
    sheet.particles = {12, 12};
    sheet.mass = Real(0.2);
    sheet.pinned.kind = Pins::Kind::Two;
    return sheet;
}

/// Where a sheet is that has fallen from two corners, at the end of each of some steps.
std::vector<ClothState> swing(IntegratorKind kind, int newton_steps, int steps, int parts = 1) {
    const ClothParameters parameters = hung_sheet();
    const ClothModel model = make_cloth_model(parameters);
    const auto integrator = make_integrator({.kind = kind, .newton_steps = newton_steps}, model.grid);
    std::vector<ClothState> states{make_rest_state(parameters)};
    for (int k = 0; k < steps; ++k) {
        states.push_back(states.back());
        for (int part = 0; part < parts; ++part)
            integrator->step(model, states.back(), picture / static_cast<Real>(parts));
    }
    return states;
}

/// What a last step leaves of the equations of its method, of m g h.
Real left_of(IntegratorKind kind, int newton_steps) {
    const ClothParameters parameters = hung_sheet();
    const ClothModel model = make_cloth_model(parameters);
    const std::vector<ClothState> states = swing(kind, newton_steps, 12);
    const ClothState &earlier = states[10], &from = states[11], &to = states[12];
    Points x = to.x, v = to.v, f(x.rows(), 3), change = to.v - from.v;
    Real s = picture;
    if (kind == IntegratorKind::ImplicitMidpoint) {
        x = (from.x + to.x) / 2;
        v = (from.v + to.v) / 2;
    }
    if (kind == IntegratorKind::Bdf2) {
        s = 2 * picture / 3;
        change -= (from.v - earlier.v) / 3;
    }
    compute_forces(model, x, v, f);
    Points left = model.particle_mass * change - s * f;
    for (int p = 0; p < model.grid.particles(); ++p) {
        if (model.pinned(p)) left.row(p).setZero();
    }
    return left.norm() / (model.particle_mass * model.gravity.norm() * picture);
}

class NewtonSteps : public testing::TestWithParam<IntegratorKind> {};

TEST_P(NewtonSteps, ComeNearerToTheNonlinearEquations) {
    const Real one = left_of(GetParam(), 1), two = left_of(GetParam(), 2), six = left_of(GetParam(), 6);
    EXPECT_LT(two, one / 2);
    EXPECT_LT(six, one / 10);
}

TEST_P(NewtonSteps, MakeALongStepMoreAccurate) {
    const Points exact = swing(IntegratorKind::Rk4, 1, 15, 200).back().x;
    const Real one = (swing(GetParam(), 1, 15).back().x - exact).norm();
    const Real two = (swing(GetParam(), 2, 15).back().x - exact).norm();
    EXPECT_LT(two, one);
}

INSTANTIATE_TEST_SUITE_P(Of, NewtonSteps,
                         testing::Values(IntegratorKind::BackwardEuler, IntegratorKind::ImplicitMidpoint,
                                         IntegratorKind::Bdf2),
                         [](const auto& of) { return std::string(name_of(of.param)); });

}  // namespace
}  // namespace drape
