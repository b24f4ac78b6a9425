#pragma once

#include "drape/integrate/integrator.h"
#include "spring_passes.h"

namespace drape {

/// Extended position-based dynamics: a guess without the springs, corrected by Gauss-Seidel passes over them, each a
/// constraint of compliance 1/k with its own damping. Many short steps of one pass serve better than one of many. The
/// springs are too soft until the passes have settled; then the step is backward Euler's, but for the turning of
/// springs within it.
/// @cite macklin2016 @cite macklin2019
class Xpbd final : public Integrator {
public:
    Xpbd(const IntegratorParameters& parameters, const Grid& grid)
        : iterations_(parameters.iterations),
          guess_(grid, parameters.kernels),
          passes_(grid, parameters.kernels),
          start_(grid.particles(), 3) {}

    SolveReport step(const ClothModel& model, ClothState& state, Real h) override {
        start_ = state.x;
        find_inertia(model, state, h, inertia_);
        guess_.advance(model, inertia_, state, h);
        passes_.begin(model, inertia_, h);
        const auto springs = spring_stencils(model);
        for (int iteration = 0; iteration < iterations_; ++iteration) passes_.pass(springs, start_, state.x);
        set_velocity_from_displacement(model, start_, h, state);
        return {.force_evaluations = 1, .iterations = iterations_};
    }

private:
    int iterations_;
    InertialGuess guess_;
    SpringPasses passes_;
    Numbers inertia_;
    Points start_;
};

}  // namespace drape
