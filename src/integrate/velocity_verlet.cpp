#include "drape/model/forces.h"
#include "explicit_methods.h"

namespace drape {
namespace {

/// x += h v + h^2/2 a_n; v += h/2 (a_n + a(x_{n+1}, v_n + h a_n)). Second order, with damping too.
class VelocityVerlet final : public Integrator {
public:
    explicit VelocityVerlet(int particles) : a_(particles, 3), a_next_(particles, 3), v_guess_(particles, 3) {}

    SolveReport step(const ClothModel& model, ClothState& state, Real h) override {
        compute_forces(model, state.x, state.v, a_);
        forces_to_accelerations(model, a_);
        v_guess_ = state.v + h * a_;
        state.x += h * state.v + (h * h / 2) * a_;
        compute_forces(model, state.x, v_guess_, a_next_);
        forces_to_accelerations(model, a_next_);
        state.v += (h / 2) * (a_ + a_next_);
        return {.force_evaluations = 2};
    }

private:
    Points a_, a_next_, v_guess_;
};

}  // namespace

std::unique_ptr<Integrator> make_velocity_verlet(int particles) { return std::make_unique<VelocityVerlet>(particles); }

}  // namespace drape
