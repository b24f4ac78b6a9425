#include "drape/model/force_sweep.h"
#include "methods.h"
#include "newton_system.h"

namespace drape {
namespace {

/// One Newton step of x_{n+1} = x_n + h v_{n+1}, v_{n+1} = v_n + h a_{n+1}:
/// (m I + h D + h^2 K) dv = h (f - h K v); v += dv; x += h v. First order; damps what it cannot resolve.
/// @cite baraff1998
class BackwardEuler final : public Integrator {
public:
    BackwardEuler(const IntegratorParameters& parameters, const Grid& grid)
        : forces_(grid, parameters.kernels),
          system_(grid, parameters.hessian, parameters.kernels),
          r_(grid.particles(), 3),
          dv_(grid.particles(), 3) {}

    SolveReport step(const ClothModel& model, ClothState& state, Real h, EnergyFlow* start) override {
        forces_.compute(model, state.x, state.v, r_, start);
        system_.linearise(model, state.x, state.v);
        system_.add_stiffness(-h, state.v, r_);
        r_ *= h;
        const krylov::Outcome solved = system_.solve(model, h, r_, dv_);
        state.v += dv_;
        state.x += h * state.v;
        return system_.report(solved);
    }

private:
    ForceSweep forces_;
    NewtonSystem system_;
    Points r_, dv_;
};

}  // namespace

std::unique_ptr<Integrator> make_backward_euler(const IntegratorParameters& parameters, const Grid& grid) {
    return std::make_unique<BackwardEuler>(parameters, grid);
}

}  // namespace drape
