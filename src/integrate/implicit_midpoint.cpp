#include "drape/model/force_sweep.h"
#include "methods.h"
#include "newton_system.h"

namespace drape {
namespace {

/// One Newton step of x_{n+1} = x_n + h v_m, v_{n+1} = v_n + h a(x_m, v_m), with m the middle of n and n+1:
/// (m I + h/2 D + h^2/4 K) dv = h (f - h/2 K v); x += h (v + dv/2); v += dv. Second order with the exact Hessian,
/// first order with the clamped one; neither damps nor feeds a small oscillation.
/// @cite hairer2006
class ImplicitMidpoint final : public Integrator {
public:
    ImplicitMidpoint(const IntegratorParameters& parameters, const Grid& grid)
        : forces_(grid, parameters.kernels),
          system_(grid, parameters.hessian, parameters.kernels),
          r_(grid.particles(), 3),
          dv_(grid.particles(), 3) {}

    SolveReport step(const ClothModel& model, ClothState& state, Real h, EnergyFlow* start) override {
        forces_.compute(model, state.x, state.v, r_, start);
        system_.linearise(model, state.x, state.v);
        system_.add_stiffness(-h / 2, state.v, r_);
        r_ *= h;
        const krylov::Outcome solved = system_.solve(model, h / 2, r_, dv_);
        state.x += h * (state.v + dv_ / 2);
        state.v += dv_;
        return system_.report(solved);
    }

private:
    ForceSweep forces_;
    NewtonSystem system_;
    Points r_, dv_;
};

}  // namespace

std::unique_ptr<Integrator> make_implicit_midpoint(const IntegratorParameters& parameters, const Grid& grid) {
    return std::make_unique<ImplicitMidpoint>(parameters, grid);
}

}  // namespace drape
