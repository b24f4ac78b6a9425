#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>
#include <string>

#include "drape/integrate/integrator.h"
#include "drape/model/jacobian.h"

namespace drape::test {

/// What one step of an explicit method does to (x, v).
/// @param drift, kick the rates of change of x and of v, times the step; each has rows of zeroes for the other
template <class Matrix>
Matrix explicit_step(IntegratorKind kind, const Matrix& drift, const Matrix& kick) {
    const Matrix one = Matrix::Identity(drift.rows(), drift.cols()), rate = drift + kick;
    switch (kind) {
        case IntegratorKind::ExplicitEuler:
            return one + rate;
        case IntegratorKind::SymplecticEuler:
            return (one + drift) * (one + kick);
        case IntegratorKind::VelocityVerlet: {
            const Matrix moved = one + drift + drift * kick / 2;
            return moved + kick / 2 + kick / 2 * (moved + kick);
        }
        case IntegratorKind::Rk4:
            return one + rate * (one + rate / 2 * (one + rate / 3 * (one + rate / 4)));
        default:
            throw std::invalid_argument("no step is written down here for " + std::string(name_of(kind)));
    }
}

/// x'' = -K x - D x' of a small cloth's free coordinates, by mass, as dense matrices.
struct LinearCloth {
    Eigen::MatrixXd stiffness, damping;

    LinearCloth(const ClothModel& model, const ClothState& state) {
        const int n = model.grid.particles();
        Jacobian slopes(model.grid, Hessian::Clamped, Kernels::Vector);
        slopes.linearise(model, state.x, state.v);
        std::vector<int> free;
        for (int k = 0; k < 3 * n; ++k) {
            if (!model.pinned(k % n)) free.push_back(k);
        }
        const auto matrix = [&](Real a, Real b) {
            Eigen::MatrixXd whole(3 * n, 3 * n);
            for (int column = 0; column < 3 * n; ++column) {
                Points unit = Points::Zero(n, 3), product = Points::Zero(n, 3);
                unit.data()[column] = 1;
                slopes.add_product(a, b, unit, product);
                whole.col(column) = product.reshaped().cast<double>() / static_cast<double>(model.particle_mass);
            }
            return Eigen::MatrixXd(whole(free, free));
        };
        stiffness = matrix(1, 0);
        damping = matrix(0, 1);
    }

    /// What one step of a method does to (x, v).
    [[nodiscard]] Eigen::MatrixXd step(IntegratorKind kind, double h) const {
        const auto n = stiffness.rows();
        Eigen::MatrixXd drift = Eigen::MatrixXd::Zero(2 * n, 2 * n), kick = drift;
        drift.topRightCorner(n, n).diagonal().setConstant(h);
        kick.bottomLeftCorner(n, n) = -h * stiffness;
        kick.bottomRightCorner(n, n) = -h * damping;
        return explicit_step(kind, drift, kick);
    }

    /// The largest factor by which a step makes a vibration grow.
    [[nodiscard]] double growth(IntegratorKind kind, double h) const {
        const Eigen::EigenSolver<Eigen::MatrixXd> solver(step(kind, h), false);
        return solver.eigenvalues().cwiseAbs().maxCoeff();
    }

    /// Of explicit Euler and RK4, whose step is a polynomial of the rates lambda: the longest with |R(h lambda)| <= 1.
    [[nodiscard]] double limit_by_rates(IntegratorKind kind) const {
        const auto n = stiffness.rows();
        Eigen::MatrixXd rate = step(IntegratorKind::ExplicitEuler, 1);
        rate -= Eigen::MatrixXd::Identity(2 * n, 2 * n);
        const Eigen::EigenSolver<Eigen::MatrixXd> solver(rate, false);
        const double fastest = solver.eigenvalues().cwiseAbs().maxCoeff();
        double shortest = std::numeric_limits<double>::infinity();
        for (const std::complex<double> lambda : solver.eigenvalues()) {
            // Motions without springs and damping are double zeroes, which come out as pairs about zero
            if (std::abs(lambda) < 1e-6 * fastest) continue;
            if (kind == IntegratorKind::ExplicitEuler) {
                shortest = std::min(shortest, std::max(-2 * lambda.real() / std::norm(lambda), 0.0));
                continue;
            }
            const auto stays = [&](double h) {
                const std::complex<double> z = h * lambda;
                return std::abs(1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)))) <= 1 + 1e-12;
            };
            double stable = 0, unstable = 4 / std::abs(lambda);
            for (int bisection = 0; bisection < 40; ++bisection) {
                const double middle = (stable + unstable) / 2;
                (stays(middle) ? stable : unstable) = middle;
            }
            shortest = std::min(shortest, stable);
        }
        return shortest;
    }

    /// The longest step without growth: by bisection of what the step itself does, or by its rates.
    [[nodiscard]] double limit(IntegratorKind kind) const {
        if (kind == IntegratorKind::ExplicitEuler || kind == IntegratorKind::Rk4) return limit_by_rates(kind);
        const double norm = std::max(std::sqrt(stiffness.norm()), damping.norm());
        double stable = 0, unstable = 1e-3 / norm;
        while (growth(kind, unstable) <= 1 + 1e-6) stable = unstable, unstable *= 2;
        while (unstable > (1 + 1e-4) * stable) {
            const double middle = (stable + unstable) / 2;
            (growth(kind, middle) <= 1 + 1e-6 ? stable : unstable) = middle;
        }
        return stable;
    }
};

}  // namespace drape::test
