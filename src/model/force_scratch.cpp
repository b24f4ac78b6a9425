#include "force_scratch.h"

#include "drape/model/stencils.h"

namespace drape::kernels {

void copy_row(const ForceInput& input, const Strip& strip, int row, const Scratch& scratch) {
    if (row >= strip.grid.ny) return;
    const int slot = strip.slot(row), p = strip.grid.particle(strip.first, row), count = strip.end - strip.first;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::copy_n(input.x[axis] + p, count, scratch.x(slot)[axis] + Scratch::margin);
        std::copy_n(input.v[axis] + p, count, scratch.v(slot)[axis] + Scratch::margin);
        if (input.wind[0] != nullptr)
            std::copy_n(input.wind[axis] + p, count, scratch.wind(slot)[axis] + Scratch::margin);
    }
}

void prepare(const ForceInput& input, const Part& part, const Scratch& scratch) {
    scratch.clear();
    const Strip strip(part, input.model->grid);
    const auto springs = spring_stencils(*input.model);
    for (int s = 0; s < 6; ++s) {
        const int di = springs[static_cast<std::size_t>(s)].di;
        const int first = std::max(strip.first, -di), last = std::min(strip.end, strip.grid.nx - di);
        if (first < last) std::fill_n(scratch.there(s) + strip.at(first), last - first, Real(1));
    }
    for (int row = std::max(part.first_row - 2, 0); row < part.first_row; ++row) copy_row(input, strip, row, scratch);
    for (int row = strip.end_row; row < strip.end_row + 2; ++row) copy_row(input, strip, row, scratch);
}

}  // namespace drape::kernels
