#pragma once

#include <Eigen/Cholesky>
#include <algorithm>
#include <vector>

#include "drape/model/jacobian.h"
#include "multigrid_level.h"

namespace drape {

/// A preconditioner for A = m I + k_scale K + d_scale D that takes about as many iterations on every grid: one V-cycle
/// of multigrid, in single precision. A level has every second column and row of the one before, and a correction found
/// there is interpolated (P). Its matrix is P'AP (Galerkin), a stencil of 5 x 5 symmetric blocks, half of which are
/// kept. Chebyshev polynomials of the matrix and its diagonal blocks smooth before a correction and after it, alike, so
/// that the cycle is symmetric; the coarsest level is factored. Pinned particles take no part.
/// @cite tamstorf2015 @cite trottenberg2001
class Multigrid {
public:
    /// Makes room for the levels; nothing later allocates.
    Multigrid(const Grid& grid, Kernels kernels)
        : own_(grid.particles(), Level::entries), terms_(grid.particles(), Level::entries) {
        pinned_.reserve(static_cast<std::size_t>(grid.particles()));
        levels_.emplace_back(grid, grid, kernels);
        const auto halved = [](int n) { return n > 2 ? n / 2 + 1 : n; };
        do {
            const Grid finer = levels_.back().grid;
            levels_.emplace_back(finer, Grid{halved(finer.nx), halved(finer.ny)}, kernels);
        } while (levels_.back().grid.particles() > few_nodes);
        for (std::size_t k = 0; k < levels_.size(); ++k) levels_[k].plan(k < 2);
        const int unknowns = 3 * levels_.back().grid.particles();
        dense_.setIdentity(unknowns, unknowns);
        factors_.compute(dense_);
        unknowns_.resize(unknowns);
    }

    /// Takes the matrix. Nothing is kept of the one before.
    /// @param jacobian clamped
    /// @par Cost O(n)
    void build(const ClothModel& model, const Jacobian& jacobian, Real k_scale, Real d_scale) {
        const Grid& grid = model.grid;
        pinned_.clear();
        for (int p = 0; p < grid.particles(); ++p) {
            if (model.pinned(p)) pinned_.push_back(p);
        }
        for (Level& level : levels_) std::ranges::fill(level.stencils, 0.0F);
        const auto add = [&](std::size_t kind, const Level::Blocks& terms) {
            levels_[0].add(kind, terms);
            levels_[1].add(kind, terms);
        };
        own_.setZero();
        const Jacobian::Block inertia = (model.particle_mass + d_scale * jacobian.drag()) * Jacobian::Block::Identity();
        for (int p = 0; p < grid.particles(); ++p) {
            if (!model.pinned(p)) add_block(own_, p, inertia);
        }
        for (std::size_t direction = 0; direction < spring_directions.size(); ++direction) {
            terms_.setZero();
            jacobian.for_each_spring(direction, k_scale, d_scale, [&](int a, int b, const Jacobian::Block& block) {
                if (model.pinned(a) && model.pinned(b)) return;
                if (model.pinned(a)) return add_block(own_, b, block);
                if (model.pinned(b)) return add_block(own_, a, block);
                add_block(terms_, a, block);
            });
            add(Level::first_direction + direction, terms_);
        }
        // What wind adds damps alone: its blocks on the diagonal will do here
        jacobian.for_each_wind_block(d_scale, [&](int a, int b, const Jacobian::Block& block) {
            if (a == b && !model.pinned(a)) add_block(own_, a, block);
        });
        add(Level::own, own_);
        for (std::size_t k = 0; k < levels_.size(); ++k) {
            if (k > 1) levels_[k].add_matrix_of(levels_[k - 1], terms_);
            levels_[k].invert_diagonal();
            // On the finest level, a spring's two blocks are at most twice its diagonal ones
            if (k > 0) levels_[k].find_bound();
        }
        factor_coarsest();
    }

    /// z = about A^-1 r, zero at pinned particles.
    /// @pre `build` was called
    /// @par Cost O(n), that of about six products
    void cycle(const Points& r, Points& z) {
        levels_.front().b = r.array().cast<float>();
        solve(0);
        z = levels_.front().x.cast<Real>().matrix();
    }

private:
    using Level = MultigridLevel;

    /// Levels end at so few nodes, which are factored.
    static constexpr int few_nodes = 36;

    void factor_coarsest() {
        const Level& level = levels_.back();
        dense_.setZero();
        for (int p = 0; p < level.grid.particles(); ++p) {
            const int i = p % level.grid.nx, j = p / level.grid.nx;
            for (int k = 0; k < Level::blocks; ++k) {
                const auto [di, dj] = Level::offsets[static_cast<std::size_t>(k)];
                if (i + di < 0 || i + di >= level.grid.nx || j + dj >= level.grid.ny) continue;
                const int q = level.grid.particle(i + di, j + dj);
                const auto [xx, xy, xz, yy, yz, zz] = level.block(p, k);
                Eigen::Matrix3d block;
                block << xx, xy, xz, xy, yy, yz, xz, yz, zz;
                dense_.block<3, 3>(3 * p, 3 * q) = block;
                dense_.block<3, 3>(3 * q, 3 * p) = block;
            }
            const auto [xx, xy, xz, yy, yz, zz] = level.block(p, 0);
            if (xx + yy + zz == 0) dense_.block<3, 3>(3 * p, 3 * p).setIdentity();
        }
        factors_.compute(dense_);
        if (factors_.info() == Eigen::Success) return;
        dense_.diagonal() *= 2;
        factors_.compute(dense_);
    }

    /// x = about A^-1 b on a level.
    void solve(std::size_t number) {
        Level& level = levels_[number];
        if (number + 1 == levels_.size()) {
            unknowns_ = level.b.matrix().cast<double>().reshaped<Eigen::RowMajor>();
            factors_.solveInPlace(unknowns_);
            level.x = unknowns_.reshaped<Eigen::RowMajor>(level.x.rows(), 3).cast<float>().array();
            return;
        }
        level.x.setZero();
        level.residual = level.b;
        level.smooth();
        level.find_residual();
        levels_[number + 1].restrict_from(level.residual);
        solve(number + 1);
        levels_[number + 1].add_correction(level.x);
        if (number == 0) {
            for (const int p : pinned_) level.x.row(p).setZero();
        }
        level.find_residual();
        level.smooth();
    }

    std::vector<int> pinned_;
    std::vector<Level> levels_;
    Level::Blocks own_, terms_;  ///< scratch: of the particles alone, of one kind
    Eigen::MatrixXd dense_;
    Eigen::LLT<Eigen::MatrixXd> factors_;  ///< of the coarsest level
    Eigen::VectorXd unknowns_;
};

}  // namespace drape
