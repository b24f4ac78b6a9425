#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "drape/base/kernels.h"
#include "drape/base/workers.h"
#include "drape/model/stencils.h"
#include "kernels/stencil_kernels.h"
#include "symmetric_blocks.h"

namespace drape {

/// The finest level of `Multigrid`, or one of every second column and row of a finer one, where that has more than two.
struct MultigridLevel {
    static constexpr int entries = kernels::StencilMatrix::entries;
    using Blocks = Eigen::Array<float, Eigen::Dynamic, entries>;  ///< xx, xy, xz, yy, yz, zz of each
    using Runs = kernels::StencilNumbers;  ///< a number for each node, by entry or coordinate and row

    /// By so much of their sum the diagonal entries are made larger.
    static constexpr float least_part = 1e-6F;

    /// Rounds that look for a level's largest eigenvalue, and what they may have missed.
    static constexpr int rounds = 6;
    static constexpr double missed = 1.15;

    /// Where the upper part of a spectrum begins: at its bound over this.
    static constexpr double smoothed = 4;

    /// Rows that a step reaches beside its own.
    static constexpr int reach = 2;

    /// The kinds of term that a level is added up from: of the particles alone and the six directions of springs at the
    /// finest two, of the blocks of a stencil on the others.
    static constexpr std::size_t own = 0, first_direction = 1;

    /// From a node to the others of its stencil: at the finest, itself and the other ends of its springs; else the two
    /// after it in its row, and five in each of two rows below.
    static std::vector<SpringDirection> offsets_of(bool finest) {
        std::vector<SpringDirection> all{{0, 0}};
        if (finest) {
            all.insert(all.end(), spring_directions.begin(), spring_directions.end());
            return all;
        }
        for (int dj = 0; dj <= reach; ++dj) {
            for (int di = dj == 0 ? 1 : -reach; di <= reach; ++di) all.push_back({di, dj});
        }
        return all;
    }

    /// What of a coarse matrix a term of the finer one is added to: a block of a node, and how much of the term.
    struct Part {
        int column, row;  ///< from the coarse node at or before the term's first one
        std::size_t block;
        float weight;
    };

    /// Terms that join a node with another: where they are added, for even and odd columns and rows.
    struct Kind {
        int di, dj;  ///< from the first to the other
        std::array<std::vector<Part>, 4> parts;
    };

    Grid finer, grid;
    kernels::StencilMatrix matrix;
    Runs inverse;      ///< of the diagonal blocks; zero where nothing moves
    double bound = 2;  ///< of the spectrum of D^-1 A
    Runs x, b, residual, step;
    std::vector<float> lines;  ///< scratch, of a row of the finer level for each entry
    std::vector<Kind> kinds;
    bool plain;  ///< steps in plain code, with the same bits
    LazyWorkers& workers;

    MultigridLevel(const Grid& finer_grid, const Grid& own_grid, Kernels kernels, LazyWorkers& threads)
        : finer(finer_grid),
          grid(own_grid),
          matrix(own_grid, offsets_of(grid == finer)),
          inverse(matrix.runs, entries * grid.ny),
          x(matrix.runs, 3 * grid.ny),
          b(x),
          residual(x),
          step(x),
          lines(static_cast<std::size_t>(entries * finer.nx)),
          plain(kernels == Kernels::Plain),
          workers(threads) {}

    [[nodiscard]] bool halves_columns() const { return grid.nx != finer.nx; }
    [[nodiscard]] bool halves_rows() const { return grid.ny != finer.ny; }

    /// The first number of a row of vectors.
    template <class Numbers>
    [[nodiscard]] auto* row_of(Numbers& vectors, int axis, int j) const {
        return vectors.data() + matrix.runs.at(axis * grid.ny + j);
    }

    [[nodiscard]] std::size_t block_at(int di, int dj) const {
        const auto is_it = [&](const SpringDirection& to) { return to.di == di && to.dj == dj; };
        return static_cast<std::size_t>(std::ranges::find_if(matrix.offsets, is_it) - matrix.offsets.begin());
    }

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
        const std::vector<SpringDirection> between = offsets_of(of_springs);
        kinds.resize(between.size());
        for (std::size_t k = 0; k < kinds.size(); ++k) {
            const bool is_spring = of_springs && k >= first_direction;
            const SpringDirection to = between[k];
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
                std::map<std::array<int, 4>, float> sums;  // by row and column of the node, and to the other
                for (const auto& [p, of_p] : first) {
                    for (const auto& [q, of_q] : second) {
                        if (is_square && q < p) continue;  // its other half
                        const auto [low, high] = std::minmax(p, q);
                        const float both = !is_square && p == q ? 2.0F : 1.0F;
                        sums[{low.first, low.second, high.first - low.first, high.second - low.second}] +=
                            both * of_p * of_q;
                    }
                }
                for (const auto& [place, weight] : sums) {
                    const auto [row, column, down, along] = place;
                    if (weight == 0) continue;
                    kinds[k].parts[static_cast<std::size_t>(parity)].push_back(
                        {column, row, block_at(along, down), weight});
                }
            }
        }
    }

    /// Forgets matrix and vectors. A NaN beside a row would stay there.
    void clear() {
        std::ranges::fill(matrix.numbers.all(), 0.0F);
        for (Runs* vectors : {&x, &b, &residual, &step}) std::ranges::fill(vectors->all(), 0.0F);
    }

    /// Adds all terms of a kind to the blocks that they belong to. Threads have entries of their own.
    /// @param terms terms(j, e) has entry e of them in a row, by their first nodes on the finer level
    template <class Terms>
    void add(std::size_t number, Terms terms) {
        workers.run(std::min(parts_of(finer), std::size_t{entries}), [&](int part, int among) {
            for (int e = part; e < entries; e += among) add_entry(kinds[number], e, terms);
        });
    }

    template <class Terms>
    void add_entry(const Kind& kind, int e, Terms terms) {
        const int stride = halves_columns() ? 2 : 1;
        float* const line = lines.data() + e * finer.nx;  // every second term beside each other
        for (int j = 0; j < finer.ny - kind.dj; ++j) {
            const int row = halves_rows() ? j / 2 : j, parity_of_row = halves_rows() ? j & 1 : 0;
            for (int first = std::max(-kind.di, 0), k = 0; k < stride; ++k, ++first) {
                const int count = (finer.nx - std::max(kind.di, 0) - first + stride - 1) / stride;
                const auto parity = static_cast<std::size_t>(2 * parity_of_row + (halves_columns() ? first & 1 : 0));
                const float* const from = terms(j, e) + first;
                for (int i = 0; i < count; ++i) line[i] = from[i * stride];
                for (const Part& part : kind.parts[parity]) {
                    float* const to = matrix.run(row + part.row, part.block) + e * matrix.runs.length;
                    float* const at = to + first / stride + part.column;
                    for (int i = 0; i < count; ++i) at[i] += part.weight * line[i];
                }
            }
        }
    }

    void add_matrix_of(const MultigridLevel& before) {
        const kernels::StencilMatrix& from = before.matrix;
        for (std::size_t k = 0; k < kinds.size(); ++k) {
            add(k, [&](int j, int e) { return from.run(j, k) + e * from.runs.length; });
        }
    }

    [[nodiscard]] std::array<float, entries> block(int i, int j, std::size_t number) const {
        std::array<float, entries> of{};
        for (int e = 0; e < entries; ++e) {
            of[static_cast<std::size_t>(e)] = matrix.run(j, number)[e * matrix.runs.length + i];
        }
        return of;
    }

    /// Of each node's own block, which is made a little stiffer: where springs are slack its smallest part is the mass,
    /// which single precision may have lost.
    void invert_diagonal() {
        const int length = matrix.runs.length;
        for_rows([&](int from, int end) {
            for (int p = grid.particle(0, from); p < grid.particle(0, end); ++p) {
                const int i = p % grid.nx, j = p / grid.nx;
                float* const first = matrix.run(j, 0) + i;
                const float more = least_part * (first[0] + first[3 * length] + first[5 * length]);
                for (const int e : {0, 3, 5}) first[e * length] += more;
                const auto [adjugate, determinant] = adjugate_of<double>(block(i, j, 0));
                const double scale = determinant > 0 ? 1 / determinant : 0;
                for (int e = 0; e < entries; ++e) {
                    row_of(inverse, e, j)[i] = static_cast<float>(scale * adjugate[static_cast<std::size_t>(e)]);
                }
            }
        });
    }

    /// In how many parts rows are shared among threads: each part has more nodes than a thread is started for, and more
    /// rows than steps reach beside it.
    [[nodiscard]] static std::size_t parts_of(const Grid& grid) {
        constexpr int worth_a_thread = 8192, least_rows = 16;
        return static_cast<std::size_t>(std::min(grid.particles() / worth_a_thread, grid.ny / least_rows));
    }

    /// Makes steps one after another for all nodes. A row's step needs what the one before has made of the rows within
    /// `reach`; it follows so closely that it finds these in the cache. Threads have rows of their own; what needs rows
    /// of two of them is left for the end.
    void sweep(std::span<const kernels::StencilStep> steps) {
        const auto take = [&](std::size_t number, int row) {
            (plain ? kernels::take_step_plainly : kernels::take_step)(steps[number], row);
        };
        const int last = static_cast<int>(steps.size()) - 1;
        int made = 1;
        workers.run(parts_of(grid), [&](int part, int count) {
            const int from = grid.ny * part / count, end = grid.ny * (part + 1) / count;
            if (part == 0) made = count;
            for (int j = from; j < end + reach * last; ++j) {
                for (int s = 0; s <= last; ++s) {
                    const int row = j - reach * s;
                    const int first = part == 0 ? 0 : from + reach * s;
                    const int beyond = part == count - 1 ? grid.ny : end - reach * s;
                    if (row >= first && row < beyond) take(static_cast<std::size_t>(s), row);
                }
            }
        });
        for (int s = 1; s <= last; ++s) {
            for (int part = 1; part < made; ++part) {
                const int border = grid.ny * part / made;
                for (int row = border - reach * s; row < border + reach * s; ++row) {
                    take(static_cast<std::size_t>(s), row);
                }
            }
        }
    }

    /// out = of_u u + of_r D^-1 (from - A u), which is Chebyshev's iteration with the right factors.
    kernels::StencilStep step_of(const Runs* u, const Runs& from, Runs& out, double of_u, double of_r) const {
        return {.a = &matrix,
                .b = inverse.data(),
                .u = u != nullptr ? u->data() : nullptr,
                .from = from.data(),
                .out = out.data(),
                .of_u = static_cast<float>(of_u),
                .of_r = static_cast<float>(of_r)};
    }

    /// Of two steps of Chebyshev's iteration, which take down the upper part of the spectrum of D^-1 A: of D^-1 r in
    /// the first; of the first and of D^-1 r in the second.
    /// @cite saad2003
    struct Chebyshev {
        double first, again, second;
    };
    [[nodiscard]] Chebyshev chebyshev() const {
        const double middle = bound * (1 + 1 / smoothed) / 2, half = bound * (1 - 1 / smoothed) / 2;
        const double next = 1 / (2 * middle / half - half / middle);
        return {1 / middle, next * half / middle, 2 * next / half};
    }

    /// x = about A^-1 b, and the residual b - A x.
    void smooth_from_zero() {
        const auto [first, again, second] = chebyshev();
        kernels::StencilStep left = step_of(&x, b, x, 0, 0);
        left.r = residual.data(), left.out = nullptr;
        sweep(std::array{step_of(nullptr, b, step, 0, first), step_of(&step, b, x, 1 + again, second), left});
    }

    /// The same from an x, without the residual.
    void smooth() {
        const auto [first, again, second] = chebyshev();
        kernels::StencilStep begin = step_of(&x, b, step, 0, first);
        kernels::StencilStep end = step_of(&step, residual, x, 1 + again, second);
        begin.r = residual.data(), end.add = x.data();
        sweep(std::array{begin, end});
    }

    /// By powers of D^-1 A on a vector that changes from node to node.
    /// @pre `clear` was called, and b is still zero
    void find_bound() {
        for_each_row([&](int axis, int j) {
            for (int i = 0; i < grid.nx; ++i) {
                const int turn = (7 * i + 13 * j + 29 * axis) % 11;
                row_of(x, axis, j)[i] = ((i + j) % 2 == 0 ? 1.0F : -1.0F) * (1 + 0.1F * static_cast<float>(turn));
            }
        });
        const auto norm = [](Runs& of) {
            double squares = 0;
            for (const float one : of.all()) squares += static_cast<double>(one) * one;
            return std::sqrt(squares);
        };
        bound = 0;
        for (int round = 0; round < rounds; ++round) {
            sweep(std::array{step_of(&x, b, step, 0, -1)});
            const double before = norm(x), after = norm(step);
            if (!(after > 0)) break;
            bound = after / before;
            std::ranges::transform(step.all(), x.data(),
                                   [&](float one) { return static_cast<float>(before / after) * one; });
        }
        bound = std::max(missed * bound, 1.0);
    }

    /// Calls visit(from, end) for runs of rows, shared among threads.
    template <class Visit>
    void for_rows(Visit visit) {
        workers.run(parts_of(grid),
                    [&](int part, int among) { visit(grid.ny * part / among, grid.ny * (part + 1) / among); });
    }

    /// Calls visit(axis, j) for all rows of vectors, shared among threads.
    template <class Visit>
    void for_each_row(Visit visit) {
        for_rows([&](int from, int end) {
            for (int j = from; j < end; ++j) {
                for (int axis = 0; axis < 3; ++axis) visit(axis, j);
            }
        });
    }

    /// b = P' r, with r of the finer level: a node gets half of what is between it and the next.
    void restrict_from(const MultigridLevel& fine) {
        for_each_row([&](int axis, int j) {
            const auto row = [&](int k) {
                return k >= 0 && k < finer.ny ? fine.row_of(fine.residual, axis, k) : nullptr;
            };
            const int k = halves_rows() ? 2 * j : j;
            const float* const here = row(k);
            const float* const above = halves_rows() ? row(k - 1) : nullptr;
            const float* const below = halves_rows() ? row(k + 1) : nullptr;
            const auto at = [&](int i) {
                float sum = here != nullptr ? here[i] : 0;
                if (above != nullptr) sum += above[i] / 2;
                if (below != nullptr) sum += below[i] / 2;
                return sum;
            };
            float* const to = row_of(b, axis, j);
            for (int i = 0; i < grid.nx; ++i) {
                to[i] = halves_columns() ? at(2 * i) + (at(2 * i - 1) + at(2 * i + 1)) / 2 : at(i);
            }
        });
    }

    /// x += P c of the finer level, with c the x of this one: what is between two nodes gets half of each.
    void add_correction_to(MultigridLevel& fine) {
        fine.for_each_row([&](int axis, int j) {
            const int row = halves_rows() ? j / 2 : j, next = halves_rows() ? row + j % 2 : row;
            const float *const one = row_of(x, axis, row), *const other = row_of(x, axis, next);
            const auto at = [&](int i) { return (one[i] + other[i]) / 2; };
            float* const to = fine.row_of(fine.x, axis, j);
            for (int i = 0; i < finer.nx; ++i) {
                to[i] += !halves_columns() ? at(i) : i % 2 == 0 ? at(i / 2) : (at(i / 2) + at(i / 2 + 1)) / 2;
            }
        });
    }
};

}  // namespace drape
