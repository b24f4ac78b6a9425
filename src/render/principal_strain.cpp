#include "principal_strain.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "cloth_colours.h"
#include "frame_data.h"

namespace drape {

PrincipalStrain principal_strain(const ClothView& cloth, Real blend, int column, int row) {
    const auto corner = [&](int i, int j) {
        return drawn_particle(cloth, blend, cloth.model.grid.particle(column + i, row + j));
    };
    const Vec3 a = corner(0, 0), b = corner(1, 0), c = corner(0, 1), d = corner(1, 1);

    // The deformation gradient F in the middle of the cell, and the eigenvectors of F'F
    Eigen::Matrix<Real, 3, 2> gradient;
    gradient << (b + d - a - c) / (2 * cloth.model.hx), (c + d - a - b) / (2 * cloth.model.hy);
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Real, 2, 2>> solver;
    solver.computeDirect(gradient.transpose() * gradient);
    PrincipalStrain found{(a + b + c + d) / 4, {}, {}};
    for (std::size_t k = 0; k < 2; ++k) {
        const Vec3 along = gradient * solver.eigenvectors().col(static_cast<Eigen::Index>(k));
        found.directions[k] = along.normalized();
        found.strains[k] = along.norm() - 1;
    }
    return found;
}

StrainCrosses strain_crosses(const FrameView& view) {
    constexpr int crosses_in_row = 16;  // at most
    StrainCrosses crosses;
    if (view.settings->view.colour != ColourBy::PrincipalStrain) return crosses;
    struct Found {
        Vec3 centre, longest;  // [m]; a line of full length
        Real strain;
    };
    std::vector<Found> all;
    std::vector<Real> sizes{Real(1e-3)};  // less is rounding
    for (const ClothView& cloth : view.cloths) {
        const int columns = cloth.model.grid.cell_columns(), rows = cloth.model.grid.cell_rows();
        const int step = (std::max(columns, rows) + crosses_in_row - 1) / crosses_in_row;
        const Real room = Real(0.9) * static_cast<Real>(step) * std::min(cloth.model.hx, cloth.model.hy);
        for (int row = std::min(step, rows) / 2; row < rows; row += step) {
            for (int column = std::min(step, columns) / 2; column < columns; column += step) {
                const auto [centre, directions, strains] = principal_strain(cloth, view.blend, column, row);
                for (std::size_t k = 0; k < 2; ++k) {
                    all.push_back({centre, room * directions[k], strains[k]});
                    sizes.push_back(std::abs(strains[k]));
                }
            }
        }
    }

    // A corner by which all hangs would leave dots of the rest
    const auto nearly_largest = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() * 9 / 10);
    std::ranges::nth_element(sizes, nearly_largest);
    crosses.full = round_number_above(100 * std::max(static_cast<double>(*nearly_largest), 1e-3));
    for (const auto& [centre, longest, strain] : all) {
        const double part = std::min(100 * std::abs(static_cast<double>(strain)) / crosses.full, 1.0);
        const Vec3 arm = static_cast<Real>(part / 2) * longest;
        crosses.lines.push_back(
            {centre - arm, centre + arm, strain > 0 ? NodeState::Stretched : NodeState::Compressed});
    }
    return crosses;
}

}  // namespace drape
