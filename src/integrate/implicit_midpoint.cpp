#include "drape/model/forces.h"
#include "implicit_methods.h"
#include "newton_system.h"

namespace drape {
namespace {

/// One Newton step of x_{n+1} = x_n + h v_m, v_{n+1} = v_n + h a(x_m, v_m), with m the middle of n and n+1:
/// (m I + h/2 D + h^2/4 K) dv = h (f - h/2 K v); x += h (v + dv/2); v += dv. Second order with the exact slopes, first
/// order with the clamped ones; neither damps nor feeds a small oscillation.
/// @cite hairer2006
class ImplicitMidpoint final : public Integrator {
public:
    ImplicitMidpoint(const Grid& grid, Hessian hessian)
        : system_(grid, hessian), r_(grid.particles(), 3), dv_(grid.particles(), 3) {}

    SolveReport step(const ClothModel& model, ClothState& state, Real h) override {
        compute_forces(model, state.x, state.v, r_);
        system_.linearise(model, state.x, state.v);
        system_.add_stiffness(-h / 2, state.v, r_);
        r_ *= h;
        const krylov::Outcome solved = system_.solve(model, h / 2, r_, dv_);
        state.x += h * (state.v + dv_ / 2);
        state.v += dv_;
        return system_.report(solved);
    }

private:
    NewtonSystem system_;
    Points r_, dv_;
};

}  // namespace

std::unique_ptr<Integrator> make_implicit_midpoint(const Grid& grid, Hessian hessian) {
    return std::make_unique<ImplicitMidpoint>(grid, hessian);
}

}  // namespace drape
