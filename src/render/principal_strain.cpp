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
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Real, 2, 2>> solver(gradient.transpose() * gradient);
    PrincipalStrain found{(a + b + c + d) / 4, {}, {}};
    for (std::size_t k = 0; k < 2; ++k) {
        const Vec3 along = gradient * solver.eigenvectors().col(static_cast<Eigen::Index>(k));
        found.directions[k] = along.normalized();
        found.strains[k] = along.norm() - 1;
    }
    return found;
}

double append_strain_crosses(const FrameView& view, std::vector<Outlines::Edge>& edges) {
    constexpr int crosses_in_row = 16;  // at most
    Real largest = Real(1e-3);          // less is rounding
    const auto first = static_cast<std::ptrdiff_t>(edges.size());
    for (const ClothView& cloth : view.cloths) {
        const int columns = cloth.model.grid.cell_columns(), rows = cloth.model.grid.cell_rows();
        const int step = (std::max(columns, rows) + crosses_in_row - 1) / crosses_in_row;
        const Real room = Real(0.9) * static_cast<Real>(step) * std::min(cloth.model.hx, cloth.model.hy);
        for (int row = std::min(step, rows) / 2; row < rows; row += step) {
            for (int column = std::min(step, columns) / 2; column < columns; column += step) {
                const auto [centre, directions, strains] = principal_strain(cloth, view.blend, column, row);
                for (std::size_t k = 0; k < 2; ++k) {
                    largest = std::max(largest, std::abs(strains[k]));
                    const NodeState state = strains[k] > 0 ? NodeState::Stretched : NodeState::Compressed;
                    edges.push_back({centre, centre + room * std::abs(strains[k]) * directions[k], state});
                }
            }
        }
    }

    // So far each goes from its centre, for a strain of 1
    const double full = round_number_above(100 * static_cast<double>(largest));
    for (auto edge = edges.begin() + first; edge != edges.end(); ++edge) {
        const Vec3 arm = (edge->to - edge->from) * static_cast<Real>(50 / full);
        edge->to = edge->from + arm;
        edge->from -= arm;
    }
    return full;
}

}  // namespace drape
