#include <gtest/gtest.h>

#include <cmath>

#include "drape/integrate/integrator.h"
#include EXERCISE

using drape::ClothParameters, drape::IntegratorKind, drape::Real;

TEST(ErrorOrder, IsTheSlopeOnLogarithmicAxes) {
    EXPECT_NEAR(exercise_06::observed_order({4, 2, 1}, {48, 12, 3}), 2, 1e-9) << "Hint: a quarter at half h.";
    EXPECT_NEAR(exercise_06::observed_order({4, 2, 1}, {16, 8, 1}), 2, 1e-9)
        << "Hint: the slope is 1 from 4 to 2, and 3 from 2 to 1.";
    EXPECT_NEAR(exercise_06::observed_order({8, 4, 2, 1}, {8, 8, 1, 1}), 1.2, 1e-9)
        << "Hint: all points count, not only the first and the last; fit a line.";
    EXPECT_NEAR(exercise_06::observed_order({9, 3, 3, 1}, {9, 3, 3, 1}), 1, 1e-9) << "Hint: subtract both means.";
}

TEST(ErrorOrder, OfDrapesMethodsIsThatOfTheBooks) {
    ClothParameters sheet;
    sheet.particles = {2, 2}, sheet.mass = 4, sheet.drag = 0;
    sheet.structural = {50, 0}, sheet.shear = sheet.bend = {};
    auto model = make_cloth_model(sheet);
    model.gravity.setZero();
    const auto order = [&](IntegratorKind kind) {
        std::vector<double> steps, errors;
        for (int n = 64; n <= 512; n *= 2) {
            auto state = make_rest_state(sheet);
            state.x.col(0) *= Real(1.1);  // springs of 1 m along x swing at omega = 10, 1 kg at either end
            for (int i = 0; i < n; ++i)
                make_integrator({.integrator = kind}, model.grid)->step(model, state, Real(1) / n);
            steps.push_back(1. / n);
            errors.push_back(std::abs(state.x(1, 0) - state.x(0, 0) - 1 - 0.1 * std::cos(10.)));
        }
        return exercise_06::observed_order(steps, errors);
    };
    EXPECT_NEAR(order(IntegratorKind::VelocityVerlet), 2, 0.1) << "Hint: is your line that of log e against log h?";
    EXPECT_NEAR(order(IntegratorKind::Rk4), 4, 0.2) << "Hint: is your line that of log e against log h?";
}
