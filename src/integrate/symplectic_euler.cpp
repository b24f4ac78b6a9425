#include "drape/model/forces.h"
#include "explicit_methods.h"

namespace drape {
namespace {

/// v += h a(x_n, v_n); x += h v. First order, symplectic without damping.
class SymplecticEuler final : public Integrator {
public:
    explicit SymplecticEuler(int particles) : a_(particles, 3) {}

    SolveReport step(const ClothModel& model, ClothState& state, Real h) override {
        compute_forces(model, state.x, state.v, a_);
        forces_to_accelerations(model, a_);
        state.v += h * a_;
        state.x += h * state.v;
        return {.force_evaluations = 1};
    }

private:
    Points a_;
};

}  // namespace

std::unique_ptr<Integrator> make_symplectic_euler(int particles) {
    return std::make_unique<SymplecticEuler>(particles);
}

}  // namespace drape
