#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <vector>

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
    explicit GridFactor(const Grid& grid);

    /// @par Cost O(n^1.5) on a square grid
    void factorise(const ClothModel& model, const Jacobian& jacobian, Real k_scale, Real d_scale);

    /// z = (L D L')^-1 r; z = r if a pivot was zero.
    /// Where r is zero at pinned particles, so is z.
    /// @pre both have a row for each particle
    void solve(const Points& r, Points& z);

private:
    using Matrix = Eigen::SparseMatrix<Real>;

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

    /// The three columns of an upper block, in the order of the rows: &A(3I, 3J + c).
    [[nodiscard]] std::array<Real*, 3> block(int row, int column);

    std::vector<int> place_;  ///< of each particle in the matrix
    Matrix matrix_;           ///< upper triangle, in the order of `place_`
    Ldlt ldlt_;
    Eigen::Matrix<Real, Eigen::Dynamic, 1> rhs_, solution_;
};

}  // namespace drape
