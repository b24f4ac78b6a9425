#include <cmath>

#include "drape/scene/scene.h"
#include "lab/experiments.h"
#include "needs.h"

namespace drape {
namespace {

/// One configuration of a scene that was tried, and what its needs say about it.
Row row_of(const Needs& needs, const Attempt& attempt) {
    const Settings& settings = attempt.settings;
    const ClothParameters& cloth = settings.cloths[0];
    Row row{{"particles_x", cloth.particles.nx},
            {"particles_y", cloth.particles.ny},
            {"bend", cloth.bend != SpringLaw{} ? "yes" : "no"},
            {"drag", cloth.drag > 0 ? "yes" : "no"},
            {"integrator", settings.solver.integrator},
            {"step_s", settings.solver.dt},
            {"iterations", settings.solver.iterations},
            {"error", attempt.error},
            {"outcome", attempt.qualifies() ? "kept" : "rejected"}};
    if (needs.states_error()) row.set("allowed_error", needs.scene().needs.position_error);
    if (std::isfinite(attempt.miss)) row.set("miss", attempt.miss);
    if (attempt.cost > 0) row.set("cost_s_per_s", attempt.cost);
    return row;
}

/// The whole search: the full model, then what is taken away from it.
Rows run_ladder(const std::string& scene) {
    const Needs needs(load_scene(scene));
    Rows rows{row_of(needs, needs.attempt(computed_closely(needs.full(), close_step)))};
    (void)search(needs, [&](const Attempt& attempt, const std::string& outcome) {
        rows.push_back(row_of(needs, attempt));
        const bool kept = outcome.starts_with("kept") || outcome.starts_with("cheapest");
        if (attempt.qualifies() && !kept) rows.back().set("outcome", "costlier");
    });
    return rows;
}

/// The scene as it is, and with one notch less of each knob that it leaves free.
Rows run_notches(const std::string& scene) {
    const Needs needs(load_scene(scene));
    Rows rows{row_of(needs, needs.attempt(needs.scene()))};
    try_notches(needs, [&](Knob knob, const Attempt& less) {
        rows.push_back(row_of(needs, less));
        rows.back().set("changed", knob);
    });
    return rows;
}

/// The scene with one knob at a time as its full model has it (the step: half as long), the others as they are; a step
/// that is then too long is divided. Only the error is compared, not what else the scene needs.
Rows run_budget(const std::string& scene) {
    const Needs needs(load_scene(scene));
    const Settings &as_it_is = needs.scene(), &full = needs.full();
    const ClothParameters &cloth = as_it_is.cloths[0], &most = full.cloths[0];
    const Motion motion = run_to_horizon(as_it_is);
    Rows rows;
    const auto add = [&](const std::string& changed, const Settings& settings, const Motion& moved) {
        Row& row = rows.emplace_back(row_of(needs, {.settings = settings, .cost = moved.cost}));
        row.set({{"changed", changed}, {"miss", no_number}, {"outcome", "diverged"}});
        if (moved.diverged) return;
        row.set({{"outcome", "compared"}, {"error", needs.error_of(moved)}, {"moved", needs.error_of(moved, motion)}});
    };
    add("none", as_it_is, motion);
    for (const Knob knob : {Knob::Particles, Knob::Bend, Knob::Drag, Knob::Integrator, Knob::Dt}) {
        Settings closer = as_it_is;
        if (knob == Knob::Particles) closer = on_grid(as_it_is, most.particles);
        if (knob == Knob::Bend) closer.cloths[0].bend = most.bend;
        if (knob == Knob::Drag && most.particles == cloth.particles) closer.cloths[0].drag = most.drag;
        if (knob == Knob::Integrator) closer = computed_closely(as_it_is, as_it_is.solver.dt);
        if (knob == Knob::Dt) closer.solver.dt /= 2;
        if (closer.cloths[0] == cloth && closer.solver == as_it_is.solver) continue;  // the scene has the whole of it
        closer.solver.on_unstable = OnUnstable::Substep;
        add(std::string(name_of(knob)), closer, run_to_horizon(closer));
    }
    return rows;
}

/// Those that say what they need, of one cloth.
std::vector<std::string> scenes_with_needs() {
    std::vector<std::string> names = scene_names();
    std::erase_if(names, [](const std::string& name) {
        const Settings scene = load_scene(name);
        return scene.cloths.size() != 1 || !states_needs(scene.needs);
    });
    return names;
}

ExperimentCases notches_cases(bool quick) {
    const Axis<std::string> scenes{"scene", quick ? std::vector<std::string>{"hang"} : scenes_with_needs()};
    return cases_over(run_notches, scenes)(quick);
}

}  // namespace

Experiment minimal_experiment() {
    const Axis<std::string> searched{"scene", {"hang"}, {"hang", "original", "curtain", "drop"}};
    return {"minimal",
            "how much model does a scene need, and what does each part of it buy?",
            5,
            {"part", "scene", Column{"changed", "none"},  // a notch less of it, or in `budget` closer to the full model
             "particles_x", "particles_y", "bend", "drag", "integrator", "step_s", "iterations", "allowed_error",
             "error",         // against the full model, of the cloth's side
             "miss",          // the worst of what was measured over what is allowed
             "cost_s_per_s",  // CPU time of a simulated second
             "moved",         // in `budget`: from the motion of the scene, of the cloth's side
             "outcome"},
            {{"ladder", cases_over(run_ladder, searched), {{"minimal"}}, "scene"},
             {"notches", notches_cases, {}},
             {"budget", cases_over(run_budget, searched), {{"minimal_budget"}}}}};
}

}  // namespace drape
