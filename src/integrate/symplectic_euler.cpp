#include "drape/model/force_sweep.h"
#include "methods.h"

namespace drape {
namespace {

/// v += h a(x_n, v_n); x += h v. First order, symplectic without damping.
/// @cite hairer2006
class SymplecticEuler final : public Integrator {
public:
    SymplecticEuler(const IntegratorParameters& parameters, const Grid& grid)
        : forces_(grid, parameters.kernels, parameters.threads) {}

    SolveReport step(const ClothModel& model, ClothState& state, Real h, EnergyFlow* start) override {
        forces_(model, state.x, state.v, start, [&](const ForceRun& run) {
            run.add_accelerations(h, state.v);
            run.add(h, state.v, state.x);
        });
        return {.force_evaluations = 1};
    }

private:
    ForceSweep forces_;
};

}  // namespace

std::unique_ptr<Integrator> make_symplectic_euler(const IntegratorParameters& parameters, const Grid& grid) {
    return std::make_unique<SymplecticEuler>(parameters, grid);
}

}  // namespace drape
