#include "multigrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace drape {
namespace {

constexpr int group = kernels::StencilLayout::group;

/// Levels end at so few nodes, which are factored.
constexpr int few_nodes = 36;

/// By so much of their sum the diagonal entries are made larger.
constexpr float least_part = 1e-6F;

/// Rounds that look for a level's largest eigenvalue, and what they may have missed.
constexpr int rounds = 6;
constexpr double missed = 1.15;

/// Of Chebyshev's polynomials, and where the upper part of a spectrum begins: at its bound over this.
constexpr int degree = 2;
constexpr double smoothed = 4;

/// From a node to another of its stencil: itself, the two after it in its row, and five in each of two rows below.
struct Offset {
    int di, dj;
};

constexpr std::array<Offset, 13> offsets{
    {{0, 0}, {1, 0}, {2, 0}, {-2, 1}, {-1, 1}, {0, 1}, {1, 1}, {2, 1}, {-2, 2}, {-1, 2}, {0, 2}, {1, 2}, {2, 2}}};

int block_at(int di, int dj) { return dj == 0 ? di : 5 * dj + di; }

int halved(int n) { return n > 2 ? n / 2 + 1 : n; }

/// Weights by row and column.
using Weights = std::map<std::pair<int, int>, float>;

/// Those by which a fine node follows coarse ones: half of each of two neighbours where it is between them.
Weights weights_of(int i, int j, bool halves_columns, bool halves_rows) {
    const auto along = [](int k, bool halves) -> std::array<std::pair<int, float>, 2> {
        if (!halves) return {{{k, 1.0F}, {k, 0.0F}}};
        const int low = (k + 4) / 2 - 2;  // rounds down for k >= -4
        if (k % 2 == 0) return {{{low, 1.0F}, {low, 0.0F}}};
        return {{{low, 0.5F}, {low + 1, 0.5F}}};
    };
    Weights weights;
    for (const auto& [row, of_row] : along(j, halves_rows)) {
        for (const auto& [column, of_column] : along(i, halves_columns)) {
            if (of_row * of_column > 0) weights[{row, column}] += of_row * of_column;
        }
    }
    return weights;
}

Weights less(Weights a, const Weights& b) {
    for (const auto& [node, weight] : b) a[node] -= weight;
    return a;
}

/// The kinds of term that a level is added up from: of the particles alone and the six directions of springs at the
/// finest, of the blocks of a stencil on the others.
constexpr std::size_t own = 0, first_direction = 1;

}  // namespace

Multigrid::Level::Level(const Grid& finer_grid, const Grid& own_grid, Kernels kernels_of_products)
    : finer(finer_grid),
      grid(own_grid),
      stencils(kernels::StencilLayout::numbers(grid.particles())),
      inverse(grid.particles(), entries),
      x(grid.particles(), 3),
      b(grid.particles(), 3),
      residual(grid.particles(), 3),
      step(grid.particles(), 3),
      divided(grid.particles(), 3),
      rows(is_finest() ? 0 : grid.nx * finer_grid.ny, 3),
      line(finer_grid.nx, entries),
      kernels(kernels_of_products) {
    for (std::size_t k = 0; k < shifts.size(); ++k) {
        const auto [di, dj] = offsets[k];
        const bool is_spring = (di == 0 || dj == 0 || std::abs(di) + dj == 2);
        shifts[k] = is_finest() && !is_spring ? 0 : dj * grid.nx + di;
    }
}

/// Which terms are added where: w w' of a particle, d d' of a spring with the difference d of its ends', and
/// u v' + v u' of a block.
/// @param of_springs the terms are those of the cloth itself, and not those of the level before
void Multigrid::Level::plan(bool of_springs) {
    kinds.resize(of_springs ? first_direction + spring_directions.size() : blocks);
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        const bool is_spring = of_springs && k >= first_direction;
        const SpringDirection direction = is_spring ? spring_directions[k - first_direction] : SpringDirection{0, 0};
        const Offset to = of_springs ? Offset{direction.di, direction.dj} : offsets[k];
        kinds[k].di = to.di, kinds[k].dj = to.dj;
        for (int parity = 0; parity < 4; ++parity) {
            const int i = halves_columns() ? parity & 1 : 0, j = halves_rows() ? parity >> 1 : 0;
            const auto at = [&](int di, int dj) { return weights_of(i + di, j + dj, halves_columns(), halves_rows()); };
            const Weights first = is_spring ? less(at(0, 0), at(to.di, to.dj)) : at(0, 0);
            const Weights second = is_spring ? first : at(to.di, to.dj);
            const bool is_square = of_springs || k == own;
            std::map<std::pair<int, int>, float> sums;  // by node and block
            for (const auto& [p, of_p] : first) {
                for (const auto& [q, of_q] : second) {
                    if (is_square && q < p) continue;  // its other half
                    const auto [low, high] = std::minmax(p, q);
                    const float both = !is_square && p == q ? 2.0F : 1.0F;
                    const int node = low.first * grid.nx + low.second;
                    sums[{node, block_at(high.second - low.second, high.first - low.first)}] += both * of_p * of_q;
                }
            }
            for (const auto& [place, weight] : sums) {
                if (weight == 0) continue;
                kinds[k].parts[static_cast<std::size_t>(parity)].push_back({place.first, place.second, weight});
            }
        }
    }
}

/// Adds all terms of a kind to the blocks that they belong to.
/// @param terms by their first node, on the finer level
void Multigrid::Level::add(std::size_t number, const Blocks& terms) {
    const Kind& kind = kinds[number];
    const int stride = halves_columns() ? 2 : 1;
    for (int j = 0; j < finer.ny - kind.dj; ++j) {
        const int row = (halves_rows() ? j / 2 : j) * grid.nx, parity_of_row = halves_rows() ? j & 1 : 0;
        for (int first = std::max(-kind.di, 0), k = 0; k < stride; ++k, ++first) {
            const int count = (finer.nx - std::max(kind.di, 0) - first + stride - 1) / stride;
            const auto parity = static_cast<std::size_t>(2 * parity_of_row + (halves_columns() ? first & 1 : 0));
            for (int e = 0; e < entries; ++e) {
                const float* const from = terms.col(e).data() + finer.particle(first, j);
                for (int i = 0; i < count; ++i) line(i, e) = from[i * stride];
            }
            for (const Part& part : kind.parts[parity]) add_line(part, row + first / stride + part.node, count);
        }
    }
}

/// Adds one part of the terms in `line` to nodes beside each other.
void Multigrid::Level::add_line(const Part& part, int node, int count) {
    for (int done = 0; done < count;) {
        float* const to = stencils.data() + kernels::StencilLayout::first_entry(node + done, part.block);
        const int some = std::min(count - done, group - (node + done) % group);
        for (int e = 0; e < entries; ++e) {
            const float* const from = line.col(e).data() + done;
            for (int k = 0; k < some; ++k) to[e * group + k] += part.weight * from[k];
        }
        done += some;
    }
}

void Multigrid::Level::add_matrix_of(const Level& before, Blocks& scratch) {
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        for (int p = 0; p < finer.particles(); ++p) {
            const std::array<float, entries> term = before.block(p, static_cast<int>(k));
            for (std::size_t e = 0; e < term.size(); ++e) scratch(p, static_cast<Eigen::Index>(e)) = term[e];
        }
        add(k, scratch);
    }
}

std::array<float, Multigrid::entries> Multigrid::Level::block(int node, int number) const {
    const float* const first = stencils.data() + kernels::StencilLayout::first_entry(node, number);
    std::array<float, entries> of{};
    for (std::size_t e = 0; e < of.size(); ++e) of[e] = first[e * group];
    return of;
}

/// Of each node's own block, which is made a little stiffer: where springs are slack its smallest part is the mass,
/// which single precision may have lost.
void Multigrid::Level::invert_diagonal() {
    for (int p = 0; p < grid.particles(); ++p) {
        float* const first = stencils.data() + kernels::StencilLayout::first_entry(p, 0);
        const float more = least_part * (first[0] + first[3 * group] + first[5 * group]);
        for (const int e : {0, 3, 5}) first[e * group] += more;
        const auto [fxx, fxy, fxz, fyy, fyz, fzz] = block(p, 0);
        const double xx = fxx, xy = fxy, xz = fxz, yy = fyy, yz = fyz, zz = fzz;
        const double cxx = yy * zz - yz * yz, cxy = xz * yz - xy * zz, cxz = xy * yz - xz * yy;
        const double determinant = xx * cxx + xy * cxy + xz * cxz, scale = determinant > 0 ? 1 / determinant : 0;
        const std::array of{cxx, cxy, cxz, xx * zz - xz * xz, xy * xz - xx * yz, xx * yy - xy * xy};
        for (int e = 0; e < entries; ++e) inverse(p, e) = static_cast<float>(scale * of[static_cast<std::size_t>(e)]);
    }
}

void Multigrid::Level::product(const Vectors& u, Vectors& y) const {
    if (kernels == Kernels::Plain) return multiply_plainly(u, y);
    kernels::multiply_stencils(stencils.data(), grid.particles(), shifts, u.data(), y.data());
}

/// Each block joins two nodes, and gives to both. A group of nodes after another, as the kernel does.
void Multigrid::Level::multiply_plainly(const Vectors& u, Vectors& y) const {
    const int nodes = grid.particles();
    y.setZero();
    for (int base = 0; base < nodes; base += group) {
        for (int k = 0; k < blocks; ++k) {
            const int shift = shifts[static_cast<std::size_t>(k)], end = std::min(base + group, nodes - shift);
            if (k > 0 && shift <= 0) continue;
            const auto add = [&](int block_of, int from, int to) {
                const auto [xx, xy, xz, yy, yz, zz] = block(block_of, k);
                const float ux = u(from, 0), uy = u(from, 1), uz = u(from, 2);
                y(to, 0) += xx * ux + xy * uy + xz * uz;
                y(to, 1) += xy * ux + yy * uy + yz * uz;
                y(to, 2) += xz * ux + yz * uy + zz * uz;
            };
            for (int p = base; p < end; ++p) add(p, p + shift, p);
            for (int p = base; k > 0 && p < end; ++p) add(p, p, p + shift);
        }
    }
}

void Multigrid::Level::divide(const Vectors& r, Vectors& z) const {
    z.col(0) = inverse.col(0) * r.col(0) + inverse.col(1) * r.col(1) + inverse.col(2) * r.col(2);
    z.col(1) = inverse.col(1) * r.col(0) + inverse.col(3) * r.col(1) + inverse.col(4) * r.col(2);
    z.col(2) = inverse.col(2) * r.col(0) + inverse.col(4) * r.col(1) + inverse.col(5) * r.col(2);
}

/// By powers of D^-1 A on a vector that changes from node to node.
void Multigrid::Level::find_bound() {
    for (int p = 0; p < grid.particles(); ++p) {
        const int i = p % grid.nx, j = p / grid.nx;
        for (int axis = 0; axis < 3; ++axis) {
            const int turn = (7 * i + 13 * j + 29 * axis) % 11;
            x(p, axis) = ((i + j) % 2 == 0 ? 1.0F : -1.0F) * (1 + 0.1F * static_cast<float>(turn));
        }
    }
    bound = 0;
    for (int round = 0; round < rounds; ++round) {
        const float before = x.matrix().norm();
        product(x, residual);
        divide(residual, x);
        const float after = x.matrix().norm();
        if (!(after > 0)) break;
        bound = static_cast<double>(after / before);
        x *= before / after;
    }
    bound = std::max(missed * bound, 1.0);
}

/// Chebyshev's iteration for what is left of A x = b, which takes down the upper part of the spectrum of D^-1 A.
/// @cite saad2003
void Multigrid::Level::smooth() {
    const double middle = bound * (1 + 1 / smoothed) / 2, half = bound * (1 - 1 / smoothed) / 2;
    double rho = half / middle;
    divide(residual, step);
    step *= static_cast<float>(1 / middle);
    x += step;
    for (int k = 1; k < degree; ++k) {
        product(step, divided);
        residual -= divided;
        divide(residual, divided);
        const double next = 1 / (2 * middle / half - rho);
        step = static_cast<float>(next * rho) * step + static_cast<float>(2 * next / half) * divided;
        x += step;
        rho = next;
    }
}

void Multigrid::Level::find_residual() {
    product(x, residual);
    residual = b - residual;
}

Multigrid::Multigrid(const Grid& grid, Kernels kernels)
    : own_(grid.particles(), entries), terms_(grid.particles(), entries) {
    pinned_.reserve(static_cast<std::size_t>(grid.particles()));
    levels_.emplace_back(grid, grid, kernels);
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

void Multigrid::build(const ClothModel& model, const Jacobian& jacobian, Real k_scale, Real d_scale) {
    const Grid& grid = model.grid;
    pinned_.clear();
    for (int p = 0; p < grid.particles(); ++p) {
        if (model.pinned(p)) pinned_.push_back(p);
    }
    for (Level& level : levels_) std::ranges::fill(level.stencils, 0.0F);
    const auto add_to = [](Blocks& terms, int particle, const Jacobian::Block& block) {
        terms(particle, 0) += static_cast<float>(block(0, 0)), terms(particle, 1) += static_cast<float>(block(0, 1));
        terms(particle, 2) += static_cast<float>(block(0, 2)), terms(particle, 3) += static_cast<float>(block(1, 1));
        terms(particle, 4) += static_cast<float>(block(1, 2)), terms(particle, 5) += static_cast<float>(block(2, 2));
    };
    const auto add = [&](std::size_t kind, const Blocks& terms) {
        levels_[0].add(kind, terms);
        levels_[1].add(kind, terms);
    };
    own_.setZero();
    const Jacobian::Block inertia = (model.particle_mass + d_scale * jacobian.drag()) * Jacobian::Block::Identity();
    for (int p = 0; p < grid.particles(); ++p) {
        if (!model.pinned(p)) add_to(own_, p, inertia);
    }
    for (std::size_t direction = 0; direction < spring_directions.size(); ++direction) {
        terms_.setZero();
        jacobian.for_each_spring(direction, k_scale, d_scale, [&](int a, int b, const Jacobian::Block& block) {
            if (model.pinned(a) && model.pinned(b)) return;
            if (model.pinned(a)) return add_to(own_, b, block);
            if (model.pinned(b)) return add_to(own_, a, block);
            add_to(terms_, a, block);
        });
        add(first_direction + direction, terms_);
    }
    // What wind adds damps alone: its blocks on the diagonal will do here
    jacobian.for_each_wind_block(d_scale, [&](int a, int b, const Jacobian::Block& block) {
        if (a == b && !model.pinned(a)) add_to(own_, a, block);
    });
    add(own, own_);
    for (std::size_t k = 0; k < levels_.size(); ++k) {
        if (k > 1) levels_[k].add_matrix_of(levels_[k - 1], terms_);
        levels_[k].invert_diagonal();
        // On the finest level, a spring's two blocks are at most twice its diagonal ones
        if (k > 0) levels_[k].find_bound();
    }
    factor_coarsest();
}

void Multigrid::factor_coarsest() {
    const Level& level = levels_.back();
    dense_.setZero();
    for (int p = 0; p < level.grid.particles(); ++p) {
        const int i = p % level.grid.nx, j = p / level.grid.nx;
        for (int k = 0; k < blocks; ++k) {
            const auto [di, dj] = offsets[static_cast<std::size_t>(k)];
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

void Multigrid::cycle(const Points& r, Points& z) {
    levels_.front().b = r.array().cast<float>();
    solve(0);
    z = levels_.front().x.cast<Real>().matrix();
}

/// x = about A^-1 b on a level.
void Multigrid::solve(std::size_t number) {
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

}  // namespace drape
