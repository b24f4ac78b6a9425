#pragma once

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "drape/base/assert.h"
#include "drape/model/jacobian.h"

namespace drape {

/// The factors L D L' of the symmetric part of m I + d_scale D + k_scale K, by Eigen, for solves without iteration.
/// Pinned particles keep their place in the matrix, apart from all others, so that the pattern depends on the grid
/// alone: it is ordered (approximate minimum degree, which fills in less than nested dissection here) and analysed
/// once. An indefinite matrix is factored as well, without pivoting: then check what comes out. Refactoring allocates
/// nothing up to `largest`: up to there Eigen keeps its scratch on the stack.
class GridFactor {
public:
    /// The most particles for which a refactorisation allocates nothing.
    static constexpr int largest = EIGEN_STACK_ALLOCATION_LIMIT / (3 * static_cast<int>(sizeof(Real)));

    /// @par Cost O(n log n) for the pattern, and the memory of the factors
    explicit GridFactor(const Grid& grid) : matrix_(3 * grid.particles(), 3 * grid.particles()) {
        const int n = grid.particles();
        const auto pairs = spring_pairs(grid);
        place_ = elimination_order(n, pairs);
        std::vector<Eigen::Triplet<Real>> entries;
        entries.reserve(6 * static_cast<std::size_t>(n) + 9 * pairs.size());
        for (int p = 0; p < n; ++p) {
            for (int c = 0; c < 3; ++c) {
                for (int r = 0; r <= c; ++r) entries.emplace_back(3 * p + r, 3 * p + c, Real(1));
            }
        }
        for (const auto& [a, b] : pairs) {
            const auto [row, column] = std::minmax(place(a), place(b));
            for (int c = 0; c < 3; ++c) {
                for (int r = 0; r < 3; ++r) entries.emplace_back(3 * row + r, 3 * column + c, Real(1));
            }
        }
        matrix_.setFromTriplets(entries.begin(), entries.end());
        ldlt_.analyse(matrix_);
        rhs_.resize(3 * n);
        solution_.resize(3 * n);
    }

    /// @par Cost O(n^1.5) on a square grid
    void factorise(const ClothModel& model, const Jacobian& jacobian, Real k_scale, Real d_scale) {
        matrix_.coeffs().setZero();
        // Mass and drag; a pinned particle has the mass alone
        for (int p = 0; p < model.grid.particles(); ++p) {
            const auto columns = block(place(p), place(p));
            const Real drag = model.pinned(p) ? Real(0) : d_scale * jacobian.drag();
            for (int c = 0; c < 3; ++c) columns[static_cast<std::size_t>(c)][c] = model.particle_mass + drag;
        }

        // Springs and wind; blocks are symmetric, so that it does not matter which end comes first
        jacobian.for_each_block(k_scale, d_scale, [&](int a, int b, const Jacobian::Block& added) {
            if (model.pinned(a) || model.pinned(b)) return;
            const auto [row, column] = std::minmax(place(a), place(b));
            const auto columns = block(row, column);
            for (int c = 0; c < 3; ++c) {
                for (int r = 0; r <= (a == b ? c : 2); ++r) columns[static_cast<std::size_t>(c)][r] += added(r, c);
            }
        });
        ldlt_.refactorise(matrix_);
    }

    /// z = (L D L')^-1 r; z = r if a pivot was zero.
    /// Where r is zero at pinned particles, so is z.
    /// @pre both have a row for each particle
    void solve(const Points& r, Points& z) {
        DRAPE_ASSERT(3 * r.rows() == rhs_.size() && z.rows() == r.rows());
        if (ldlt_.info() != Eigen::Success) {
            z = r;
            return;
        }
        const int n = static_cast<int>(r.rows());
        for (int p = 0; p < n; ++p) rhs_.segment<3>(3 * place(p)) = r.row(p).transpose();
        solution_ = ldlt_.solve(rhs_);
        for (int p = 0; p < n; ++p) z.row(p) = solution_.segment<3>(3 * place(p)).transpose();
    }

private:
    using Matrix = Eigen::SparseMatrix<Real>;
    using Pairs = std::vector<std::pair<int, int>>;

    /// Eigen's factorisation, without the copy of the matrix that its public interface makes each time.
    class Ldlt : public Eigen::SimplicialLDLT<Matrix, Eigen::Upper> {
    public:
        void analyse(const Matrix& matrix) {
            analyzePattern_preordered(matrix, true);
            m_diag.resize(matrix.cols());
        }
        void refactorise(const Matrix& matrix) {
#if EIGEN_VERSION_AT_LEAST(5, 0, 0)  // which has another for matrices that are symmetric, but not Hermitian
            this->factorize_preordered<true, false>(matrix);
#else
            this->factorize_preordered<true>(matrix);
#endif
        }
    };

    /// Every pair of particles that a spring can join, the lower one first.
    static Pairs spring_pairs(const Grid& grid) {
        Pairs pairs;
        pairs.reserve(spring_directions.size() * static_cast<std::size_t>(grid.particles()));
        for (const auto& [di, dj] : spring_directions) {
            SpringStencil{di, dj, {}, 0}.for_each(grid, [&](int a, int b) { pairs.emplace_back(a, b); });
        }
        return pairs;
    }

    /// Where each particle goes for little fill-in. The ordering adds the other half of the graph.
    static std::vector<int> elimination_order(int particles, const Pairs& pairs) {
        std::vector<Eigen::Triplet<Real>> entries;
        entries.reserve(static_cast<std::size_t>(particles) + pairs.size());
        for (int p = 0; p < particles; ++p) entries.emplace_back(p, p, Real(1));
        for (const auto& [a, b] : pairs) entries.emplace_back(a, b, Real(1));
        Matrix graph(particles, particles);
        graph.setFromTriplets(entries.begin(), entries.end());
        Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
        Eigen::AMDOrdering<int>()(graph, order);
        std::vector<int> places(static_cast<std::size_t>(particles));
        for (int k = 0; k < particles; ++k) places[static_cast<std::size_t>(order.indices()[k])] = k;
        return places;
    }

    [[nodiscard]] const int& place(int particle) const { return place_[static_cast<std::size_t>(particle)]; }

    /// The three columns of an upper block, in the order of the rows: &A(3I, 3J + c).
    [[nodiscard]] std::array<Real*, 3> block(int row, int column) {
        // The three columns hold the same blocks above their diagonal ones, so that one search serves
        const int* const starts = matrix_.outerIndexPtr() + 3 * column;
        const int* const rows = matrix_.innerIndexPtr();
        const auto offset = std::lower_bound(rows + starts[0], rows + starts[1], 3 * row) - (rows + starts[0]);
        Real* const values = matrix_.valuePtr() + offset;
        return {values + starts[0], values + starts[1], values + starts[2]};
    }

    std::vector<int> place_;  ///< of each particle in the matrix
    Matrix matrix_;           ///< upper triangle, in the order of `place_`
    Ldlt ldlt_;
    Eigen::Matrix<Real, Eigen::Dynamic, 1> rhs_, solution_;
};

}  // namespace drape
