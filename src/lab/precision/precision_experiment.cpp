#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>

#include "drape/base/numbers.h"
#include "drape/integrate/stability.h"
#include "drape/integrate/stability_trial.h"
#include "drape/model/energy.h"
#include "drape/sim/simulation.h"
#include "lab/experiments.h"
#include "lab/measure/methods.h"
#include "precision.h"

namespace drape {
namespace {

/// Held level by two corners and let go.
PrecisionScene hung(const std::string& name, Real stiffness, Real damping, bool quick) {
    Settings settings;
    settings.cloths = {sheet_of(quick ? 6 : 16, stiffness, damping)};
    settings.cloths.front().pinned.kind = Pins::Kind::Two;
    const Rung before = solved_closely(Real(1e-11)), last = solved_closely(Real(1e-12));
    return {name, settings, Real(0.25), quick ? 7 : 8, quick ? 512 : 4096, 1, {before, before, last}};
}

/// Falls level on a small ball beside its middle. The first impact is at 0.2 s, the horizon 0.04 s later: while the
/// cloth folds about the ball, small errors do not grow yet. The ball is small because the response leaves contacts as
/// deep as a part of its radius, which no step makes smaller.
PrecisionScene dropped(bool quick) {
    Settings settings;
    settings.cloths = {sheet_of(quick ? 6 : 12, 300, Real(0.2))};
    settings.cloths.front().centred = true;
    const Real gap = Real(0.2), radius = Real(0.05);
    BallSettings& ball = settings.balls.emplace_back();
    ball.radius = radius;
    ball.position = {Real(0.07), -(radius + settings.contact.thickness + gap), Real(0.04)};
    ball.motion = BallMotion::Still;
    settings.solver.sleep_speed = 0;
    const auto rung = [quick](int parts) {
        return Rung{{.integrator = IntegratorKind::VelocityVerlet}, (quick ? 1 << 20 : 1 << 21) / parts};
    };
    return {"contact", settings, Real(0.24), 0, quick ? 512 : 2048, 8, {rung(16), rung(2), rung(1)}};
}

/// Counts of steps, doubled from one to the next, and for a method with a step limit one just within it; with no ball,
/// Dormand-Prince has falling tolerances instead.
std::vector<Rung> ladder(const IntegratorParameters& method, const PrecisionScene& scene) {
    std::vector<Rung> rungs;
    if (method.integrator == IntegratorKind::DormandPrince && !scene.has_ball()) {
        for (Real tolerance = Real(1e-2); tolerance > Real(0.9e-8); tolerance /= 10) {
            rungs.push_back(solved_closely(tolerance));
        }
        return rungs;
    }
    int first = 8, last = scene.finest_steps;
    std::set<int> counts;
    if (has_step_limit(method.integrator)) {
        constexpr Real just_within = Real(0.98);
        const ClothParameters& cloth = scene.settings.cloths.front();
        const Real limit =
            predicted_limit(make_cloth_model(cloth), make_rest_state(cloth), method.integrator, method.kernels).step;
        if (!scene.has_ball()) {
            // From the last steps beyond the limit at rest. Not far below its limit RK4 is as exact as the reference:
            // its ladder starts farther above
            const int too_long = method.integrator == IntegratorKind::Rk4 ? 4 : 2;
            first = 1;
            while (scene.horizon / static_cast<Real>(first) > 2 * limit) first *= 2;
            first = std::max(first >> (too_long - 1), 1);
            last = first << (scene.rungs - 1);
        }
        const Real at_limit = std::ceil(scene.horizon / (just_within * limit));
        if (at_limit < static_cast<Real>(last)) counts.insert(static_cast<int>(at_limit));
    }
    for (int steps = first; steps <= last; steps *= 2) counts.insert(steps);
    for (const int steps : counts) rungs.push_back({method, steps});
    return rungs;
}

/// The error of a rung is a mean over phases of the first impact.
Row row_of(const Rung& rung, const PrecisionScene& scene, const Reference& reference) {
    const ClothParameters& cloth = scene.settings.cloths.front();
    const bool adaptive = rung.parameters.integrator == IntegratorKind::DormandPrince;
    Row row{{"particles", cloth.particles.nx},
            {"stiffness_N_per_m", cloth.structural.stiffness},
            {"horizon_s", scene.horizon},
            {"phases", scene.phases},
            {"tolerance", adaptive ? static_cast<double>(tolerance_of(rung.parameters)) : no_number},
            {"end", "unstable"},
            {"measure", "position"},
            {"reference_error", reference.error},
            {"growth", reference.growth}};
    double squares = 0;
    for (int phase = 0; phase < scene.phases; ++phase) {
        const Real within =
            scene.has_ball() ? (static_cast<Real>(phase) + Real(0.5)) / static_cast<Real>(scene.phases) : 0;
        const Finish end = finish(scene, rung, within);
        const int steps = adaptive && !scene.has_ball() ? end.inner_steps : rung.steps;
        row.set({{"steps", steps}, {"step_s", scene.horizon / static_cast<Real>(steps)}});
        if (!end.bounded) return row;
        const double error = position_error(end.state.x, reference.state.x);
        squares += error * error;
    }
    // What was run for the errors has warmed up
    std::vector<double> costs;
    for (int timing = 0; timing < 7; ++timing) costs.push_back(finish(scene, rung).cost);
    row.set({{"end", "bounded"}, {"error", std::sqrt(squares / scene.phases)}, {"cost_s_per_s", quartiles_of(costs)}});
    return row;
}

ExperimentCases precision_cases(bool quick) {
    const auto references = std::make_shared<std::map<std::string, Reference>>();  // found when a case asks for them
    const auto run = [=](const PrecisionScene& scene, const Method& method) {
        if (!references->contains(scene.name)) references->emplace(scene.name, find_reference(scene));
        Rows rows;
        for (const Rung& rung : ladder(method.parameters, scene)) {
            rows.push_back(row_of(rung, scene, references->at(scene.name)));
        }
        return rows;
    };
    const auto methods =
        methods_named({"explicit_euler", "symplectic_euler", "velocity_verlet", "rk4", "dormand_prince",
                       "backward_euler", "implicit_midpoint_clamped", "implicit_midpoint_exact", "bdf2_clamped",
                       "bdf2_exact", "xpbd_1", "xpbd_5", "xpbd_20", "projective_dynamics_5", "projective_dynamics_20"});
    return cases_over(run, Axis<PrecisionScene>{"scene", precision_scenes(quick)},
                      Axis<Method>{"method", methods})(quick);
}

}  // namespace

std::vector<PrecisionScene> precision_scenes(bool quick) {
    return {hung("soft", 100, Real(0.05), quick), hung("stiff", 2000, Real(0.1), quick), dropped(quick)};
}

Rung solved_closely(Real tolerance) {
    constexpr int outer_steps = 8;
    return {{.integrator = IntegratorKind::DormandPrince, .tolerance = tolerance}, outer_steps};
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
    return {end, static_cast<double>(apart.norm()) / small, position_error(finish(scene, before).state.x, end.x)};
}

Experiment precision_experiment() {
    return {"precision",
            "what does accuracy cost, by which method?",
            6,
            {"scene", "particles", "stiffness_N_per_m", "horizon_s", "phases", "method",
             Column{"tolerance", ""},  // of Dormand-Prince
             "steps", "step_s", "end", "measure", "error", "cost_lower_s_per_s",
             "cost_s_per_s",                                      // CPU time of a simulated second
             "cost_upper_s_per_s", "reference_error", "growth"},  // of a small error
            {{"", precision_cases, {{"precision"}, {"precision_choice"}}, "scene"}}};
}

}  // namespace drape
