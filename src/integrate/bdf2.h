#pragma once

#include "newton_system.h"

namespace drape {

/// One Newton step, or more (`newton_steps`), of the backward differentiation formula of order 2: with s = 2h/3,
/// x_{n+1} = x_n + (x_n - x_{n-1})/3 + s v_{n+1} and v_{n+1} = v_n + (v_n - v_{n-1})/3 + s a_{n+1} give
/// (m I + s D + s^2 K) dv = m (v_n - v_{n-1})/3 + s f, with f at x_n + (x_n - x_{n-1})/3 + s v_n.
/// Second order; damps what it cannot resolve, and the rest far less than backward Euler.
///
/// It keeps the state at the end of its last step and the one before. If it finds another state (contact, a hand,
/// another integrator), another step size or another revision of the model, it restarts with a step of backward Euler.
/// @cite choi2002
class Bdf2 final : public Integrator {
public:
    Bdf2(const IntegratorParameters& parameters, const Grid& grid)
        : system_(grid, parameters),
          dx_(grid.particles(), 3),
          r_(grid.particles(), 3),
          dv_(grid.particles(), 3),
          known_(grid.particles(), 3) {
        last_.from.x = last_.from.v = last_.to.x = last_.to.v = Points::Zero(grid.particles(), 3);  // no step allocates
    }

    [[nodiscard]] StepBefore step_before() const override { return last_; }
    void resume_after(const StepBefore& step) override { last_ = step; }

    SolveReport step(const ClothModel& model, ClothState& state, Real h) override {
        const bool goes_on =
            h == last_.h && model.revision == last_.revision && state.x == last_.to.x && state.v == last_.to.v;
        last_.h = h;
        last_.revision = model.revision;

        // s and the known part of dx = x_{n+1} - x_n; backward Euler is s = h without a past
        const Real s = goes_on ? 2 * h / 3 : h;
        dx_ = s * state.v;
        if (goes_on) dx_ += (state.x - last_.from.x) / 3;
        SolveReport report{.force_evaluations = system_.linearise_ahead(model, state, dx_, s, r_)};
        r_ *= s;
        if (goes_on) r_ += (model.particle_mass / 3) * (state.v - last_.from.v);
        report += system_.solve(model, s, r_, dv_);
        if (system_.refines()) report += refine(model, state, s, goes_on);
        dx_ += s * dv_;
        advance(model, h, state);
        return report;
    }

private:
    /// What is known of dv counts as part of v.
    SolveReport refine(const ClothModel& model, const ClothState& state, Real s, bool goes_on) {
        known_.setZero();
        if (goes_on) known_ = (state.v - last_.from.v) / 3;
        dv_ -= known_;
        r_ = state.x + dx_ + s * known_;
        known_ += state.v;
        const SolveReport report = system_.refine(model, r_, known_, s, 1, dv_);
        dv_ += known_ - state.v;
        return report;
    }

    /// By dx and dv, and keeps both ends of the step.
    void advance(const ClothModel& model, Real h, ClothState& state) {
        last_.from = state;
        for (int p = 0; p < model.grid.particles(); ++p) {
            if (model.pinned(p)) dx_.row(p) = h * state.v.row(p);
        }
        state.x += dx_;
        state.v += dv_;
        last_.to = state;
    }

    NewtonSystem system_;
    StepBefore last_;
    Points dx_, r_, dv_, known_;
};

}  // namespace drape
