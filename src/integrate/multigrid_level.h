#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>
#include <vector>

#include "drape/base/kernels.h"
#include "drape/model/stencils.h"
#include "kernels/stencil_kernels.h"

namespace drape {

/// z = B r, with the symmetric 3 x 3 block of each node by its entries xx, xy, xz, yy, yz, zz.
template <class Blocks, class From, class To>
void multiply_blocks(const Blocks& blocks, const From& r, To&& z) {
    z.col(0) = blocks.col(0) * r.col(0) + blocks.col(1) * r.col(1) + blocks.col(2) * r.col(2);
    z.col(1) = blocks.col(1) * r.col(0) + blocks.col(3) * r.col(1) + blocks.col(4) * r.col(2);
    z.col(2) = blocks.col(2) * r.col(0) + blocks.col(4) * r.col(1) + blocks.col(5) * r.col(2);
}

/// Adds a symmetric block to that of a node.
template <class Blocks, class Block>
void add_block(Blocks& blocks, int node, const Block& block) {
    int entry = 0;
    for (int r = 0; r < 3; ++r) {
        for (int c = r; c < 3; ++c) blocks(node, entry++) += static_cast<typename Blocks::Scalar>(block(r, c));
    }
}

/// The finest level of `Multigrid`, or one of every second column and row of a finer one, where that has more than two.
struct MultigridLevel {
    using Layout = kernels::StencilLayout;
    static constexpr int blocks = Layout::blocks, entries = Layout::entries, group = Layout::group;
    using Vectors = Eigen::Array<float, Eigen::Dynamic, 3>;
    using Blocks = Eigen::Array<float, Eigen::Dynamic, entries>;  ///< xx, xy, xz, yy, yz, zz of each

    /// By so much of their sum the diagonal entries are made larger.
    static constexpr float least_part = 1e-6F;

    /// Rounds that look for a level's largest eigenvalue, and what they may have missed.
    static constexpr int rounds = 6;
    static constexpr double missed = 1.15;

    /// Of Chebyshev's polynomials, and where the upper part of a spectrum begins: at its bound over this.
    static constexpr int degree = 2;
    static constexpr double smoothed = 4;

    /// The kinds of term that a level is added up from: of the particles alone and the six directions of springs at the
    /// finest, of the blocks of a stencil on the others.
    static constexpr std::size_t own = 0, first_direction = 1;

    /// From a node to the others of its stencil: itself, the two after it in its row, and five in each of two rows
    /// below.
    static constexpr std::array<SpringDirection, blocks> offsets{
        {{0, 0}, {1, 0}, {2, 0}, {-2, 1}, {-1, 1}, {0, 1}, {1, 1}, {2, 1}, {-2, 2}, {-1, 2}, {0, 2}, {1, 2}, {2, 2}}};
    static int block_at(int di, int dj) { return dj == 0 ? di : 5 * dj + di; }

    /// What of a coarse matrix a term of the finer one is added to: a block of a node, and how much of the term.
    struct Part {
        int node;  ///< from the coarse node at or before the term's first one
        int block;
        float weight;
    };

    /// Terms that join a node with another: where they are added, for even and odd columns and rows.
    struct Kind {
        int di, dj;  ///< from the first to the other
        std::array<std::vector<Part>, 4> parts;
    };

    Grid finer, grid;
    std::vector<float> stencils;
    std::array<int, blocks> shifts{};  ///< from a node to the others of its stencil
    Blocks inverse;                    ///< of the diagonal blocks; zero where nothing moves
    double bound = 2;                  ///< of the spectrum of D^-1 A
    Vectors x, b, residual, step, divided;
    Vectors rows;  ///< scratch, of the finer level's rows
    Blocks line;   ///< scratch, of every one or every second term in a row
    std::vector<Kind> kinds;
    bool plain;  ///< products in plain code, with the same bits

    MultigridLevel(const Grid& finer_grid, const Grid& own_grid, Kernels kernels)
        : finer(finer_grid),
          grid(own_grid),
          stencils(Layout::numbers(grid.particles())),
          inverse(grid.particles(), entries),
          x(grid.particles(), 3),
          b(grid.particles(), 3),
          residual(grid.particles(), 3),
          step(grid.particles(), 3),
          divided(grid.particles(), 3),
          rows(is_finest() ? 0 : grid.nx * finer_grid.ny, 3),
          line(finer_grid.nx, entries),
          plain(kernels == Kernels::Plain) {
        for (std::size_t k = 0; k < shifts.size(); ++k) {
            const auto [di, dj] = offsets[k];
            const bool is_spring = (di == 0 || dj == 0 || std::abs(di) + dj == 2);
            shifts[k] = is_finest() && !is_spring ? 0 : dj * grid.nx + di;
        }
    }

    [[nodiscard]] bool is_finest() const { return grid == finer; }
    [[nodiscard]] bool halves_columns() const { return grid.nx != finer.nx; }
    [[nodiscard]] bool halves_rows() const { return grid.ny != finer.ny; }

    /// Weights by row and column.
    using Weights = std::map<std::pair<int, int>, float>;

    /// Those by which a fine node follows coarse ones: half of each of two neighbours where it is between them.
    [[nodiscard]] Weights weights_of(int i, int j) const {
        const auto along = [](int k, bool halves) -> std::array<std::pair<int, float>, 2> {
            if (!halves) return {{{k, 1.0F}, {k, 0.0F}}};
            const int low = (k + 4) / 2 - 2;  // rounds down for k >= -4
            if (k % 2 == 0) return {{{low, 1.0F}, {low, 0.0F}}};
            return {{{low, 0.5F}, {low + 1, 0.5F}}};
        };
        Weights weights;
        for (const auto& [row, of_row] : along(j, halves_rows())) {
            for (const auto& [column, of_column] : along(i, halves_columns())) {
                if (of_row * of_column > 0) weights[{row, column}] += of_row * of_column;
            }
        }
        return weights;
    }

    /// Which terms are added where: w w' of a particle, d d' of a spring with the difference d of its ends', and
    /// u v' + v u' of a block.
    /// @param of_springs the terms are those of the cloth itself, and not those of the level before
    void plan(bool of_springs) {
        kinds.resize(of_springs ? first_direction + spring_directions.size() : blocks);
        for (std::size_t k = 0; k < kinds.size(); ++k) {
            const bool is_spring = of_springs && k >= first_direction;
            SpringDirection to{0, 0};
            if (is_spring) to = spring_directions[k - first_direction];
            if (!of_springs) to = offsets[k];
            kinds[k].di = to.di, kinds[k].dj = to.dj;
            for (int parity = 0; parity < 4; ++parity) {
                const int i = halves_columns() ? parity & 1 : 0, j = halves_rows() ? parity >> 1 : 0;
                Weights first = weights_of(i, j);
                const Weights other = weights_of(i + to.di, j + to.dj);
                if (is_spring) {
                    for (const auto& [node, weight] : other) first[node] -= weight;
                }
                const Weights& second = is_spring ? first : other;
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
    void add(std::size_t number, const Blocks& terms) {
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
    void add_line(const Part& part, int node, int count) {
        for (int done = 0; done < count;) {
            float* const to = stencils.data() + Layout::first_entry(node + done, part.block);
            const int some = std::min(count - done, group - (node + done) % group);
            for (int e = 0; e < entries; ++e) {
                const float* const from = line.col(e).data() + done;
                for (int k = 0; k < some; ++k) to[e * group + k] += part.weight * from[k];
            }
            done += some;
        }
    }

    void add_matrix_of(const MultigridLevel& before, Blocks& scratch) {
        for (std::size_t k = 0; k < kinds.size(); ++k) {
            for (int p = 0; p < finer.particles(); ++p) {
                const std::array<float, entries> term = before.block(p, static_cast<int>(k));
                for (std::size_t e = 0; e < term.size(); ++e) scratch(p, static_cast<Eigen::Index>(e)) = term[e];
            }
            add(k, scratch);
        }
    }

    [[nodiscard]] std::array<float, entries> block(int node, int number) const {
        const float* const first = stencils.data() + Layout::first_entry(node, number);
        std::array<float, entries> of{};
        for (std::size_t e = 0; e < of.size(); ++e) of[e] = first[e * group];
        return of;
    }

    /// Of each node's own block, which is made a little stiffer: where springs are slack its smallest part is the mass,
    /// which single precision may have lost.
    void invert_diagonal() {
        for (int p = 0; p < grid.particles(); ++p) {
            float* const first = stencils.data() + Layout::first_entry(p, 0);
            const float more = least_part * (first[0] + first[3 * group] + first[5 * group]);
            for (const int e : {0, 3, 5}) first[e * group] += more;
            const auto [fxx, fxy, fxz, fyy, fyz, fzz] = block(p, 0);
            const double xx = fxx, xy = fxy, xz = fxz, yy = fyy, yz = fyz, zz = fzz;
            const double cxx = yy * zz - yz * yz, cxy = xz * yz - xy * zz, cxz = xy * yz - xz * yy;
            const double determinant = xx * cxx + xy * cxy + xz * cxz, scale = determinant > 0 ? 1 / determinant : 0;
            const std::array of{cxx, cxy, cxz, xx * zz - xz * xz, xy * xz - xx * yz, xx * yy - xy * xy};
            for (int e = 0; e < entries; ++e) {
                inverse(p, e) = static_cast<float>(scale * of[static_cast<std::size_t>(e)]);
            }
        }
    }

    void product(const Vectors& u, Vectors& y) const {
        if (plain) return multiply_plainly(u, y);
        kernels::multiply_stencils(stencils.data(), grid.particles(), shifts, u.data(), y.data());
    }

    /// Each block joins two nodes, and gives to both. A group of nodes after another, as the kernel does.
    void multiply_plainly(const Vectors& u, Vectors& y) const {
        const int nodes = grid.particles();
        y.setZero();
        for (int base = 0; base < nodes; base += group) {
            for (int k = 0; k < blocks; ++k) {
                const int shift = shifts[static_cast<std::size_t>(k)], end = std::min(base + group, nodes - shift);
                if (k > 0 && shift <= 0) continue;
                const auto add_product = [&](int block_of, int from, int to) {
                    const auto [xx, xy, xz, yy, yz, zz] = block(block_of, k);
                    const float ux = u(from, 0), uy = u(from, 1), uz = u(from, 2);
                    y(to, 0) += xx * ux + xy * uy + xz * uz;
                    y(to, 1) += xy * ux + yy * uy + yz * uz;
                    y(to, 2) += xz * ux + yz * uy + zz * uz;
                };
                for (int p = base; p < end; ++p) add_product(p, p + shift, p);
                for (int p = base; k > 0 && p < end; ++p) add_product(p, p, p + shift);
            }
        }
    }

    /// By powers of D^-1 A on a vector that changes from node to node.
    void find_bound() {
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
            multiply_blocks(inverse, residual, x);
            const float after = x.matrix().norm();
            if (!(after > 0)) break;
            bound = static_cast<double>(after / before);
            x *= before / after;
        }
        bound = std::max(missed * bound, 1.0);
    }

    /// Chebyshev's iteration for what is left of A x = b, which takes down the upper part of the spectrum of D^-1 A.
    /// @cite saad2003
    void smooth() {
        const double middle = bound * (1 + 1 / smoothed) / 2, half = bound * (1 - 1 / smoothed) / 2;
        double rho = half / middle;
        multiply_blocks(inverse, residual, step);
        step *= static_cast<float>(1 / middle);
        x += step;
        for (int k = 1; k < degree; ++k) {
            product(step, divided);
            residual -= divided;
            multiply_blocks(inverse, residual, divided);
            const double next = 1 / (2 * middle / half - rho);
            step = static_cast<float>(next * rho) * step + static_cast<float>(2 * next / half) * divided;
            x += step;
            rho = next;
        }
    }

    void find_residual() {
        product(x, residual);
        residual = b - residual;
    }

    /// What node k of a line gets from the n nodes of the finer one: a node between two gives half to each.
    template <class At>
    static float gathered(const At& at, int k, int n, bool halves) {
        if (!halves) return at(k);
        const float left = k > 0 ? at(2 * k - 1) : 0, right = 2 * k + 1 < n ? at(2 * k + 1) : 0;
        return (2 * k < n ? at(2 * k) : 0) + (left + right) / 2;
    }

    /// What node k of the finer line follows: between two nodes it has half of each.
    template <class At>
    static float interpolated(const At& at, int k, bool halves) {
        if (!halves) return at(k);
        return k % 2 != 0 ? (at(k / 2) + at(k / 2 + 1)) / 2 : at(k / 2);
    }

    /// b = P' fine
    void restrict_from(const Vectors& fine) {
        for (int axis = 0; axis < 3; ++axis) {
            const float* const from = fine.col(axis).data();
            float *const between = rows.col(axis).data(), *const to = b.col(axis).data();
            for (int j = 0; j < finer.ny; ++j) {
                const auto in_row = [&](int i) { return from[finer.particle(i, j)]; };
                for (int i = 0; i < grid.nx; ++i) {
                    between[grid.particle(i, j)] = gathered(in_row, i, finer.nx, halves_columns());
                }
            }
            for (int j = 0; j < grid.ny; ++j) {
                for (int i = 0; i < grid.nx; ++i) {
                    const auto in_column = [&](int row) { return between[grid.particle(i, row)]; };
                    to[grid.particle(i, j)] = gathered(in_column, j, finer.ny, halves_rows());
                }
            }
        }
    }

    /// fine += P x
    void add_correction(Vectors& fine) {
        for (int axis = 0; axis < 3; ++axis) {
            const float* const from = x.col(axis).data();
            float *const between = rows.col(axis).data(), *const to = fine.col(axis).data();
            for (int j = 0; j < finer.ny; ++j) {
                for (int i = 0; i < grid.nx; ++i) {
                    const auto in_column = [&](int row) { return from[grid.particle(i, row)]; };
                    between[grid.particle(i, j)] = interpolated(in_column, j, halves_rows());
                }
                const auto in_row = [&](int i) { return between[grid.particle(i, j)]; };
                for (int i = 0; i < finer.nx; ++i) {
                    to[finer.particle(i, j)] += interpolated(in_row, i, halves_columns());
                }
            }
        }
    }
};

}  // namespace drape
