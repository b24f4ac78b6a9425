#pragma once

#include <cmath>
#include <memory>
#include <span>

#include "drape/base/snapshot_text.h"
#include "drape/integrate/integrator.h"
#include "drape/model/cloth_model.h"
#include "drape/sim/cloth_energy.h"
#include "drape/sim/contact_search.h"

namespace drape {

/// The integrator of a cloth. A copy makes one of its own at its first step, and goes on to the bit: what an integrator
/// keeps beside `StepBefore` is scratch, and may be much.
class ClothIntegrator {
public:
    ClothIntegrator() = default;
    ClothIntegrator(const ClothIntegrator& other)
        : parameters_(other.parameters_),
          before_(other.integrator_ ? other.integrator_->step_before() : other.before_) {}
    ClothIntegrator(ClothIntegrator&&) noexcept = default;
    ClothIntegrator& operator=(const ClothIntegrator& other) { return *this = ClothIntegrator(other); }
    ClothIntegrator& operator=(ClothIntegrator&&) noexcept = default;
    ~ClothIntegrator() = default;

    /// Takes a new one, which knows of no step before unless only the number of threads differs.
    void use(const IntegratorParameters& parameters, const Grid& grid) {
        parameters_.threads = parameters.threads;
        if (integrator_) before_ = integrator_->step_before();
        if (parameters != parameters_) before_ = {};
        parameters_ = parameters;
        integrator_ = make_integrator(parameters_, grid);
        if (before_.h > 0) integrator_->resume_after(before_);
    }

    /// What the next step goes on from.
    void exchange(SnapshotText& text, const ClothModel& model);

    /// As `Integrator::step`. @pre `use` was called
    SolveReport step(const ClothModel& model, ClothState& state, Real h) {
        if (!integrator_) {
            integrator_ = make_integrator(parameters_, model.grid);
            if (before_.h > 0) integrator_->resume_after(before_);
        }
        return integrator_->step(model, state, h);
    }

private:
    IntegratorParameters parameters_;
    StepBefore before_;  ///< where there is no integrator yet
    std::unique_ptr<Integrator> integrator_;
};

/// A cloth with all that its steps need.
struct Cloth {
    ClothModel model;
    ClothState state;
    ClothState previous;  ///< one step before `state`
    Points before;        ///< positions one substep before, where steps are divided
    ClothIntegrator integrator;
    ContactSearch search;
    ClothEnergy energy;
    int grabbed = -1;    ///< particle that the hand leads; below 0: none
    Real pin_speed = 0;  ///< of the fastest pin that `MovingPins` leads [m/s]
};

/// RMS speed of all particles in the last step, by what they have moved [m/s]. Velocities are no measure of rest: those
/// of cloth that penalties hold are what the forces of the next step take away again.
/// @param step its length [s]
[[nodiscard]] inline double rms_motion(std::span<const Cloth> cloths, double step) {
    Real squares = 0, particles = 0;
    for (const Cloth& cloth : cloths) {
        squares += (cloth.state.x - cloth.previous.x).squaredNorm();
        particles += static_cast<Real>(cloth.state.x.rows());
    }
    return static_cast<double>(std::sqrt(squares / particles)) / step;
}

}  // namespace drape
