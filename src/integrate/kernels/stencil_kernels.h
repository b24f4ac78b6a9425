#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "drape/model/stencils.h"

namespace drape::kernels {

/// Runs of numbers in single precision, each a number for every node of a grid's row, and zeros up to a whole vector of
/// any processor. Between two runs are zeros that a stencil reads beside a row, and that no step writes: other threads
/// may work on the rows next to it.
struct StencilRuns {
    static constexpr int lanes = 16;

    int nodes;
    int length;  ///< from a run to the next

    explicit StencilRuns(int of_row) : nodes(of_row), length((of_row + lanes - 1) / lanes * lanes + lanes) {}

    /// How many numbers some runs are, with what is read before the first and after the last.
    [[nodiscard]] std::size_t numbers(int runs) const { return static_cast<std::size_t>(at(runs)) + lanes; }

    /// Where the number of a run's first node stands.
    [[nodiscard]] std::ptrdiff_t at(int run) const { return lanes + static_cast<std::ptrdiff_t>(run) * length; }
};

/// The numbers of some runs, of which each begins a line of the cache: what vectors are best loaded from.
class StencilNumbers {
public:
    StencilNumbers(StencilRuns runs, int count) : lines_((runs.numbers(count) + line - 1) / line) {}

    [[nodiscard]] std::size_t size() const { return line * lines_.size(); }
    [[nodiscard]] const float* data() const { return lines_.data()->values; }
    [[nodiscard]] float* data() { return lines_.data()->values; }
    [[nodiscard]] std::span<float> all() { return {data(), size()}; }

private:
    static constexpr std::size_t line = 16;
    struct alignas(64) Line {
        float values[line] = {};
    };
    std::vector<Line> lines_;
};

/// A matrix of symmetric 3 x 3 blocks on a grid. Each node has those that join it with itself and with nodes after it.
struct StencilMatrix {
    static constexpr int entries = 6;  ///< of a block: xx, xy, xz, yy, yz, zz

    StencilRuns runs;
    int rows;
    std::vector<SpringDirection> offsets;  ///< from a node to the other of each block; to itself in the first
    StencilNumbers numbers;                ///< row by row of the grid, block by block, entry by entry

    StencilMatrix(const Grid& grid, std::vector<SpringDirection> to)
        : runs(grid.nx),
          rows(grid.ny),
          offsets(std::move(to)),
          numbers(runs, rows * static_cast<int>(offsets.size()) * entries) {}

    /// The first entries of a block of the nodes of a row; the others follow, each a run later.
    [[nodiscard]] const float* run(int row, std::size_t block) const { return numbers.data() + first(row, block); }
    [[nodiscard]] float* run(int row, std::size_t block) { return numbers.data() + first(row, block); }

private:
    [[nodiscard]] std::ptrdiff_t first(int row, std::size_t block) const {
        return runs.at((row * static_cast<int>(offsets.size()) + static_cast<int>(block)) * entries);
    }
};

/// Of a row: where a block's entries stand for its nodes, and from these to the others that it joins.
struct StencilTerm {
    const float* block;
    std::ptrdiff_t to;
};

/// The blocks that join the nodes of a row with others: their own, and those of the nodes before them.
struct StencilTerms {
    std::array<StencilTerm, 25> terms;
    std::size_t count = 0;

    StencilTerms(const StencilMatrix& a, int row) {
        for (std::size_t k = 0; k < a.offsets.size(); ++k) {
            const auto [di, dj] = a.offsets[k];
            const std::ptrdiff_t to = static_cast<std::ptrdiff_t>(dj) * a.runs.length + di;
            if (row + dj < a.rows) terms[count++] = {a.run(row, k), to};
            if (k > 0 && row >= dj) terms[count++] = {a.run(row - dj, k) - di, -to};
        }
    }
    [[nodiscard]] auto begin() const { return terms.begin(); }
    [[nodiscard]] auto end() const { return terms.begin() + count; }
};

/// r = from - A u and out = add + of_u u + of_r B r, where B has a block of its own for each node. All but A, B and
/// `from` may be null: not there, or not wanted.
struct StencilStep {
    const StencilMatrix* a;
    const float* b;  ///< run by run, by entry and row, as vectors are by coordinate and row
    const float *u, *from, *add = nullptr;
    float *r = nullptr, *out;
    float of_u, of_r;
};

/// Makes a step for the nodes of a row.
void take_step(const StencilStep& step, int row);

/// The same node by node, to the same bits.
inline void take_step_plainly(const StencilStep& step, int row) {
    const StencilMatrix& a = *step.a;
    const std::ptrdiff_t axis = static_cast<std::ptrdiff_t>(a.rows) * a.runs.length, entry = a.runs.length;
    using Vector = std::array<float, 3>;
    const auto at = [&](const float* vectors, std::ptrdiff_t p) {
        return Vector{vectors[p], vectors[p + axis], vectors[p + 2 * axis]};
    };
    const auto block_times = [](const float* block, std::ptrdiff_t next, const Vector& v) {
        const auto [x, y, z] = v;
        const float xy = block[next], xz = block[2 * next], yz = block[4 * next];
        return Vector{block[0] * x + xy * y + xz * z, xy * x + block[3 * next] * y + yz * z,
                      xz * x + yz * y + block[5 * next] * z};
    };
    for (int i = 0; i < a.runs.nodes; ++i) {
        const std::ptrdiff_t p = a.runs.at(row) + i;
        Vector r = at(step.from, p), product{};
        for (const auto& [block, to] : StencilTerms(a, row)) {
            if (step.u == nullptr) continue;
            const Vector one = block_times(block + i, entry, at(step.u, p + to));
            for (std::size_t k = 0; k < 3; ++k) product[k] += one[k];
        }
        for (std::size_t k = 0; k < 3; ++k) r[k] -= product[k];
        const Vector relaxed = block_times(step.b + p, axis, r);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::ptrdiff_t here = p + static_cast<std::ptrdiff_t>(k) * axis;
            if (step.r != nullptr) step.r[here] = r[k];
            if (step.out == nullptr) continue;
            float out = relaxed[k] * step.of_r;
            if (step.of_u != 0) out = step.u[here] * step.of_u + out;
            step.out[here] = step.add != nullptr ? step.add[here] + out : out;
        }
    }
}

}  // namespace drape::kernels
