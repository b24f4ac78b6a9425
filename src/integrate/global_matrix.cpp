#include "global_matrix.h"

#include "drape/base/assert.h"
#include "drape/model/stencils.h"

namespace drape {
namespace {

/// q = L^-1 q and then q = L'^-1 D^-1 q, for the three columns of q at once: by Eigen, which takes one column after the
/// other, it takes twice the time.
/// starts, rows, values: L below its unit diagonal, by columns; pivots: D; q: n rows of three
void solve_factors(int n, const int* starts, const int* rows, const Real* values, const Real* pivots, Real* q) {
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

}  // namespace

void GlobalMatrix::prepare(const ClothModel& model, const Numbers& inertia, Real h) {
    DRAPE_ASSERT(model.grid == grid_);
    const std::array<Real, 3> stiffnesses{model.structural.stiffness, model.shear.stiffness, model.bend.stiffness};
    const auto diagonal = (model.inverse_mass > 0).select(inertia / (h * h), Real(0));
    if (stiffnesses == stiffnesses_ && diagonal_.size() == diagonal.size() && (diagonal_ == diagonal).all()) return;
    stiffnesses_ = stiffnesses;
    diagonal_ = diagonal;
    factorise(model);
}

void GlobalMatrix::factorise(const ClothModel& model) {
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
    for (int p = 0; p < grid_.particles(); ++p) entries.emplace_back(p, p, model.pinned(p) ? Real(1) : diagonal_[p]);

    const bool analysed = matrix_.rows() > 0;
    matrix_.resize(grid_.particles(), grid_.particles());
    matrix_.setFromTriplets(entries.begin(), entries.end());
    if (!analysed) factors_.analyzePattern(matrix_);
    factors_.factorize(matrix_);
    pivots_ = factors_.vectorD();
    rows_.resize(grid_.particles(), 3);
}

void GlobalMatrix::solve(Points& r) {
    const auto& place = factors_.permutationP().indices();
    for (Eigen::Index p = 0; p < r.rows(); ++p) rows_.row(place[p]) = r.row(p);
    const Matrix& lower = factors_.matrixL().nestedExpression();
    solve_factors(grid_.particles(), lower.outerIndexPtr(), lower.innerIndexPtr(), lower.valuePtr(), pivots_.data(),
                  rows_.data());
    for (Eigen::Index p = 0; p < r.rows(); ++p) r.row(p) = rows_.row(place[p]);
}

}  // namespace drape
