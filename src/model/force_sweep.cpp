#include "drape/model/force_sweep.h"

#include <algorithm>

#include "drape/base/assert.h"
#include "drape/model/forces.h"
#include "kernels/axes.h"
#include "kernels/force_kernels.h"
#include "kernels/wind_kernels.h"

namespace drape {
namespace {

/// Adds up the rows, in their order: the bits do not depend on the number of threads.
EnergyFlow flow_of(const ClothModel& model, const std::vector<kernels::RowSums>& rows) {
    EnergyFlow flow;
    double squared_speeds = 0, falls = 0;
    for (const kernels::RowSums& row : rows) {
        squared_speeds += row.squared_speeds;
        falls += row.falls;
        flow.energy.spring += row.spring;
        flow.power.damping += row.damping;
        flow.power.wind += row.wind;
        flow.power.hand -= row.held;
    }
    const auto mass = static_cast<double>(model.particle_mass);
    flow.energy.kinetic = mass / 2 * squared_speeds;
    flow.energy.gravity = -mass * falls;
    flow.power.drag = static_cast<double>(model.drag) * squared_speeds;
    return flow;
}

}  // namespace

ForceSweep::ForceSweep(const Grid& grid, Kernels kernels, int threads)
    : grid_(grid), kernels_(kernels), forces_(grid.particles(), 3), workers_(threads) {
    if (kernels == Kernels::Plain) return;
    rows_.resize(static_cast<std::size_t>(grid.ny));
    constexpr int worth_a_thread = 8192;  // particles: with fewer, threads wait for one another longer than they work
    const int parts = std::clamp(grid.particles() / worth_a_thread, 1, std::min(workers_.threads(), grid.ny));
    for (int part = 0; part < parts; ++part) {
        parts_.emplace_back(grid, grid.ny * part / parts, grid.ny * (part + 1) / parts);
    }
}

ForceSweep::~ForceSweep() = default;

void ForceSweep::sweep(const ClothModel& model, const Points& x, const Points& v,
                       const std::function<void(const ForceRun&)>& use, EnergyFlow* flow) {
    const Eigen::Index n = grid_.particles();
    DRAPE_ASSERT(model.grid == grid_ && x.rows() == n && v.rows() == n);
    if (kernels_ == Kernels::Plain) {
        if (flow != nullptr) *flow = compute_energy_flow(model, x, v, forces_, kernels_);
        compute_forces(model, x, v, forces_);
        use({0, n, forces_.data(), n, &model});
        return;
    }
    kernels::ForceInput input{
        .model = &model, .x = kernels::axes(x), .v = kernels::axes(v), .wind = {}, .rows = nullptr};
    if (model.air.density > 0) {
        forces_.setZero();
        kernels::add_wind_forces(model, x, v, forces_);
        input.wind = kernels::axes(static_cast<const Points&>(forces_));
    }
    for (kernels::ForceScratch& part : parts_) copy_neighbours(input, part);
    const auto sweep_part = [&](int part) { forces_on(input, parts_[static_cast<std::size_t>(part)], use); };
    if (flow != nullptr) input.rows = rows_.data();
    workers_.run(static_cast<int>(parts_.size()), std::cref(sweep_part));
    if (flow == nullptr) return;
    *flow = flow_of(model, rows_);
}

}  // namespace drape
