// Contact between cloths: its broad phase and its whole search where three sheets lie on a ball (`stack`), what it adds
// to the step of a sheet that cannot touch itself, and a second of `fold`. tests/bench/self_speed.sh makes the table of
// docs/contact-measured.md from it. Times are of the processor: on a machine with other work the clock says nothing.

#include <benchmark/benchmark.h>

#include <ctime>
#include <map>
#include <string>

#include "crossings/self_scenes.h"
#include "drape/base/stopwatch.h"
#include "drape/sim/self_search.h"
#include "drape/sim/simulation.h"

namespace drape::bench {
namespace {

/// The grid that is simulated; finer ones have its surface, because theirs would take an hour.
constexpr int finest_simulated = 64;

/// The sheets of `stack` after half a second, and a step of symplectic Euler later.
struct LyingSheets {
    std::vector<ClothModel> models;
    std::vector<Points> before;
    std::vector<ClothState> states;
    std::vector<ClothInContact> cloths;
    BroadPhaseParameters search;
    Real thickness;
    int triangles = 0;

    explicit LyingSheets(int side) {
        Settings settings = crossings::scene_of_side("stack", side);
        crossings::use_method(settings, IntegratorKind::SymplecticEuler);
        const auto h = static_cast<Real>(settings.solver.dt);
        search = broad_phase_of(settings);
        search.search = {};
        search.leaf_cells = 4;
        thickness = response_of(settings).pair_thickness;
        const Simulation simulation = lying(std::min(side, finest_simulated));
        for (std::size_t c = 0; c < settings.cloths.size(); ++c) {
            const auto& [x, v] = simulation.cloths()[c].state;
            const Grid& grid = simulation.cloths()[c].model.grid;
            models.push_back(make_cloth_model(settings.cloths[c]));
            before.push_back(resampled(x, grid, models[c].grid));
            states.push_back({before[c], resampled(v, grid, models[c].grid)});
            states[c].x += h * states[c].v;
            triangles += models[c].grid.triangles();
        }
        for (std::size_t c = 0; c < models.size(); ++c) {
            cloths.push_back({models[c], before[c], states[c]});
        }
    }

    /// By XPBD, whose longer steps get there sooner.
    static Simulation lying(int side) {
        Settings settings = crossings::scene_of_side("stack", side);
        crossings::use_method(settings, IntegratorKind::Xpbd);
        settings.solver.iterations = 3;
        Simulation simulation("stack", settings);
        while (simulation.report().time < 0.5) simulation.step();
        return simulation;
    }

    /// Made once.
    static LyingSheets& of_side(int side) {
        static std::map<int, LyingSheets> all;
        return all.try_emplace(side, side).first->second;
    }
};

void per_triangle(benchmark::State& state, int triangles) {
    state.counters["triangles"] = triangles;
    state.counters["per_triangle"] =
        benchmark::Counter(triangles, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// All trees are built, and all cloths are traversed against themselves and each other, as for a new list of pairs.
void self_broad_phase(benchmark::State& state, int side) {
    LyingSheets& sheets = LyingSheets::of_side(side);
    const std::size_t count = sheets.models.size();
    std::vector<std::unique_ptr<BroadPhase>> trees;
    std::vector<FoldTest> folds;
    SelfSearch search;
    search.use(sheets.search, sheets.cloths);
    const TraversalStats meant = search.find(sheets.cloths, sheets.thickness).traversal;
    for (std::size_t c = 0; c < count; ++c) {
        const ClothModel& model = sheets.models[c];
        trees.push_back(make_broad_phase(sheets.search, model.grid));
        folds.emplace_back(model.grid, model.hx, model.hy, sheets.search.leaf_cells);
    }
    std::vector<Real> largest;
    for (std::size_t c = 0; c < count; ++c) {
        largest.push_back(std::ranges::max(search.allowances(static_cast<int>(c))));
    }
    std::vector<LeafPair> leaves;
    TraversalStats stats;
    for (auto _ : state) {
        stats = {};
        for (std::size_t c = 0; c < count; ++c) {
            trees[c]->build(sheets.before[c]);
            folds[c].build(sheets.before[c], search.allowances(static_cast<int>(c)));
        }
        for (std::size_t a = 0; a < count; ++a) {
            for (std::size_t b = a; b < count; ++b) {
                const Real margin = largest[a] + largest[b];
                stats += trees[a]->query(*trees[b], margin, a == b ? &folds[a] : nullptr, leaves);
            }
        }
    }
    if (meant.leaves != stats.leaves) state.SkipWithError("this is not what SelfSearch does");
    state.counters["tests_a_triangle"] = static_cast<double>(stats.volume_tests) / sheets.triangles;
    state.counters["leaves_a_triangle"] = static_cast<double>(stats.leaves) / sheets.triangles;
    per_triangle(state, sheets.triangles);
}

/// A search that makes a new list, and one that has it.
void self_search(benchmark::State& state, int side, bool listed) {
    LyingSheets& sheets = LyingSheets::of_side(side);
    SelfSearch search;
    search.use(sheets.search, sheets.cloths);
    SelfSearchReport report = search.find(sheets.cloths, sheets.thickness);
    for (auto _ : state) {
        if (!listed) search.forget();
        report = search.find(sheets.cloths, sheets.thickness);
    }
    if (report.gave_up) state.SkipWithError("the search gave up");
    state.counters["listed"] = static_cast<double>(report.listed);
    state.counters["near"] = static_cast<double>(search.pairs().size());
    per_triangle(state, sheets.triangles);
}

/// A sheet that cannot touch itself, of 128 x 128 particles: a flat one that falls, or one that falls over a ball.
Settings single_sheet_settings(bool draped) {
    Settings settings = crossings::scene_of_side("stack", 128);
    settings.cloths.resize(1);
    settings.ground.solid = false;
    settings.solver.sleep_speed = 0;
    if (!draped) settings.balls.clear();
    crossings::use_method(settings, IntegratorKind::SymplecticEuler);
    return settings;
}

/// Some steps without contact of the sheet with itself and as many with it, in turn, so that what else the machine does
/// slows both. The counters are CPU seconds per step: what that contact adds, and of the run without it the
/// integration.
void single_sheet(benchmark::State& state, bool draped) {
    constexpr int steps = 20;
    Settings settings = single_sheet_settings(draped);
    settings.contact.self = false;
    Simulation without("sheet", settings);
    settings.contact.self = true;
    Simulation with("sheet", settings);
    double integration = 0;
    std::int64_t pairs = 0;
    const auto run = [&](Simulation& simulation) {
        double integrating = 0;
        const Stopwatch watch;
        const std::clock_t start = std::clock();
        for (int k = 0; k < steps; ++k) {
            simulation.step();
            integrating += simulation.report().times.step;
            pairs += simulation.report().pairs;
        }
        const double cpu = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / steps;
        // The simulation's times are those of the wall clock
        if (&simulation == &without) integration += cpu * integrating / watch.seconds();
        return cpu;
    };
    while (draped && with.report().time < 0.25 && with.report().status == Status::Ok) run(without), run(with);
    double added = 0;
    integration = 0;
    for (auto _ : state) {
        added -= run(without);
        added += run(with);
    }
    if (pairs > 0 || with.report().status != Status::Ok) state.SkipWithError("the sheet touches itself, or failed");
    const auto runs = static_cast<double>(state.iterations());
    state.counters["added"] = added / runs;
    state.counters["integration"] = integration / runs;
}

/// `fold` with 64 x 64 particles, from its start to 1 s.
void fold_second(benchmark::State& state, IntegratorKind integrator) {
    Settings settings = crossings::scene_of_side("fold", 64);
    settings.solver.sleep_speed = 0;
    crossings::use_method(settings, integrator);
    double steps = 0;
    for (auto _ : state) {
        Simulation simulation("fold", settings);
        while (simulation.report().time < 1 && simulation.report().status == Status::Ok) simulation.step();
        if (simulation.report().status != Status::Ok) state.SkipWithError(simulation.report().error.c_str());
        steps = static_cast<double>(simulation.report().step);
    }
    state.counters["steps"] = steps;
}

void register_all() {
    const auto add = [](const std::string& name, auto run) {
        return benchmark::RegisterBenchmark(("self/" + name).c_str(), run)->Unit(benchmark::kMicrosecond);
    };
    for (const int side : {32, 64, 128, 256}) {
        const std::string of_side = "/" + std::to_string(side);
        add("broad_phase" + of_side, [=](benchmark::State& state) { self_broad_phase(state, side); });
        add("new_list" + of_side, [=](benchmark::State& state) { self_search(state, side, false); });
        add("listed" + of_side, [=](benchmark::State& state) { self_search(state, side, true); });
    }
    for (const bool draped : {false, true}) {
        const std::string name = draped ? "draped/128" : "flat/128";
        add(name, [=](benchmark::State& state) { single_sheet(state, draped); })->Iterations(20);
    }
    for (const auto integrator : {IntegratorKind::SymplecticEuler, IntegratorKind::BackwardEuler, IntegratorKind::Xpbd,
                                  IntegratorKind::ProjectiveDynamics}) {
        add("fold_" + names_of<IntegratorKind>()[static_cast<std::size_t>(integrator)] + "/64",
            [=](benchmark::State& state) { fold_second(state, integrator); })
            ->Iterations(1);
    }
}

const bool registered = (register_all(), true);

}  // namespace
}  // namespace drape::bench
