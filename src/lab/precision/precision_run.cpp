#include "precision.h"

#include <array>
#include <memory>

#include "drape/base/assert.h"
#include "drape/base/numbers.h"
#include "drape/integrate/stability_trial.h"
#include "drape/model/energy.h"
#include "drape/sim/simulation.h"

namespace drape {
namespace {

/// Drag of the whole cloth [N s/m]: a tenth of its speed in 0.04 s.
constexpr Real whole_drag = Real(0.5);

ClothParameters sheet(int particles, Real stiffness, Real damping) {
    ClothParameters cloth;
    cloth.particles = {particles, particles};
    cloth.structural = {stiffness, damping};
    cloth.shear = {stiffness / 2, damping};
    cloth.bend = {stiffness / 10, damping};
    cloth.drag = whole_drag / static_cast<Real>(cloth.particles.particles());
    return cloth;
}

/// Held level by two corners and let go.
PrecisionScene hung(const std::string& name, int particles, Real stiffness, Real damping, int rungs, int finest_steps) {
    Settings settings;
    settings.cloths = {sheet(particles, stiffness, damping)};
    settings.cloths.front().pinned.kind = Pins::Kind::Two;
    return {name, settings, Real(0.25), rungs, finest_steps, 0, 1};
}

/// Falls level on a small ball beside its middle. The first impact is at 0.2 s, the horizon 0.04 s later: while the
/// cloth folds about the ball, small errors do not grow yet. The ball is small because the response leaves contacts as
/// deep as a part of its radius, which no step makes smaller.
PrecisionScene dropped(int particles, int finest_steps, int reference_steps, int phases) {
    Settings settings;
    settings.cloths = {sheet(particles, 300, Real(0.2))};
    settings.cloths.front().centred = true;
    const Real gap = Real(0.2), radius = Real(0.05);
    BallSettings ball;
    ball.radius = radius;
    ball.position = {Real(0.07), -(radius + settings.contact.thickness + gap), Real(0.04)};
    ball.motion = BallMotion::Still;
    settings.balls = {ball};
    settings.solver.sleep_speed = 0;
    settings.solver.ledger = false;
    return {"contact", settings, Real(0.24), 0, finest_steps, reference_steps, phases};
}

Settings with_method(Settings settings, const IntegratorParameters& parameters) {
    settings.solver.integrator = parameters.kind;
    settings.solver.hessian = parameters.hessian;
    settings.solver.iterations = parameters.iterations;
    settings.solver.tolerance = parameters.tolerance;
    return settings;
}

/// A scene on its way under one method: by the integrator alone, or where there is a ball through `Simulation`.
class PrecisionRun {
public:
    /// @param start where it begins if not at rest
    PrecisionRun(const PrecisionScene& scene, const IntegratorParameters& parameters,
                 const std::optional<ClothState>& start = {})
        : model_(make_cloth_model(scene.settings.cloths.front())),
          state_(start.value_or(make_rest_state(scene.settings.cloths.front()))),
          kernels_(parameters.kernels),
          energy_to_fail_(compute_energy(model_, state_, kernels_).total() +
                          static_cast<double>(energy_to_fail(model_))) {
        if (scene.has_ball()) {
            simulation_.emplace(scene.name, with_method(scene.settings, parameters), StartState{0, {state_}});
        } else {
            integrator_ = make_integrator(parameters, model_.grid);
        }
    }

    SolveReport step(Real h) {
        if (!simulation_) return integrator_->step(model_, state_, h);
        if (static_cast<double>(h) != simulation_->settings().solver.dt) {
            simulation_->apply(command::Set{"solver.dt=" + real_text(static_cast<double>(h), 17)});
        }
        simulation_->step();
        return simulation_->report().solve;
    }

    [[nodiscard]] const ClothState& state() const { return simulation_ ? simulation_->cloths().front().state : state_; }

    /// False once a number is none, or the energy has risen as far as counts as diverged.
    [[nodiscard]] bool bounded() const {
        if (simulation_ && simulation_->report().status == Status::Diverged) return false;
        return state().x.allFinite() && compute_energy(model_, state(), kernels_).total() < energy_to_fail_;
    }

private:
    ClothModel model_;
    ClothState state_;
    Kernels kernels_;
    double energy_to_fail_;
    std::unique_ptr<Integrator> integrator_;
    std::optional<Simulation> simulation_;
};

/// Growth is found on a rung of its own, which may be less fine.
Reference reference_of(const PrecisionScene& scene, const Rung& coarse, const Rung& before, const Rung& last) {
    const ClothParameters& cloth = scene.settings.cloths.front();
    const ClothModel model = make_cloth_model(cloth);
    const ClothState start = make_rest_state(cloth), nudged = disturbed(model, start);
    const double small = static_cast<double>((nudged.x - start.x).norm());
    const Points apart = finish(scene, coarse, 0, nudged).state.x - finish(scene, coarse).state.x;
    Reference reference;
    reference.growth = static_cast<double>(apart.norm()) / small;
    reference.measure = measure_for(reference.growth);
    reference.state = finish(scene, last).state;
    reference.error = error_of(reference.measure, model, finish(scene, before).state, reference.state, scene.side());
    return reference;
}

}  // namespace

std::vector<PrecisionScene> precision_scenes(bool quick) {
    const int particles = quick ? 6 : 16, rungs = quick ? 7 : 8, steps = quick ? 512 : 4096;
    return {hung("soft", particles, 100, Real(0.05), rungs, steps),
            hung("stiff", particles, 2000, Real(0.1), rungs, steps),
            quick ? dropped(6, 512, 1 << 20, 8) : dropped(12, 2048, 1 << 21, 8)};
}

std::vector<Real> steps_to(Real horizon, int count, Real phase) {
    const Real h = horizon / static_cast<Real>(count);
    std::vector<Real> steps(static_cast<std::size_t>(count), h);
    if (phase == 0) return steps;
    steps.front() = phase * h;
    steps.push_back((1 - phase) * h);
    return steps;
}

Finish finish(const PrecisionScene& scene, const Rung& rung, Real phase, const std::optional<ClothState>& start) {
    PrecisionRun run(scene, rung.parameters, start);
    SolveReport report;
    for (const Real h : steps_to(scene.horizon, rung.steps, phase)) report += run.step(h);
    return {run.state(), run.bounded(), report.iterations};
}

Quartiles cost_of(const PrecisionScene& scene, const Rung& rung, int repeats) {
    const std::vector<Real> lengths = steps_to(scene.horizon, rung.steps);
    std::vector<double> costs;
    for (int repeat = 0; repeat <= repeats; ++repeat) {
        PrecisionRun run(scene, rung.parameters);
        run.step(lengths.front());
        const double seconds = cpu_time_of([&] {
            for (const Real h : std::span(lengths).subspan(1)) run.step(h);
        });
        if (repeat > 0) costs.push_back(seconds / static_cast<double>(scene.horizon - lengths.front()));
    }
    return quartiles_of(std::move(costs));
}

Reference find_reference(const PrecisionScene& scene, std::span<const Real> tolerances) {
    DRAPE_ASSERT(tolerances.size() >= 2 && !scene.has_ball());
    const auto rung = [](Real tolerance) {
        return Rung{{.kind = IntegratorKind::DormandPrince, .tolerance = tolerance}, outer_steps};
    };
    const Rung before = rung(tolerances[tolerances.size() - 2]);
    return reference_of(scene, before, before, rung(tolerances.back()));
}

Reference find_reference(const PrecisionScene& scene) {
    if (!scene.has_ball()) return find_reference(scene, std::array{Real(1e-11), Real(1e-12)});
    const auto rung = [&scene](int parts) {
        return Rung{{.kind = IntegratorKind::VelocityVerlet}, scene.reference_steps / parts};
    };
    return reference_of(scene, rung(16), rung(2), rung(1));
}

}  // namespace drape
