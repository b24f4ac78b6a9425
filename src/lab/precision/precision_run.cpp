#include "precision_run.h"

#include <cmath>

#include "drape/base/numbers.h"
#include "drape/integrate/stability_trial.h"
#include "drape/model/energy.h"

namespace drape {
namespace {

Settings with_method(Settings settings, const IntegratorParameters& parameters) {
    settings.solver.integrator = parameters.kind;
    settings.solver.hessian = parameters.hessian;
    settings.solver.iterations = parameters.iterations;
    settings.solver.tolerance = parameters.tolerance;
    return settings;
}

}  // namespace

PrecisionRun::PrecisionRun(const PrecisionScene& scene, const IntegratorParameters& parameters,
                           const std::optional<ClothState>& start)
    : model_(make_cloth_model(scene.settings.cloths.front())),
      state_(start.value_or(make_rest_state(scene.settings.cloths.front()))),
      kernels_(parameters.kernels),
      energy_to_fail_(compute_energy(model_, state_, kernels_).total() + static_cast<double>(energy_to_fail(model_))) {
    if (scene.has_ball()) {
        simulation_.emplace(scene.name, with_method(scene.settings, parameters), StartState{0, {state_}});
    } else {
        integrator_ = make_integrator(parameters, model_.grid);
    }
}

SolveReport PrecisionRun::step(Real h) {
    if (!simulation_) return integrator_->step(model_, state_, h);
    if (static_cast<double>(h) != simulation_->settings().solver.dt) {
        simulation_->apply(command::Set{"solver.dt=" + real_text(static_cast<double>(h), 17)});
    }
    simulation_->step();
    return simulation_->report().solve;
}

const ClothModel& PrecisionRun::model() const { return model_; }

const ClothState& PrecisionRun::state() const { return simulation_ ? simulation_->cloths().front().state : state_; }

bool PrecisionRun::bounded() const {
    if (simulation_ && simulation_->report().status == Status::Diverged) return false;
    return state().x.allFinite() && compute_energy(model_, state(), kernels_).total() < energy_to_fail_;
}

std::vector<Real> steps_to(Real horizon, int count, Real phase) {
    const Real h = horizon / static_cast<Real>(count);
    std::vector<Real> steps(static_cast<std::size_t>(count), h);
    if (phase == 0) return steps;
    steps.front() = phase * h;
    steps.push_back((1 - phase) * h);
    return steps;
}

Finish finish(const PrecisionScene& scene, const IntegratorParameters& parameters, std::span<const Real> steps,
              const std::optional<ClothState>& start) {
    PrecisionRun run(scene, parameters, start);
    SolveReport report;
    for (const Real h : steps) report += run.step(h);
    return {run.state(), run.bounded(), report.iterations};
}

Quartiles cost_of(const PrecisionScene& scene, const IntegratorParameters& parameters, int steps, int repeats) {
    const std::vector<Real> lengths = steps_to(scene.horizon, steps);
    std::vector<double> costs;
    for (int repeat = 0; repeat <= repeats; ++repeat) {
        PrecisionRun run(scene, parameters);
        run.step(lengths.front());
        const double before = thread_cpu_time();
        for (const Real h : std::span(lengths).subspan(1)) run.step(h);
        const double seconds = thread_cpu_time() - before;
        if (repeat > 0) costs.push_back(seconds / static_cast<double>(scene.horizon - lengths.front()));
    }
    return quartiles_of(std::move(costs));
}

}  // namespace drape
