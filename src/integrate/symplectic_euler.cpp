#include "drape/base/vectorise.h"
#include "drape/model/force_sweep.h"
#include "explicit_methods.h"

namespace drape {
namespace {

/// Advances one coordinate of some neighbours.
DRAPE_VECTORISE void advance(const Real* __restrict f, const Real* __restrict inverse_mass, Real h, Eigen::Index count,
                             Real* __restrict x, Real* __restrict v) {
    for (Eigen::Index i = 0; i < count; ++i) {
        v[i] += h * (f[i] * inverse_mass[i]);
        x[i] += h * v[i];
    }
}

/// v += h a(x_n, v_n); x += h v. First order, symplectic without damping.
class SymplecticEuler final : public Integrator {
public:
    SymplecticEuler(const Grid& grid, int threads) : forces_(grid, threads) {}

    SolveReport step(const ClothModel& model, ClothState& state, Real h) override {
        forces_(model, state.x, state.v, [&](const ForceRun& run) {
            for (int axis = 0; axis < 3; ++axis) {
                advance(run.force[axis], model.inverse_mass.data() + run.first, h, run.count,
                        state.x.col(axis).data() + run.first, state.v.col(axis).data() + run.first);
            }
        });
        return {.force_evaluations = 1};
    }

private:
    ForceSweep forces_;
};

}  // namespace

std::unique_ptr<Integrator> make_symplectic_euler(const Grid& grid, int threads) {
    return std::make_unique<SymplecticEuler>(grid, threads);
}

}  // namespace drape
