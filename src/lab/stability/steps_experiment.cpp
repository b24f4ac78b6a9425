#include <memory>
#include <optional>

#include "drape/scene/scene.h"
#include "lab/experiments.h"
#include "lab/measure/methods.h"
#include "lab/needs/needs.h"

namespace drape {
namespace {

/// A picture shows no less of error and stretch than this.
constexpr double visible = 0.01;

/// Of springs at twice their length nothing is left to see.
constexpr double ruinous = 1;

/// A sheet of 1 m that falls, hung by two corners, and swings.
Settings sheet(bool quick) {
    Settings settings = load_scene("hang");
    ClothParameters& cloth = settings.cloths[0];
    cloth.particles = quick ? Grid{12, 12} : Grid{26, 26};
    cloth.bend = {5, Real(0.01)};
    cloth.drag = Real(0.18) / static_cast<Real>(cloth.particles.particles());
    cloth.stretch_limit = 0;  // what a method leaves of the springs is to be seen
    settings.contact.self = false;
    settings.solver.sleep_speed = 0;
    settings.needs.horizon = quick ? Real(0.5) : 2;
    settings.needs.measure = NeedsMeasure::CentreAndSpread;
    return settings;
}

/// How a sheet fares with one method at one step.
Rows run_step(const Method& method, double step, const Settings& scene, const Motion& truth) {
    Settings settings = with_method(scene, method.parameters);
    settings.solver.dt = step;
    const Motion run = run_to_horizon(settings);
    Row row{{"end", "blew_up"}};
    if (run.step_over_limit > 0) row.set("step_over_limit", run.step_over_limit);
    if (run.diverged) return {row};
    const double error = motion_error(run, truth, settings.needs.measure, 1);
    const double excess = std::max(run.stretch - truth.stretch, 0.0);
    row.set({{"error", error},
             {"stretch_excess", excess},
             {"cost_s_per_s", run.cost},
             {"end", excess > ruinous   ? "ruined"
                     : excess > visible ? "soft"
                     : error > visible  ? "off"
                                        : "held"}});
    return {row};
}

ExperimentCases steps_cases(bool quick) {
    const Settings scene = sheet(quick);
    const auto truth = std::make_shared<std::optional<Motion>>();  // found when the first case asks for it
    const auto run = [=](const Method& method, double step) {
        if (!*truth) *truth = run_to_horizon(computed_closely(scene, 1e-3));
        return run_step(method, step, scene, **truth);
    };
    const auto methods =
        methods_named({"explicit_euler", "symplectic_euler", "velocity_verlet", "rk4", "dormand_prince",
                       "backward_euler", "implicit_midpoint", "bdf2", "xpbd_1", "xpbd_20", "projective_dynamics_10"});
    return cases_over(
        run, Axis<Method>{"method", methods},
        steps_a_second({15, 30, 60, 120, 240, 480, 960}, {15, 30, 60, 120, 240, 480, 960, 1920, 3840, 7680}))(quick);
}

}  // namespace

Experiment steps_experiment() {
    return {"steps",
            "which steps of which method hold a cloth, and what happens at longer ones?",
            5,
            {"method", "step_s",
             "error",            // largest over the run, of the side
             "stretch_excess",   // of the largest, over the converged sheet's
             "step_over_limit",  // as predicted
             "cost_s_per_s", "end"},
            {{"", steps_cases, {{"steps"}}}}};
}

}  // namespace drape
