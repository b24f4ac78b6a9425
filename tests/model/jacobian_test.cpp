#include "drape/model/jacobian.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "drape/model/forces.h"
#include "support/cloths.h"

namespace drape {
namespace {

using Matrix = Eigen::MatrixXd;

/// A crumpled, moving cloth: some springs stretched, some pushing, and everything damped.
struct Crumpled {
    ClothParameters parameters;
    ClothModel model;
    ClothState state;

    explicit Crumpled(Grid grid = {5, 4}) : parameters(test::unlike_springs(grid)) {
        parameters.drag = 0.02;
        model = make_cloth_model(parameters);
        std::mt19937 random(7);
        state = test::random_state(parameters, random);
    }

    [[nodiscard]] Points force(const Points& x, const Points& v) const {
        Points f(x.rows(), 3);
        compute_forces(model, x, v, f);
        return f;
    }

    [[nodiscard]] Jacobian jacobian(Hessian hessian) const {
        Jacobian result(model.grid, hessian, Kernels::Vector);
        result.linearise(model, state.x, state.v);
        return result;
    }
};

/// -(f(s + t) - f(s - t)) / 2t for every coordinate s of one of the two arrays, extrapolated to t = 0.
template <class Force>
Matrix difference_slopes(Points at, Force force) {
    const auto column = [&](Eigen::Index coordinate, Real t) {
        Real& s = at.data()[coordinate];
        const Real kept = s;
        s = kept + t;
        const Points above = force(at);
        s = kept - t;
        const Points below = force(at);
        s = kept;
        return Eigen::VectorXd((below - above).reshaped() / (2 * t));
    };
    Matrix slopes(at.size(), at.size());
    constexpr Real t = 2e-4;
    for (Eigen::Index c = 0; c < at.size(); ++c) slopes.col(c) = (4 * column(c, t / 2) - column(c, t)) / 3;
    return slopes;
}

/// k_scale K + d_scale D, column by column.
Matrix matrix_of(const Jacobian& jacobian, Real k_scale, Real d_scale, Eigen::Index particles) {
    Matrix matrix(3 * particles, 3 * particles);
    for (Eigen::Index c = 0; c < matrix.cols(); ++c) {
        Points unit = Points::Zero(particles, 3), y = Points::Zero(particles, 3);
        unit.data()[c] = 1;
        jacobian.add_product(k_scale, d_scale, unit, y);
        matrix.col(c) = y.reshaped();
    }
    return matrix;
}

double relative_difference(const Matrix& a, const Matrix& b) {
    return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

TEST(Jacobian, IsThatOfTheForcesOnGridsOfAnyShape) {
    for (const Grid grid : {Grid{2, 2}, Grid{3, 2}, Grid{2, 5}, Grid{5, 4}}) {
        const Crumpled cloth(grid);
        const Jacobian exact = cloth.jacobian(Hessian::Exact);
        const Matrix k =
            difference_slopes(cloth.state.x, [&](const Points& x) { return cloth.force(x, cloth.state.v); });
        const Matrix d =
            difference_slopes(cloth.state.v, [&](const Points& v) { return cloth.force(cloth.state.x, v); });
        EXPECT_LT(relative_difference(matrix_of(exact, 1, 0, grid.particles()), k), 1e-7);
        EXPECT_LT(relative_difference(matrix_of(exact, 0, 1, grid.particles()), d), 1e-7);
        EXPECT_LT(relative_difference(matrix_of(cloth.jacobian(Hessian::Clamped), 0, 1, grid.particles()), d), 1e-7);
    }
}

TEST(Jacobian, HasHowTheWindResistsVelocities) {
    Crumpled cloth;
    cloth.model.air = {Vec3(3, -1, 2), Real(1.2)};
    const Matrix d = difference_slopes(cloth.state.v, [&](const Points& v) { return cloth.force(cloth.state.x, v); });
    EXPECT_LT(relative_difference(matrix_of(cloth.jacobian(Hessian::Clamped), 0, 1, 20), d), 1e-7);
    const Matrix calm = matrix_of(Crumpled().jacobian(Hessian::Clamped), 0, 1, 20);
    EXPECT_GT(relative_difference(calm, d), 1e-2);
}

TEST(ClampedJacobian, IsTheExactOneOfAnUndampedClothUnderTension) {
    Crumpled cloth;
    cloth.parameters.structural.damping = cloth.parameters.shear.damping = cloth.parameters.bend.damping = 0;
    cloth.model = make_cloth_model(cloth.parameters);
    cloth.state.x *= 2;
    const Matrix exact = matrix_of(cloth.jacobian(Hessian::Exact), 1, 1, 20);
    EXPECT_LT(relative_difference(matrix_of(cloth.jacobian(Hessian::Clamped), 1, 1, 20), exact), 1e-15);
}

TEST(ClampedJacobian, IsSymmetricAndHasNoNegativeEigenvalue) {
    const Crumpled cloth;
    const Matrix exact = matrix_of(cloth.jacobian(Hessian::Exact), 1, 0, 20);
    const Matrix clamped = matrix_of(cloth.jacobian(Hessian::Clamped), 1, 0, 20);
    EXPECT_LT((clamped - clamped.transpose()).cwiseAbs().maxCoeff(), 1e-12 * clamped.cwiseAbs().maxCoeff());
    EXPECT_GT((exact - exact.transpose()).cwiseAbs().maxCoeff(), 1e-4 * exact.cwiseAbs().maxCoeff());
    const auto lowest = [](const Matrix& m) {
        return Eigen::SelfAdjointEigenSolver<Matrix>((m + m.transpose()) / 2).eigenvalues()[0] /
               m.cwiseAbs().maxCoeff();
    };
    EXPECT_GT(lowest(clamped), -1e-12);
    EXPECT_LT(lowest(exact), -1e-2);
}

TEST(Jacobian, IsTheSumOfItsBlocks) {
    Crumpled cloth;
    cloth.model.air = {Vec3(3, -1, 2), Real(1.2)};
    for (const Hessian hessian : {Hessian::Clamped, Hessian::Exact}) {
        const Jacobian jacobian = cloth.jacobian(hessian);
        Matrix sum = Matrix::Identity(60, 60) * 3 * cloth.model.drag;
        jacobian.for_each_block(2, 3, [&](int a, int b, const Jacobian::Block& block) {
            for (int row = 0; row < 3; ++row) {
                for (int column = 0; column < 3; ++column) {
                    const Real entry = block(row, column);
                    sum(20 * row + a, 20 * column + b) += entry;
                    if (a != b) sum(20 * row + b, 20 * column + a) += entry;
                }
            }
        });
        const Matrix whole = matrix_of(jacobian, 2, 3, 20);
        EXPECT_LT(relative_difference(sum, (whole + whole.transpose()) / 2), 1e-14);
    }
}

TEST(Jacobian, IsFiniteAndEmptyForASpringOfZeroLength) {
    Crumpled cloth;
    cloth.state.x.setConstant(0.7);
    for (const Hessian hessian : {Hessian::Clamped, Hessian::Exact}) {
        const Matrix k = matrix_of(cloth.jacobian(hessian), 1, 0, 20);
        EXPECT_TRUE(k.isZero(0));
    }
}

}  // namespace
}  // namespace drape
