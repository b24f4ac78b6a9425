#include "drape/model/force_sweep.h"
#include "methods.h"

namespace drape {
namespace {

/// x += h v; v += h a(x_n, v_n). First order; gains energy without enough damping.
/// @cite euler1768
class ExplicitEuler final : public Integrator {
public:
    ExplicitEuler(const IntegratorParameters& parameters, const Grid& grid)
        : forces_(grid, parameters.kernels, parameters.threads) {}

    SolveReport step(const ClothModel& model, ClothState& state, Real h, EnergyFlow* start) override {
        forces_(model, state.x, state.v, start, [&](const ForceRun& run) {
            run.add(h, state.v, state.x);
            run.add_accelerations(h, state.v);
        });
        return {.force_evaluations = 1};
    }

private:
    ForceSweep forces_;
};

}  // namespace

std::unique_ptr<Integrator> make_explicit_euler(const IntegratorParameters& parameters, const Grid& grid) {
    return std::make_unique<ExplicitEuler>(parameters, grid);
}

}  // namespace drape
