#include "drape/model/force_sweep.h"
#include "methods.h"

namespace drape {
namespace {

/// x += h v + h^2/2 a_n; v += h/2 (a_n + a(x_{n+1}, v_n + h a_n)). Second order, with damping too.
/// @cite swope1982
class VelocityVerlet final : public Integrator {
public:
    VelocityVerlet(const IntegratorParameters& parameters, const Grid& grid)
        : forces_(grid, parameters.kernels, parameters.threads), a_(grid.particles(), 3), v_guess_(a_) {}

    SolveReport step(const ClothModel& model, ClothState& state, Real h, EnergyFlow* start) override {
        forces_(model, state.x, state.v, start, [&](const ForceRun& run) {
            run.of(a_) = run.accelerations();
            run.of(state.x) += h * run.of(state.v) + (h * h / 2) * run.of(a_);
            run.of(v_guess_) = run.of(state.v) + h * run.of(a_);
        });
        forces_(model, state.x, v_guess_,
                [&](const ForceRun& run) { run.of(state.v) += (h / 2) * (run.of(a_) + run.accelerations()); });
        return {.force_evaluations = 2};
    }

private:
    ForceSweep forces_;
    Points a_, v_guess_;
};

}  // namespace

std::unique_ptr<Integrator> make_velocity_verlet(const IntegratorParameters& parameters, const Grid& grid) {
    return std::make_unique<VelocityVerlet>(parameters, grid);
}

}  // namespace drape
