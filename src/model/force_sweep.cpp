#include "drape/model/force_sweep.h"

#include <algorithm>

#include "drape/base/assert.h"
#include "drape/model/forces.h"
#include "kernels/axes.h"
#include "kernels/force_kernels.h"

namespace drape {

ForceSweep::ForceSweep(const Grid& grid, Kernels kernels, int threads)
    : grid_(grid), kernels_(kernels), forces_(grid.particles(), 3), workers_(threads) {
    if (kernels == Kernels::Plain) return;
    constexpr int worth_a_thread = 8192;  // particles: with fewer, threads wait for one another longer than they work
    const int parts = std::clamp(grid.particles() / worth_a_thread, 1, std::min(workers_.threads(), grid.ny));
    for (int part = 0; part < parts; ++part) {
        parts_.emplace_back(grid, grid.ny * part / parts, grid.ny * (part + 1) / parts);
    }
}

ForceSweep::~ForceSweep() = default;

void ForceSweep::sweep(const ClothModel& model, const Points& x, const Points& v,
                       const std::function<void(const ForceRun&)>& use) {
    const Eigen::Index n = grid_.particles();
    DRAPE_ASSERT(model.grid == grid_ && x.rows() == n && v.rows() == n);
    if (kernels_ == Kernels::Plain) {
        compute_forces(model, x, v, forces_);
        use({0, n, forces_.data(), n, &model});
        return;
    }
    kernels::ForceInput input{.model = &model, .x = kernels::axes(x), .v = kernels::axes(v), .wind = {}};
    if (model.air.density > 0) {
        forces_.setZero();
        kernels::add_wind_forces(model, x, v, forces_);
        input.wind = kernels::axes(static_cast<const Points&>(forces_));
    }
    for (kernels::ForceScratch& part : parts_) copy_neighbours(input, part);
    const auto sweep_part = [&](int part) { forces_on(input, parts_[static_cast<std::size_t>(part)], use); };
    workers_.run(static_cast<int>(parts_.size()), std::cref(sweep_part));
}

}  // namespace drape
