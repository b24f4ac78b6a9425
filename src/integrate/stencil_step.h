#pragma once

#include <array>
#include <cstddef>

#include "kernels/stencil_kernels.h"

namespace drape {

/// The step that `kernels::take_step` makes, node by node, to the same bits.
inline void take_step_plainly(const kernels::StencilStep& step, int row, int nodes) {
    const kernels::StencilMatrix& a = *step.a;
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
    for (int i = 0; i < nodes; ++i) {
        const std::ptrdiff_t p = a.runs.at(row) + i;
        Vector r = at(step.from, p), product{};
        for (const auto& [block, to] : kernels::StencilTerms(a, row)) {
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

}  // namespace drape
