#include "drape/sim/cloth_integrator.h"

namespace drape {

ClothIntegrator::ClothIntegrator(const ClothIntegrator& other)
    : parameters_(other.parameters_), before_(other.integrator_ ? other.integrator_->step_before() : other.before_) {}

ClothIntegrator& ClothIntegrator::operator=(const ClothIntegrator& other) { return *this = ClothIntegrator(other); }

void ClothIntegrator::use(const IntegratorParameters& parameters, const Grid& grid) {
    parameters_ = parameters;
    before_ = {};
    integrator_ = make_integrator(parameters_, grid);
}

SolveReport ClothIntegrator::step(const ClothModel& model, ClothState& state, Real h, EnergyFlow* start) {
    if (!integrator_) {
        integrator_ = make_integrator(parameters_, model.grid);
        if (before_.h > 0) integrator_->resume_after(before_);
    }
    return integrator_->step(model, state, h, start);
}

}  // namespace drape
