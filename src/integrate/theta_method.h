#pragma once

#include "newton_system.h"

namespace drape {

/// One Newton step, or more (`newton_steps`), of x_{n+1} = x_n + h v_m, v_{n+1} = v_n + h a(x_m, v_m), with m at the
/// part theta of the way from n to n+1: with s = theta h and f at x + s v, (m I + s D + s^2 K) dv = h f;
/// x += h (v + theta dv); v += dv.
///
/// Backward Euler, theta = 1, is of first order and damps what it cannot resolve. Implicit midpoint, theta = 1/2, is of
/// second order; it neither damps nor feeds a small oscillation.
/// @cite baraff1998 @cite hairer2006
class ThetaMethod final : public Integrator {
public:
    ThetaMethod(const IntegratorParameters& parameters, const Grid& grid)
        : theta_(parameters.integrator == IntegratorKind::BackwardEuler ? Real(1) : Real(0.5)),
          system_(grid, parameters),
          dx_(grid.particles(), 3),
          r_(grid.particles(), 3),
          dv_(grid.particles(), 3) {}

    SolveReport step(const ClothModel& model, ClothState& state, Real h) override {
        const Real s = theta_ * h;
        dx_ = s * state.v;
        SolveReport report{.force_evaluations = system_.linearise_ahead(model, state, dx_, s, r_)};
        r_ *= h;
        report += system_.solve(model, s, r_, dv_);
        if (system_.refines()) {
            r_ = state.x + dx_;
            report += system_.refine(model, r_, state.v, s, theta_, dv_);
        }
        state.x += h * (state.v + theta_ * dv_);
        state.v += dv_;
        return report;
    }

private:
    Real theta_;
    NewtonSystem system_;
    Points dx_, r_, dv_;
};

}  // namespace drape
