#include "drape/model/forces.h"
#include "explicit_methods.h"

namespace drape {
namespace {

/// x += h v; v += h a(x_n, v_n). First order; gains energy without enough damping.
class ExplicitEuler final : public Integrator {
public:
    explicit ExplicitEuler(int particles) : a_(particles, 3) {}

    SolveReport step(const ClothModel& model, ClothState& state, Real h) override {
        compute_forces(model, state.x, state.v, a_);
        forces_to_accelerations(model, a_);
        state.x += h * state.v;
        state.v += h * a_;
        return {.force_evaluations = 1};
    }

private:
    Points a_;
};

}  // namespace

std::unique_ptr<Integrator> make_explicit_euler(int particles) { return std::make_unique<ExplicitEuler>(particles); }

}  // namespace drape
