#include "drape/model/force_sweep.h"
#include "global_matrix.h"
#include "inertial_guess.h"
#include "methods.h"
#include "spring_passes.h"

namespace drape {
namespace {

/// Projective dynamics: minimises M/(2 h^2) |x - y|^2 + the springs' energy over x, with y the inertial guess, M = m +
/// h b. The local half of a round finds for each spring the vector of its rest length nearest to it, the global half
/// solves for the positions with those held. The change of x over both is G^-1 (M/h^2 (y - x) + f(x)), with f the
/// forces of the springs and G the global matrix, which is how it is computed.
///
/// The springs' damping is in the guess: before anything else, one implicit Gauss-Seidel pass over dampers slows the
/// velocities. So no step is too long for it, and a cloth at rest stays where its forces balance.
/// @cite liu2013 @cite bouaziz2014
class ProjectiveDynamics final : public Integrator {
public:
    ProjectiveDynamics(const IntegratorParameters& parameters, const Grid& grid)
        : iterations_(parameters.iterations),
          kernels_(parameters.kernels),
          inertial_(grid, parameters.kernels),
          dampers_(grid, parameters.kernels),
          forces_(grid, parameters.kernels),
          global_(grid),
          start_(grid.particles(), 3),
          guess_(grid.particles(), 3),
          r_(grid.particles(), 3) {}

    SolveReport step(const ClothModel& model, ClothState& state, Real h, EnergyFlow* start) override {
        if (start != nullptr) *start = compute_energy_flow(model, state.x, state.v, start_, kernels_);
        global_.prepare(model, h);
        keep_springs_of(model);
        damp(model, state, h);
        inertial_.advance(model, state, h);
        guess_ = state.x;
        const Real stiffness = inertia(model, h) / (h * h);
        Real first_gradient = 0, last_gradient = 0;
        for (int iteration = 0; iteration < iterations_; ++iteration) {
            forces_.compute(elastic_, state.x, state.v, r_);
            r_ += stiffness * (guess_ - state.x);
            for (int axis = 0; axis < 3; ++axis) {
                r_.col(axis) = (model.inverse_mass > 0).select(r_.col(axis).array(), Real(0));
            }
            if (iteration == 0) first_gradient = r_.norm();
            if (iteration == iterations_ - 1) last_gradient = r_.norm();
            global_.solve(r_);
            state.x += r_;
        }
        set_velocity_from_displacement(model, start_, h, state);
        return {.force_evaluations = 1 + iterations_,
                .iterations = iterations_,
                .residual = first_gradient > 0 ? last_gradient / first_gradient : Real(0)};
    }

private:
    void keep_springs_of(const ClothModel& model) {
        elastic_ = model;
        elastic_.structural.damping = elastic_.shear.damping = elastic_.bend.damping = 0;
        elastic_.gravity.setZero();
        elastic_.steady = nullptr;
        elastic_.drag = elastic_.air.density = 0;
    }

    /// Slows the springs' ends to where dampers alone would let them get.
    void damp(const ClothModel& model, ClothState& state, Real h) {
        auto springs = spring_stencils(model);
        for (SpringStencil& stencil : springs) stencil.law.stiffness = 0;
        start_ = state.x;
        state.x += h * state.v;
        dampers_.begin(model, h);
        dampers_.pass(springs, start_, state.x);
        set_velocity_from_displacement(model, start_, h, state);
        state.x = start_;
    }

    int iterations_;
    Kernels kernels_;
    InertialGuess inertial_;
    SpringPasses dampers_;
    ForceSweep forces_;
    GlobalMatrix global_;
    ClothModel elastic_;  ///< the model with nothing but its springs' stiffness
    Points start_, guess_, r_;
};

}  // namespace

std::unique_ptr<Integrator> make_projective_dynamics(const IntegratorParameters& parameters, const Grid& grid) {
    return std::make_unique<ProjectiveDynamics>(parameters, grid);
}

}  // namespace drape
