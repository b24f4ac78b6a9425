#include "drape/model/forces.h"

#include <algorithm>

#include "drape/base/assert.h"
#include "drape/model/force_sweep.h"
#include "force_kernels.h"
#include "wind.h"

namespace drape {
namespace {

/// The input of the kernels. Where the wind blows, its forces are found on the way.
kernels::ForceInput input_of(const ClothModel& model, const Points& x, const Points& v, Points& wind) {
    kernels::ForceInput input{.model = &model,
                              .x = {x.col(0).data(), x.col(1).data(), x.col(2).data()},
                              .v = {v.col(0).data(), v.col(1).data(), v.col(2).data()},
                              .wind = {}};
    if (model.air.density > 0) {
        wind.setZero();
        Real* const f[3] = {wind.col(0).data(), wind.col(1).data(), wind.col(2).data()};
        kernels::wind_forces(model, input.x, input.v, f);
        std::copy(f, f + 3, input.wind);
    }
    return input;
}

}  // namespace

void compute_forces(const ClothModel& model, const Points& x, const Points& v, Points& f) {
    const Eigen::Index n = model.grid.particles();
    DRAPE_ASSERT(x.rows() == n && v.rows() == n && f.rows() == n);
    const auto keep = [&f](const ForceRun& run) {
        for (int axis = 0; axis < 3; ++axis) run.of(f, axis) = run.forces(axis);
    };
    const kernels::ForceInput input = input_of(model, x, v, f);

    // In strips, whose scratch fits on the stack
    constexpr int most_columns = 125;
    CacheLine memory[kernels::Scratch::cache_lines(most_columns)];
    const int nx = model.grid.nx;
    for (int first = 0, columns = 0; first < nx; first += columns) {
        columns = std::min(most_columns, nx - first);
        const kernels::Part part{first, columns, 0, model.grid.ny};
        const kernels::Scratch scratch(memory, columns);
        lay_out(model.grid, part, scratch);
        copy_neighbours(input, part, scratch);
        forces_on(input, part, scratch, std::cref(keep));
    }
}

void forces_to_accelerations(const ClothModel& model, Points& f) {
    for (int axis = 0; axis < 3; ++axis) f.col(axis).array() *= model.inverse_mass;
}

ForceSweep::ForceSweep(const Grid& grid, int threads) : grid_(grid), wind_(grid.particles(), 3), workers_(threads) {
    constexpr int worth_a_thread = 8192;  // particles: with fewer, threads wait for one another longer than they work
    const int parts = std::clamp(grid.particles() / worth_a_thread, 1, std::min(workers_.threads(), grid.ny));
    scratch_.resize(static_cast<std::size_t>(parts));
    for (int number = 0; number < parts; ++number) {
        scratch_[static_cast<std::size_t>(number)].resize(kernels::Scratch::cache_lines(grid.nx));
        lay_out(grid, part(number), scratch(number));
    }
}

kernels::Part ForceSweep::part(int number) const {
    const int parts = static_cast<int>(scratch_.size());
    const int first = grid_.ny * number / parts, last = grid_.ny * (number + 1) / parts;
    return {0, grid_.nx, first, last - first};
}

kernels::Scratch ForceSweep::scratch(int number) {
    return {scratch_[static_cast<std::size_t>(number)].data(), grid_.nx};
}

void ForceSweep::sweep(const ClothModel& model, const Points& x, const Points& v,
                       const std::function<void(const ForceRun&)>& use) {
    const Eigen::Index n = grid_.particles();
    DRAPE_ASSERT(model.grid == grid_ && x.rows() == n && v.rows() == n);
    const kernels::ForceInput input = input_of(model, x, v, wind_);
    const int parts = static_cast<int>(scratch_.size());
    const auto sweep_part = [&](int number) { forces_on(input, part(number), scratch(number), use); };
    for (int number = 0; number < parts; ++number) copy_neighbours(input, part(number), scratch(number));
    workers_.run(parts, std::cref(sweep_part));
}

}  // namespace drape
