#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "drape/model/cloth_model.h"

namespace drape {

/// The matrix (m + h b) / h^2 I + sum k A'A over all springs, with A x = x_a - x_b: n x n, the same for x, y and z.
/// It changes with step, masses, stiffnesses and pins only, so that its factors L D L' serve many steps. A pinned
/// particle keeps its place with the row of an identity matrix: the pattern is the grid's, and is analysed once.
/// @cite bouaziz2014
class GlobalMatrix {
public:
    explicit GlobalMatrix(const Grid& grid) : grid_(grid) {}

    /// Makes the factors unless those at hand are of this very matrix.
    /// @par Cost O(n) to compare; about O(n^1.5) to factorise, allocates
    void prepare(const ClothModel& model, Real h);

    /// r = (this matrix)^-1 r.
    /// @param r n x 3; where it is zero at a pinned particle it stays so
    /// @par Cost as many multiplications as the factors have entries, six times; allocates nothing
    void solve(Points& r);

private:
    using Matrix = Eigen::SparseMatrix<Real>;
    using Column = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

    /// All that the matrix is made from, besides the grid and the pins.
    struct Key {
        Real diagonal = 0;  ///< (m + h b) / h^2 [kg/s^2]
        std::array<Real, 3> stiffnesses{};
        bool operator==(const Key&) const = default;
    };

    void factorise(const ClothModel& model);

    Grid grid_;
    Key key_;
    Eigen::Array<Real, Eigen::Dynamic, 1> inverse_mass_;  ///< of the factors, for their pins
    Matrix matrix_;
    Eigen::SimplicialLDLT<Matrix> factors_;
    Column pivots_;
    Eigen::Matrix<Real, Eigen::Dynamic, 3, Eigen::RowMajor> rows_;  ///< in the order of elimination
};

}  // namespace drape
