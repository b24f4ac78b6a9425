#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <array>

#include "drape/model/cloth_model.h"
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
    void prepare(const ClothModel& model, const Numbers& inertia, Real h);

    /// r = (this matrix)^-1 r.
    /// @param r n x 3; where it is zero at a pinned particle it stays so
    /// @par Cost as many multiplications as the factors have entries, six times; allocates nothing
    void solve(Points& r);

private:
    using Matrix = Eigen::SparseMatrix<Real>;
    using Column = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

    void factorise(const ClothModel& model);

    Grid grid_;
    std::array<Real, 3> stiffnesses_{};  ///< that the factors were made from; so is the next
    Numbers diagonal_;                   ///< inertia / h^2, and 0 for a pinned particle [kg/s^2]
    Matrix matrix_;
    Eigen::SimplicialLDLT<Matrix> factors_;
    Column pivots_;
    Eigen::Matrix<Real, Eigen::Dynamic, 3, Eigen::RowMajor> rows_;  ///< in the order of elimination
};

}  // namespace drape
