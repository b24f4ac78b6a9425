#include "precision.h"

#include <span>

#include "drape/base/numbers.h"
#include "drape/integrate/stability_trial.h"
#include "drape/model/energy.h"
#include "drape/sim/simulation.h"
#include "lab/measure/methods.h"
#include "lab/measure/states.h"
#include "lab/measure/statistics.h"

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
PrecisionScene hung(const std::string& name, Real stiffness, Real damping, bool quick) {
    Settings settings;
    settings.cloths = {sheet(quick ? 6 : 16, stiffness, damping)};
    settings.cloths.front().pinned.kind = Pins::Kind::Two;
    const Rung before = solved_closely(Real(1e-11)), last = solved_closely(Real(1e-12));
    return {name, settings, Real(0.25), quick ? 7 : 8, quick ? 512 : 4096, 1, {before, before, last}};
}

/// Falls level on a small ball beside its middle. The first impact is at 0.2 s, the horizon 0.04 s later: while the
/// cloth folds about the ball, small errors do not grow yet. The ball is small because the response leaves contacts as
/// deep as a part of its radius, which no step makes smaller.
PrecisionScene dropped(bool quick) {
    Settings settings;
    settings.cloths = {sheet(quick ? 6 : 12, 300, Real(0.2))};
    settings.cloths.front().centred = true;
    const Real gap = Real(0.2), radius = Real(0.05);
    BallSettings ball;
    ball.radius = radius;
    ball.position = {Real(0.07), -(radius + settings.contact.thickness + gap), Real(0.04)};
    ball.motion = BallMotion::Still;
    settings.balls = {ball};
    settings.solver.sleep_speed = 0;
    const auto rung = [quick](int parts) {
        return Rung{{.kind = IntegratorKind::VelocityVerlet}, (quick ? 1 << 20 : 1 << 21) / parts};
    };
    return {"contact", settings, Real(0.24), 0, quick ? 512 : 2048, 8, {rung(16), rung(2), rung(1)}};
}

}  // namespace

std::vector<PrecisionScene> precision_scenes(bool quick) {
    return {hung("soft", 100, Real(0.05), quick), hung("stiff", 2000, Real(0.1), quick), dropped(quick)};
}

Rung solved_closely(Real tolerance) {
    constexpr int outer_steps = 8;
    return {{.kind = IntegratorKind::DormandPrince, .tolerance = tolerance}, outer_steps};
}

Finish finish(const PrecisionScene& scene, const Rung& rung, Real phase, const std::optional<ClothState>& start) {
    const ClothParameters& cloth = scene.settings.cloths.front();
    const ClothModel model = make_cloth_model(cloth);
    ClothState state = start.value_or(make_rest_state(cloth));
    const auto energy = [&] { return compute_energy(model, state, rung.parameters.kernels).total(); };
    const double highest = energy() + static_cast<double>(energy_to_fail(model));

    // By the integrator alone, or where there is a ball through `Simulation`
    const auto integrator = make_integrator(rung.parameters, model.grid);
    std::optional<Simulation> simulation;
    if (scene.has_ball()) {
        simulation.emplace(scene.name, with_method(scene.settings, rung.parameters), StartState{0, {state}});
    }
    const auto step = [&](Real h) {
        if (!simulation) return integrator->step(model, state, h);
        if (static_cast<double>(h) != simulation->settings().solver.dt) {
            simulation->apply(command::Set{"solver.dt=" + real_text(static_cast<double>(h), 17)});
        }
        simulation->step();
        return simulation->report().solve;
    };

    const Real h = scene.horizon / static_cast<Real>(rung.steps);
    std::vector<Real> steps(static_cast<std::size_t>(rung.steps), h);
    if (phase > 0) {
        steps.front() = phase * h;
        steps.push_back((1 - phase) * h);
    }
    SolveReport report = step(steps.front());
    const double seconds = cpu_time_of([&] {
        for (const Real length : std::span(steps).subspan(1)) report += step(length);
    });
    if (simulation) state = simulation->cloths().front().state;
    const bool diverged = simulation && simulation->report().status == Status::Diverged;
    return {state, !diverged && state.x.allFinite() && energy() < highest, report.iterations,
            seconds / static_cast<double>(scene.horizon - steps.front())};
}

Reference find_reference(const PrecisionScene& scene) {
    const ClothParameters& cloth = scene.settings.cloths.front();
    const ClothModel model = make_cloth_model(cloth);
    const ClothState start = make_rest_state(cloth), nudged = disturbed(model, start);
    const auto& [coarse, before, last] = scene.reference;
    const double small = static_cast<double>((nudged.x - start.x).norm());
    const Points apart = finish(scene, coarse, 0, nudged).state.x - finish(scene, coarse).state.x;
    const ClothState end = finish(scene, last).state;
    return {end, static_cast<double>(apart.norm()) / small,
            position_error(finish(scene, before).state.x, end.x, scene.side())};
}

}  // namespace drape
