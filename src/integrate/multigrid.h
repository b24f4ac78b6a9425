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
    /// @param threads that share the work; the result is the same
    Multigrid(const Grid& grid, Kernels kernels, int threads = 1)
        : own_(grid.particles(), Level::entries), terms_(grid.particles(), Level::entries) {
        workers_.use(threads);
        pinned_.reserve(static_cast<std::size_t>(grid.particles()));
        levels_.emplace_back(grid, grid, kernels, workers_);
        const auto halved = [](int n) { return n > 2 ? n / 2 + 1 : n; };
        do {
            const Grid finer = levels_.back().grid;
            levels_.emplace_back(finer, Grid{halved(finer.nx), halved(finer.ny)}, kernels, workers_);
        } while (levels_.back().grid.particles() > few_nodes);
        for (std::size_t k = 0; k < levels_.size(); ++k) levels_[k].plan(k < 2);
        const int unknowns = 3 * levels_.back().grid.particles();
        dense_.setIdentity(unknowns, unknowns);
        factors_.compute(dense_);
        unknowns_.resize(unknowns);
    }

    Multigrid(const Multigrid&) = delete;  // levels share its threads
    Multigrid& operator=(const Multigrid&) = delete;

    /// Takes the matrix. Nothing is kept of the one before.
    /// @param jacobian clamped
    /// @par Cost O(n)
    void build(const ClothModel& model, const Jacobian& jacobian, Real k_scale, Real d_scale) {
        const Grid& grid = model.grid;
        pinned_.clear();
        for (int p = 0; p < grid.particles(); ++p) {
            if (model.pinned(p)) pinned_.push_back(p);
        }
        for (Level& level : levels_) level.clear();
        const auto add = [&](std::size_t kind, const Level::Blocks& terms) {
            const auto row = [&](int j, int e) { return terms.col(e).data() + grid.particle(0, j); };
            levels_[0].add(kind, row);
            levels_[1].add(kind, row);
        };
        own_.setZero();
        const Jacobian::Block inertia = (model.particle_mass + d_scale * jacobian.drag()) * Jacobian::Block::Identity();
        for (int p = 0; p < grid.particles(); ++p) {
            if (!model.pinned(p)) add_block(own_, p, inertia);
        }
        for (std::size_t direction = 0; direction < spring_directions.size(); ++direction) {
            levels_[0].for_rows([&](int from, int end) {
                jacobian.spring_blocks(direction, k_scale, d_scale, grid.particle(0, from),
                                       grid.particle(0, end - from), terms_);
            });
            const auto [di, dj] = spring_directions[direction];
            for (const int p : pinned_) leave_to_free_end(model, p, di, dj);
            add(Level::first_direction + direction, terms_);
        }
        // What wind adds damps alone: its blocks on the diagonal will do here
        jacobian.for_each_wind_block(d_scale, [&](int a, int b, const Jacobian::Block& block) {
            if (a == b && !model.pinned(a)) add_block(own_, a, block);
        });
        add(Level::own, own_);
        for (std::size_t k = 0; k < levels_.size(); ++k) {
            if (k > 1) levels_[k].add_matrix_of(levels_[k - 1]);
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
        Level& finest = levels_.front();
        finest.for_each_row([&](int axis, int j) {
            const Real* const from = r.col(axis).data() + finest.grid.particle(0, j);
            std::transform(from, from + finest.grid.nx, finest.row_of(finest.b, axis, j),
                           [](Real one) { return static_cast<float>(one); });
        });
        solve(0);
        finest.for_each_row([&](int axis, int j) {
            std::copy_n(finest.row_of(finest.x, axis, j), finest.grid.nx,
                        z.col(axis).data() + finest.grid.particle(0, j));
        });
        for (const int p : pinned_) z.row(p).setZero();
    }

private:
    using Level = MultigridLevel;

    /// Levels end at so few nodes, which are factored.
    static constexpr int few_nodes = 36;

    /// Of the springs of a direction that a pinned particle has, the free end alone keeps the block.
    void leave_to_free_end(const ClothModel& model, int pinned, int di, int dj) {
        const Grid& grid = model.grid;
        const int i = pinned % grid.nx, j = pinned / grid.nx, to = grid.particle(di, dj);
        const auto take = [&](int spring, int other) {
            if (!model.pinned(other)) own_.row(other) += terms_.row(spring);
            terms_.row(spring).setZero();
        };
        if (i + di >= 0 && i + di < grid.nx && j + dj < grid.ny) take(pinned, pinned + to);
        if (i - di >= 0 && i - di < grid.nx && j - dj >= 0) take(pinned - to, pinned - to);
    }

    void factor_coarsest() {
        const Level& level = levels_.back();
        const Grid& grid = level.grid;
        dense_.setZero();
        for (int p = 0; p < grid.particles(); ++p) {
            const int i = p % grid.nx, j = p / grid.nx;
            for (std::size_t k = 0; k < level.matrix.offsets.size(); ++k) {
                const auto [di, dj] = level.matrix.offsets[k];
                if (i + di < 0 || i + di >= grid.nx || j + dj >= grid.ny) continue;
                const int q = grid.particle(i + di, j + dj);
                const auto [xx, xy, xz, yy, yz, zz] = level.block(i, j, k);
                Eigen::Matrix3d block;
                block << xx, xy, xz, xy, yy, yz, xz, yz, zz;
                dense_.block<3, 3>(3 * p, 3 * q) = block;
                dense_.block<3, 3>(3 * q, 3 * p) = block;
            }
            const auto [xx, xy, xz, yy, yz, zz] = level.block(i, j, 0);
            if (xx + yy + zz == 0) dense_.block<3, 3>(3 * p, 3 * p).setIdentity();
        }
        factors_.compute(dense_);
        if (factors_.info() == Eigen::Success) return;
        dense_.diagonal() *= 2;
        factors_.compute(dense_);
    }

    void solve_coarsest() {
        Level& level = levels_.back();
        const auto for_each_unknown = [&](auto visit) {
            for (int axis = 0; axis < 3; ++axis) {
                for (int p = 0; p < level.grid.particles(); ++p) {
                    const int i = p % level.grid.nx, j = p / level.grid.nx;
                    visit(unknowns_[3 * p + axis], level.row_of(level.b, axis, j)[i],
                          level.row_of(level.x, axis, j)[i]);
                }
            }
        };
        for_each_unknown([](double& unknown, float b, float) { unknown = b; });
        factors_.solveInPlace(unknowns_);
        for_each_unknown([](double unknown, float, float& x) { x = static_cast<float>(unknown); });
    }

    /// x = about A^-1 b on a level.
    void solve(std::size_t number) {
        Level& level = levels_[number];
        if (number + 1 == levels_.size()) return solve_coarsest();
        level.smooth_from_zero();
        levels_[number + 1].restrict_from(level);
        solve(number + 1);
        levels_[number + 1].add_correction_to(level);
        level.smooth();
    }

    LazyWorkers workers_;
    std::vector<int> pinned_;
    std::vector<Level> levels_;
    Level::Blocks own_, terms_;  ///< scratch: of the particles alone, of one kind
    Eigen::MatrixXd dense_;
    Eigen::LLT<Eigen::MatrixXd> factors_;  ///< of the coarsest level
    Eigen::VectorXd unknowns_;
};

}  // namespace drape
