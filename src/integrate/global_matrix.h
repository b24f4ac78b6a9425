#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "drape/base/assert.h"
#include "drape/model/stencils.h"
#include "inertial_guess.h"

namespace drape {

/// The matrix M / h^2 + sum k A'A over all springs, with A x = x_a - x_b and M the particles' inertia: n x n, the same
/// for x, y and z. Without wind it changes with step, masses, stiffnesses and pins only, so that its factors L D L'
/// serve many steps. A pinned particle keeps its place with the row of an identity matrix: the pattern is the grid's,
/// and is analysed once.
/// @cite bouaziz2014
class GlobalMatrix {
public:
    explicit GlobalMatrix(const Grid& grid) : grid_(grid) {}

    /// Makes the factors unless those at hand are of this very matrix.
    /// @par Cost O(n) to compare; about O(n^1.5) to factorise, allocates
    void prepare(const ClothModel& model, const Numbers& inertia, Real h) {
        DRAPE_ASSERT(model.grid == grid_);
        const std::array<Real, 3> stiffnesses{model.structural.stiffness, model.shear.stiffness, model.bend.stiffness};
        const auto diagonal = (model.inverse_mass > 0).select(inertia / (h * h), Real(0));
        if (stiffnesses == stiffnesses_ && diagonal_.size() == diagonal.size() && (diagonal_ == diagonal).all()) return;
        stiffnesses_ = stiffnesses;
        diagonal_ = diagonal;
        factorise(model);
    }

    /// r = (this matrix)^-1 r.
    /// @param r n x 3; where it is zero at a pinned particle it stays so
    /// @par Cost as many multiplications as the factors have entries, six times; allocates nothing
    void solve(Points& r) {
        const auto& place = factors_.permutationP().indices();
        for (Eigen::Index p = 0; p < r.rows(); ++p) rows_.row(place[p]) = r.row(p);
        const Matrix& lower = factors_.matrixL().nestedExpression();
        solve_factors(grid_.particles(), lower.outerIndexPtr(), lower.innerIndexPtr(), lower.valuePtr(), pivots_.data(),
                      rows_.data());
        for (Eigen::Index p = 0; p < r.rows(); ++p) r.row(p) = rows_.row(place[p]);
    }

private:
    using Matrix = Eigen::SparseMatrix<Real>;

    void factorise(const ClothModel& model) {
        // Springs; those of stiffness zero and of pinned particles leave zeros, to keep the pattern
        constexpr int families = 6, entries_of_spring = 4;
        std::vector<Eigen::Triplet<Real>> entries;
        entries.reserve(static_cast<std::size_t>(grid_.particles()) * (families * entries_of_spring + 1));
        const auto free = [&](int particle) { return model.pinned(particle) ? Real(0) : Real(1); };
        for (const SpringStencil& springs : spring_stencils(model)) {
            const Real k = springs.law.stiffness;
            springs.for_each(grid_, [&](int a, int b) {
                entries.emplace_back(a, a, k * free(a));
                entries.emplace_back(b, b, k * free(b));
                entries.emplace_back(a, b, -k * free(a) * free(b));
                entries.emplace_back(b, a, -k * free(a) * free(b));
            });
        }
        for (int p = 0; p < grid_.particles(); ++p) {
            entries.emplace_back(p, p, model.pinned(p) ? Real(1) : diagonal_[p]);
        }

        const bool analysed = matrix_.rows() > 0;
        matrix_.resize(grid_.particles(), grid_.particles());
        matrix_.setFromTriplets(entries.begin(), entries.end());
        if (!analysed) factors_.analyzePattern(matrix_);
        factors_.factorize(matrix_);
        pivots_ = factors_.vectorD();
        rows_.resize(grid_.particles(), 3);
    }

    /// q = L^-1 q and then q = L'^-1 D^-1 q, for the three columns of q at once: by Eigen, which takes one column after
    /// the other, it takes twice the time.
    /// starts, rows, values: L below its unit diagonal, by columns; pivots: D; q: n rows of three
    static void solve_factors(int n, const int* starts, const int* rows, const Real* values, const Real* pivots,
                              Real* q) {
        for (int j = 0; j < n; ++j) {
            const Real x = q[3 * j], y = q[3 * j + 1], z = q[3 * j + 2];
            for (int entry = starts[j]; entry < starts[j + 1]; ++entry) {
                Real* const to = q + 3 * rows[entry];
                const Real value = values[entry];
                to[0] -= value * x;
                to[1] -= value * y;
                to[2] -= value * z;
            }
        }
        for (int j = n - 1; j >= 0; --j) {
            Real x = 0, y = 0, z = 0;
            for (int entry = starts[j]; entry < starts[j + 1]; ++entry) {
                const Real* const from = q + 3 * rows[entry];
                x += values[entry] * from[0];
                y += values[entry] * from[1];
                z += values[entry] * from[2];
            }
            q[3 * j] = q[3 * j] / pivots[j] - x;
            q[3 * j + 1] = q[3 * j + 1] / pivots[j] - y;
            q[3 * j + 2] = q[3 * j + 2] / pivots[j] - z;
        }
    }

    Grid grid_;
    std::array<Real, 3> stiffnesses_{};  ///< that the factors were made from; so is the next
    Numbers diagonal_;                   ///< inertia / h^2, and 0 for a pinned particle [kg/s^2]
    Matrix matrix_;
    Eigen::SimplicialLDLT<Matrix> factors_;
    Eigen::Matrix<Real, Eigen::Dynamic, 1> pivots_;
    Eigen::Matrix<Real, Eigen::Dynamic, 3, Eigen::RowMajor> rows_;  ///< in the order of elimination
};

}  // namespace drape
