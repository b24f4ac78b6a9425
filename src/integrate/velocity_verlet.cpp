#include "drape/model/force_sweep.h"
#include "explicit_methods.h"

namespace drape {
namespace {

/// x += h v + h^2/2 a_n; v += h/2 (a_n + a(x_{n+1}, v_n + h a_n)). Second order, with damping too.
class VelocityVerlet final : public Integrator {
public:
    VelocityVerlet(const Grid& grid, int threads)
        : forces_(grid, threads), a_(grid.particles(), 3), v_guess_(grid.particles(), 3) {}

    SolveReport step(const ClothModel& model, ClothState& state, Real h) override {
        forces_(model, state.x, state.v, [&](const ForceRun& run) {
            for (int axis = 0; axis < 3; ++axis) {
                run.of(a_, axis) = run.accelerations(axis);
                run.of(state.x, axis) += h * run.of(state.v, axis) + (h * h / 2) * run.of(a_, axis);
                run.of(v_guess_, axis) = run.of(state.v, axis) + h * run.of(a_, axis);
            }
        });
        forces_(model, state.x, v_guess_, [&](const ForceRun& run) {
            for (int axis = 0; axis < 3; ++axis) {
                run.of(state.v, axis) += (h / 2) * (run.of(a_, axis) + run.accelerations(axis));
            }
        });
        return {.force_evaluations = 2};
    }

private:
    ForceSweep forces_;
    Points a_, v_guess_;
};

}  // namespace

std::unique_ptr<Integrator> make_velocity_verlet(const Grid& grid, int threads) {
    return std::make_unique<VelocityVerlet>(grid, threads);
}

}  // namespace drape
