#include "drape/model/force_sweep.h"
#include "explicit_methods.h"

namespace drape {
namespace {

/// x += h v; v += h a(x_n, v_n). First order; gains energy without enough damping.
class ExplicitEuler final : public Integrator {
public:
    ExplicitEuler(const Grid& grid, int threads) : forces_(grid, threads) {}

    SolveReport step(const ClothModel& model, ClothState& state, Real h) override {
        forces_(model, state.x, state.v, [&](const ForceRun& run) {
            for (int axis = 0; axis < 3; ++axis) {
                run.of(state.x, axis) += h * run.of(state.v, axis);
                run.of(state.v, axis) += h * run.accelerations(axis);
            }
        });
        return {.force_evaluations = 1};
    }

private:
    ForceSweep forces_;
};

}  // namespace

std::unique_ptr<Integrator> make_explicit_euler(const Grid& grid, int threads) {
    return std::make_unique<ExplicitEuler>(grid, threads);
}

}  // namespace drape
