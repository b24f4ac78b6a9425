#include "drape/model/forces.h"

#include <algorithm>

#include "drape/base/assert.h"
#include "drape/model/force_sweep.h"
#include "force_kernels.h"
#include "wind.h"

namespace drape {
namespace {

using Use = std::function<void(const ForceRun&)>;

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

/// Sweeps over some rows in strips that are narrow enough for the kernels.
void sweep_rows(const kernels::ForceInput& input, int first_row, int last_row, const Use& use) {
    const int nx = input.model->grid.nx;
    for (int first = 0, columns = 0; first < nx; first += columns) {
        columns = std::min(kernels::most_columns, nx - first);
        kernels::forces_on(input, {first, columns, first_row, last_row - first_row}, use);
    }
}

}  // namespace

void compute_forces(const ClothModel& model, const Points& x, const Points& v, Points& f) {
    const Eigen::Index n = model.grid.particles();
    DRAPE_ASSERT(x.rows() == n && v.rows() == n && f.rows() == n);
    const auto keep = [&f](const ForceRun& run) {
        for (int axis = 0; axis < 3; ++axis) run.of(f, axis) = run.forces(axis);
    };
    sweep_rows(input_of(model, x, v, f), 0, model.grid.ny, std::cref(keep));
}

void forces_to_accelerations(const ClothModel& model, Points& f) {
    for (int axis = 0; axis < 3; ++axis) f.col(axis).array() *= model.inverse_mass;
}

void ForceSweep::sweep(const ClothModel& model, const Points& x, const Points& v, const Use& use) {
    constexpr int worth_a_thread = 8192;  // particles: with fewer, threads wait for one another longer than they work
    const Grid grid = model.grid;
    DRAPE_ASSERT(x.rows() == grid.particles() && v.rows() == grid.particles() && wind_.rows() == grid.particles());
    const kernels::ForceInput input = input_of(model, x, v, wind_);
    const int parts = std::clamp(grid.particles() / worth_a_thread, 1, std::min(workers_.threads(), grid.ny));
    const auto sweep_part = [&](int part) {
        sweep_rows(input, grid.ny * part / parts, grid.ny * (part + 1) / parts, use);
    };
    workers_.run(parts, std::cref(sweep_part));
}

}  // namespace drape
