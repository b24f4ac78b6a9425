#pragma once

#include "drape/integrate/integrator.h"
#include "drape/model/force_sweep.h"

namespace drape {

/// Symplectic Euler: v += h a(x_n, v_n); x += h v. First order, symplectic without damping.
/// Explicit Euler does the same in the other order: it gains energy without enough damping.
/// @cite hairer2006 @cite euler1768
class Euler final : public Integrator {
public:
    Euler(const IntegratorParameters& parameters, const Grid& grid)
        : symplectic_(parameters.integrator == IntegratorKind::SymplecticEuler),
          forces_(grid, parameters.kernels, parameters.threads) {}

    SolveReport step(const ClothModel& model, ClothState& state, Real h) override {
        forces_(model, state.x, state.v, [&](const ForceRun& run) {
            if (!symplectic_) run.of(state.x) += h * run.of(state.v);
            run.of(state.v) += h * run.accelerations();
            if (symplectic_) run.of(state.x) += h * run.of(state.v);
        });
        return {.force_evaluations = 1};
    }

private:
    bool symplectic_;
    ForceSweep forces_;
};

/// x += h v + h^2/2 a_n; v += h/2 (a_n + a(x_{n+1}, v_n + h a_n)). Second order, with damping too.
/// @cite swope1982
class VelocityVerlet final : public Integrator {
public:
    VelocityVerlet(const IntegratorParameters& parameters, const Grid& grid)
        : forces_(grid, parameters.kernels, parameters.threads), a_(grid.particles(), 3), v_guess_(a_) {}

    SolveReport step(const ClothModel& model, ClothState& state, Real h) override {
        forces_(model, state.x, state.v, [&](const ForceRun& run) {
            run.of(a_) = run.accelerations();
            run.of(state.x) += h * run.of(state.v) + (h * h / 2) * run.of(a_);
            run.of(v_guess_) = run.of(state.v) + h * run.of(a_);
        });
        forces_(model, state.x, v_guess_,
                [&](const ForceRun& run) { run.of(state.v) += (h / 2) * (run.of(a_) + run.accelerations()); });
        return {.force_evaluations = 2};
    }

private:
    ForceSweep forces_;
    Points a_, v_guess_;
};

/// The classical Runge-Kutta method of order 4 on y = (x, v), y' = (v, a(x, v)):
/// k_1 = y'(y), k_2 = y'(y + h/2 k_1), k_3 = y'(y + h/2 k_2), k_4 = y'(y + h k_3); y += h/6 (k_1 + 2 k_2 + 2 k_3 +
/// k_4).
/// @cite kutta1901
class Rk4 final : public Integrator {
public:
    Rk4(const IntegratorParameters& parameters, const Grid& grid)
        : forces_(grid, parameters.kernels, parameters.threads),
          point_{Points(grid.particles(), 3), Points(grid.particles(), 3)},
          sum_(point_) {}

    SolveReport step(const ClothModel& model, ClothState& state, Real h) override {
        point_ = state;
        sum_.x.setZero();
        sum_.v.setZero();
        stage(model, state, 1, h / 2);
        stage(model, state, 2, h / 2);
        stage(model, state, 2, h);
        stage(model, state, 1, 0);
        state.x += (h / 6) * sum_.x;
        state.v += (h / 6) * sum_.v;
        return {.force_evaluations = 4};
    }

private:
    /// Adds k = y' at the point with its weight, and moves the point to the start + `time` k.
    void stage(const ClothModel& model, const ClothState& start, Real weight, Real time) {
        forces_(model, point_.x, point_.v, [&](const ForceRun& run) {
            run.of(sum_.x) += weight * run.of(point_.v);
            run.of(sum_.v) += weight * run.accelerations();
            run.of(point_.x) = run.of(start.x) + time * run.of(point_.v);
            run.of(point_.v) = run.of(start.v) + time * run.accelerations();
        });
    }

    ForceSweep forces_;
    ClothState point_, sum_;
};

}  // namespace drape
