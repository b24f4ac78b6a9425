#include <algorithm>

#include "drape/scene/scene.h"
#include "lab/experiments.h"
#include "needs.h"

namespace drape {
namespace {

/// One configuration of a scene that was tried, and what its needs say about it.
struct MinimalRow {
    std::string part, scene;
    std::string changed = "none";  ///< the knob that was turned: a notch less, or in `budget` closer to the full model
    std::int64_t particles_x = 0, particles_y = 0;
    bool bend = false, drag = false;
    IntegratorKind integrator{};
    double step = 0;  ///< [s]
    std::int64_t iterations = 0;
    double allowed = no_number, error = no_number;  ///< against the full model, of the cloth's side
    double miss = no_number;                        ///< the worst of what was measured over what is allowed
    double cost = no_number;                        ///< CPU time of a simulated second [s/s]
    double moved = no_number;  ///< in `budget`: how far the motion is from that of the scene, of the cloth's side
    std::string outcome;  ///< kept, costlier than the cheapest so far, or rejected; in `budget` compared or diverged
};

using MinimalRows = std::vector<MinimalRow>;

MinimalRow row_of(const char* part, const std::string& scene, const Needs& needs, const Attempt& attempt) {
    const Settings& settings = attempt.settings;
    const ClothParameters& cloth = settings.cloths[0];
    MinimalRow row;
    row.part = part;
    row.scene = scene;
    row.particles_x = cloth.particles.nx;
    row.particles_y = cloth.particles.ny;
    row.bend = cloth.bend != SpringLaw{};
    row.drag = cloth.drag > 0;
    row.integrator = settings.solver.integrator;
    row.step = settings.solver.dt;
    row.iterations = settings.solver.iterations;
    if (needs.states_error()) {
        row.allowed = static_cast<double>(needs.scene().needs.position_error);
        if (attempt.error > 0 || attempt.qualifies()) row.error = attempt.error;
    }
    if (std::isfinite(attempt.miss)) row.miss = attempt.miss;
    if (attempt.cost > 0) row.cost = attempt.cost;
    row.outcome = attempt.qualifies() ? "kept" : "rejected";
    return row;
}

/// The whole search: the full model, then what is taken away from it.
MinimalRows run_ladder(const std::string& scene) {
    const Needs needs(load_scene(scene));
    MinimalRows rows{row_of("ladder", scene, needs, needs.attempt(computed_closely(needs.full(), close_step)))};
    (void)search(needs, [&](const Attempt& attempt, const std::string& outcome) {
        rows.push_back(row_of("ladder", scene, needs, attempt));
        const bool kept = outcome.starts_with("kept") || outcome.starts_with("cheapest");
        if (attempt.qualifies() && !kept) rows.back().outcome = "costlier";
    });
    return rows;
}

/// The scene as it is, and with one notch less of each knob that it leaves free.
MinimalRows run_notches(const std::string& scene) {
    const Needs needs(load_scene(scene));
    MinimalRows rows{row_of("notches", scene, needs, needs.attempt(needs.scene()))};
    const std::set<Knob> free = free_knobs(needs.scene());
    for (const Knob knob : ordered_knobs()) {
        const auto less = free.contains(knob) ? one_notch_less(needs.scene(), knob) : std::nullopt;
        if (!less) continue;
        rows.push_back(row_of("notches", scene, needs, needs.attempt(*less)));
        rows.back().changed = name_of(knob);
    }
    return rows;
}

/// The scene with one knob at a time as its full model has it (the step: half as long), the others as they are; a step
/// that is then too long is divided. Only the error is compared, not what else the scene needs.
MinimalRows run_budget(const std::string& scene) {
    const Needs needs(load_scene(scene));
    const Settings &as_it_is = needs.scene(), &full = needs.full();
    const ClothParameters &cloth = as_it_is.cloths[0], &most = full.cloths[0];
    const Motion motion = run_to_horizon(as_it_is);
    MinimalRows rows;
    const auto add = [&](const std::string& changed, const Settings& settings, const Motion& moved) {
        Attempt attempt;
        attempt.settings = settings;
        attempt.cost = moved.cost;
        if (moved.diverged) attempt.note(no_number, "diverged");
        if (!moved.diverged) attempt.error = needs.error_of(moved);
        rows.push_back(row_of("budget", scene, needs, attempt));
        rows.back().changed = changed;
        rows.back().miss = no_number;
        rows.back().outcome = moved.diverged ? "diverged" : "compared";
        if (!moved.diverged) rows.back().moved = needs.difference(moved, motion);
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

template <class Run>
auto cases_of(const Run& run, const std::vector<std::string>& quick_scenes, const std::vector<std::string>& scenes) {
    return [=](bool quick) { return cases_over(run, quick ? quick_scenes : scenes); };
}

std::vector<Chart> ladder_charts(const MinimalRows& rows) {
    std::vector<Chart> charts;
    for (const std::string& scene : words_of(rows, &MinimalRow::scene)) {
        charts.push_back({"minimal_" + scene,
                          "minimal_ladder",
                          "What was taken away from the full model of a scene, one notch after the other, until one "
                          "notch less of anything breaks its need.",
                          {{"scene", scene}, {"allowed", rows_with(rows, &MinimalRow::scene, scene).front().allowed}}});
    }
    return charts;
}

std::vector<Chart> budget_charts(const MinimalRows& rows) {
    Chart chart{"minimal_budget",
                "minimal_budget",
                "How far the motion of a scene moves where one knob is as in its full model (the step: half as long), "
                "and how many times the scene's cost that is.",
                {{"scenes", in_words(words_of(rows, &MinimalRow::scene))}}};
    for (const MinimalRow& row : rows_with(rows, &MinimalRow::changed, "none")) {
        chart.values["cost_" + row.scene] = row.cost;
    }
    return {chart};
}

}  // namespace

Experiment minimal_experiment() {
    using Row = MinimalRow;
    const std::vector<std::string> searched{"hang", "original", "curtain", "drop"};
    return ExperimentOf<Row>{
        "minimal",
        "how much model does a scene need, and what does each part of it buy?",
        {5,
         {{word_column("part", {"ladder", "notches", "budget"}), &Row::part},
          {word_column("scene", scene_names()), &Row::scene},
          {name_column<Knob>("changed", {"none"}), &Row::changed},
          {whole_column("particles_x", 2), &Row::particles_x},
          {whole_column("particles_y", 2), &Row::particles_y},
          {word_column("bend", {"no", "yes"}), &Row::bend},
          {word_column("drag", {"no", "yes"}), &Row::drag},
          {name_column<IntegratorKind>("integrator"), &Row::integrator},
          {positive_column("step_s"), &Row::step},
          {whole_column("iterations", 0), &Row::iterations},
          {positive_column("allowed_error").or_nan(), &Row::allowed},
          {number_column("error").or_nan(), &Row::error},
          {number_column("miss").or_nan(), &Row::miss},
          {positive_column("cost_s_per_s").or_nan(), &Row::cost},
          {number_column("moved").or_nan(), &Row::moved},
          {word_column("outcome", {"kept", "costlier", "rejected", "compared", "diverged"}), &Row::outcome}}},
        {{"part", "scene", "changed", "outcome"}, {"particles_x", "step_s", "error", "miss", "cost_s_per_s", "moved"}},
        {{"ladder", cases_of(run_ladder, {"hang"}, searched), ladder_charts},
         {"notches", cases_of(run_notches, {"hang"}, scenes_with_needs()), {}},
         {"budget", cases_of(run_budget, {"hang"}, searched), budget_charts}}};
}

}  // namespace drape
