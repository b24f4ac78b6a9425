#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <numbers>

#include "drape/integrate/stability.h"
#include EXERCISE

using drape::ClothParameters, drape::IntegratorKind, drape::Kernels;

TEST(WaveStiffness, IsFourTimesThatOfASpringAlongRows) {
    ClothParameters sheet;
    sheet.structural = {100, 0}, sheet.shear = sheet.bend = {};
    const auto s = exercise_03::wave_stiffness(make_cloth_model(sheet), std::numbers::pi, 0);
    EXPECT_NEAR(s(0, 0), 400, 1e-3) << "Hint: at a = pi, neighbours in a row, (di, dj) = (1, 0), move apart.";
    EXPECT_NEAR(s(1, 1), 0, 1e-3) << "Hint: at b = 0, neighbours in a column, (di, dj) = (0, 1), move alike.";
}

TEST(FastestWave, HasTheFrequencyThatDrapePredicts) {
    const auto check = [](double shear, double bend, const char* hint) {
        ClothParameters sheet;
        sheet.particles = {48, 48};
        sheet.structural = {100, 0}, sheet.shear = {shear, 0}, sheet.bend = {bend, 0}, sheet.drag = 0;
        const auto model = make_cloth_model(sheet);
        double stiffest = 0;
        for (int p = 0; p <= 64; ++p) {
            for (int q = 0; q <= 64; ++q) {
                const auto s = exercise_03::wave_stiffness(model, p * std::numbers::pi / 64, q * std::numbers::pi / 64);
                stiffest = std::max(stiffest, Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(s).eigenvalues()[1]);
            }
        }
        const auto limit =
            predicted_limit(model, make_rest_state(sheet), IntegratorKind::SymplecticEuler, Kernels::Vector);
        EXPECT_NEAR(stiffest / (limit.omega * limit.omega * model.particle_mass), 1, 0.01) << "Hint: " << hint;
    };
    check(0, 0, "a spring and its opposite pull by k (1 - cos(a di + b dj)) n n' y each.");
    check(100, 0, "at (di, dj) = (1, 1) and (-1, 1) the unit vector n is along a diagonal.");
    check(100, 100, "a bend spring joins particles two apart, so that its phase is 2 a or 2 b.");
}
