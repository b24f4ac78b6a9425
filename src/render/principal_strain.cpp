#include "principal_strain.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "cloth_colours.h"
#include "frame_data.h"

namespace drape {
namespace {

// Crosses along a row of cells, at most
constexpr int crosses_in_row = 16;

// Calls visit(strain, side) for the cells that have a cross, with the side of the block that a cross stands for [m]
template <class Visit>
void for_each_cross(const FrameView& view, Visit visit) {
    for (const ClothView& cloth : view.cloths) {
        const int columns = cloth.model.grid.cell_columns(), rows = cloth.model.grid.cell_rows();
        const int step = (std::max(columns, rows) + crosses_in_row - 1) / crosses_in_row;
        const Real side = static_cast<Real>(step) * std::min(cloth.model.hx, cloth.model.hy);
        for (int row = std::min(step, rows) / 2; row < rows; row += step) {
            for (int column = std::min(step, columns) / 2; column < columns; column += step) {
                visit(principal_strain(cloth, view.blend, column, row), side);
            }
        }
    }
}

}  // namespace

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

double full_strain(const FrameView& view) {
    constexpr double least = 0.1;  // %; less is rounding
    Real largest = 0;
    for_each_cross(view, [&](const PrincipalStrain& cell, Real) {
        for (const Real strain : cell.strains) largest = std::max(largest, std::abs(strain));
    });
    return round_number_above(std::max(100 * static_cast<double>(largest), least));
}

void append_strain_crosses(const FrameView& view, std::vector<Outlines::Edge>& edges) {
    const Real full = static_cast<Real>(full_strain(view) / 100);
    for_each_cross(view, [&](const PrincipalStrain& cell, Real side) {
        for (std::size_t k = 0; k < 2; ++k) {
            const Vec3 arm = Real(0.45) * side * std::abs(cell.strains[k]) / full * cell.directions[k];
            const NodeState state = cell.strains[k] > 0 ? NodeState::Stretched : NodeState::Compressed;
            edges.push_back({cell.centre - arm, cell.centre + arm, state});
        }
    });
}

}  // namespace drape
