#include "grid_factor.h"

#include "drape/base/assert.h"

#include <Eigen/OrderingMethods>
#include <algorithm>
#include <array>

namespace drape {
namespace {

/// Every pair of particles that a spring can join, the lower one first.
std::vector<std::pair<int, int>> spring_pairs(const Grid& grid) {
    std::vector<std::pair<int, int>> pairs;
    pairs.reserve(spring_directions.size() * static_cast<std::size_t>(grid.particles()));
    for (const auto& [di, dj] : spring_directions) {
        SpringStencil{di, dj, {}, 0}.for_each(grid, [&](int a, int b) { pairs.emplace_back(a, b); });
    }
    return pairs;
}

/// Where each particle goes for little fill-in.
std::vector<int> elimination_order(int particles, const std::vector<std::pair<int, int>>& pairs) {
    std::vector<Eigen::Triplet<Real>> entries;
    entries.reserve(static_cast<std::size_t>(particles) + 2 * pairs.size());
    for (int p = 0; p < particles; ++p) entries.emplace_back(p, p, Real(1));
    for (const auto& [a, b] : pairs) {
        entries.emplace_back(a, b, Real(1));
        entries.emplace_back(b, a, Real(1));
    }
    Eigen::SparseMatrix<Real> graph(particles, particles);
    graph.setFromTriplets(entries.begin(), entries.end());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(graph, order);
    std::vector<int> place(static_cast<std::size_t>(particles));
    for (int k = 0; k < particles; ++k) place[static_cast<std::size_t>(order.indices()[k])] = k;
    return place;
}

}  // namespace

GridFactor::GridFactor(const Grid& grid) {
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
        const auto [row, column] =
            std::minmax(place_[static_cast<std::size_t>(a)], place_[static_cast<std::size_t>(b)]);
        for (int c = 0; c < 3; ++c) {
            for (int r = 0; r < 3; ++r) entries.emplace_back(3 * row + r, 3 * column + c, Real(1));
        }
    }
    matrix_.resize(3 * n, 3 * n);
    matrix_.setFromTriplets(entries.begin(), entries.end());
    ldlt_.analyse(matrix_);
    rhs_.resize(3 * n);
    solution_.resize(3 * n);
}

std::array<Real*, 3> GridFactor::block(int row, int column) {
    // The three columns hold the same blocks above their diagonal ones, so that one search serves
    const int* const starts = matrix_.outerIndexPtr() + 3 * column;
    const int* const rows = matrix_.innerIndexPtr();
    const auto offset = std::lower_bound(rows + starts[0], rows + starts[1], 3 * row) - (rows + starts[0]);
    Real* const values = matrix_.valuePtr() + offset;
    return {values + starts[0], values + starts[1], values + starts[2]};
}

void GridFactor::factorise(const ClothModel& model, const Jacobian& jacobian, Real k_scale, Real d_scale) {
    matrix_.coeffs().setZero();
    // Mass and drag; a pinned particle has the mass alone
    for (int p = 0; p < model.grid.particles(); ++p) {
        const int place = place_[static_cast<std::size_t>(p)];
        const auto columns = block(place, place);
        const Real drag = model.pinned(p) ? Real(0) : d_scale * jacobian.drag();
        for (int c = 0; c < 3; ++c) columns[static_cast<std::size_t>(c)][c] = model.particle_mass + drag;
    }

    // Springs and wind; blocks are symmetric, so that it does not matter which end comes first
    jacobian.for_each_block(k_scale, d_scale, [&](int a, int b, const Jacobian::Block& added) {
        if (model.pinned(a) || model.pinned(b)) return;
        const auto [row, column] =
            std::minmax(place_[static_cast<std::size_t>(a)], place_[static_cast<std::size_t>(b)]);
        const auto columns = block(row, column);
        for (int c = 0; c < 3; ++c) {
            for (int r = 0; r <= (a == b ? c : 2); ++r) columns[static_cast<std::size_t>(c)][r] += added(r, c);
        }
    });
    ldlt_.refactorise(matrix_);
}

void GridFactor::solve(const Points& r, Points& z) {
    DRAPE_ASSERT(3 * r.rows() == rhs_.size() && z.rows() == r.rows());
    if (ldlt_.info() != Eigen::Success) {
        z = r;
        return;
    }
    for (Eigen::Index p = 0; p < r.rows(); ++p) {
        rhs_.segment<3>(3 * place_[static_cast<std::size_t>(p)]) = r.row(p).transpose();
    }
    solution_ = ldlt_.solve(rhs_);
    for (Eigen::Index p = 0; p < r.rows(); ++p) {
        z.row(p) = solution_.segment<3>(3 * place_[static_cast<std::size_t>(p)]).transpose();
    }
}

}  // namespace drape
