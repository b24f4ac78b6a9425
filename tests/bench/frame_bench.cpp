// A whole simulated frame: one step, rebuild, query, contacts, response.

#include <benchmark/benchmark.h>

#include "drape/sim/scene.h"
#include "drape/sim/simulation.h"

namespace {

/// One simulated frame of a scene that has run for a while.
void simulated_frame(benchmark::State& state, const char* scene, double settled) {
    drape::Settings settings = drape::load_scene(scene);
    settings.solver.sleep_speed = 0;  // sleep is no work
    drape::Simulation simulation(scene, settings);
    while (simulation.report().time < settled) simulation.step();
    for (auto _ : state) simulation.step();
    const drape::StepReport& report = simulation.report();
    state.counters["particles"] = static_cast<double>(simulation.cloths()[0].model.grid.particles());
    state.counters["contacts"] = static_cast<double>(report.contacts);
    state.counters["candidates"] = static_cast<double>(report.traversal.candidates);
}

void whole_frame_drop(benchmark::State& state) { simulated_frame(state, "drop", 2); }
void whole_frame_original(benchmark::State& state) { simulated_frame(state, "original", 2); }
void whole_frame_hang(benchmark::State& state) { simulated_frame(state, "hang", 2); }

}  // namespace

BENCHMARK(whole_frame_drop)->Unit(benchmark::kMicrosecond);
BENCHMARK(whole_frame_original)->Unit(benchmark::kMicrosecond);
BENCHMARK(whole_frame_hang)->Unit(benchmark::kMicrosecond);
