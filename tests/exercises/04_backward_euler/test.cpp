#include <gtest/gtest.h>

#include "drape/integrate/integrator.h"
#include EXERCISE

using drape::ClothParameters, drape::IntegratorKind, drape::Real;

TEST(BackwardEuler, MovesAndPullsByWhatIsAtTheEnd) {
    const auto [x, v] = exercise_04::backward_euler({1, 2}, 30, 4, 0.5);
    EXPECT_NEAR(x, 1 + 0.5 * v, 1e-9) << "Hint: x moves by h times the new velocity.";
    EXPECT_NEAR(v, 2 + 0.5 * (-30 * x - 4 * v), 1e-9) << "Hint: solve (1 + h d + h^2 k) dv = h (-k x - d v - h k v).";
}

TEST(BackwardEuler, DampsAVibrationByItsFactor) {
    const auto [x, v] = exercise_04::backward_euler({1, 0}, 100, 0, 0.3);  // z = 3
    EXPECT_NEAR((100 * x * x + v * v) / 100, 1. / (1 + 9), 1e-9) << "Hint: the energy is left to one part in 1 + z^2.";
}

TEST(BackwardEuler, IsWhatDrapeDoesToAStretchedSpring) {
    ClothParameters sheet;
    sheet.particles = {2, 2}, sheet.mass = 4, sheet.drag = 0;
    sheet.structural = {50, 3}, sheet.shear = sheet.bend = {};
    auto model = make_cloth_model(sheet);
    auto state = make_rest_state(sheet);
    model.gravity.setZero();
    state.x.col(0) *= Real(1.5);  // both springs along x, of 1 m, by half a metre; two ends of 1 kg
    make_integrator({.integrator = IntegratorKind::BackwardEuler}, model.grid)->step(model, state, Real(0.1));
    const Real elongation = state.x(1, 0) - state.x(0, 0) - 1;
    EXPECT_NEAR(exercise_04::backward_euler({Real(0.5), 0}, 2 * 50, 2 * 3, Real(0.1)).x, elongation, 1e-5)
        << "Hint: here you got 2 k / m and 2 d / m of a spring whose ends both move; is d in your system?";
}
