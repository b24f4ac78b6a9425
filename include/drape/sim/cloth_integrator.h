#pragma once

#include <memory>

#include "drape/base/snapshot_text.h"
#include "drape/integrate/integrator.h"

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

    /// Takes a new one, that knows of no step before.
    void use(const IntegratorParameters& parameters, const Grid& grid) {
        parameters_ = parameters;
        before_ = {};
        integrator_ = make_integrator(parameters_, grid);
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
    StepBefore before_;  ///< of a copy that has made none yet
    std::unique_ptr<Integrator> integrator_;
};

}  // namespace drape
