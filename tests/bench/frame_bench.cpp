// A whole simulated frame: one step, rebuild, query, contacts, response.

#include <benchmark/benchmark.h>

#include <string>

#include "drape/scene/scene.h"
#include "drape/sim/simulation.h"

namespace {

/// One simulated frame of a scene that has run for a while.
void simulated_frame(benchmark::State& state, const char* scene, int leaf_cells) {
    drape::Settings settings = drape::load_scene(scene);
    settings.contact.leaf_cells = leaf_cells;
    settings.solver.sleep_speed = 0;  // sleep is no work
    drape::Simulation simulation(scene, settings);
    while (simulation.report().time < 2) simulation.step();
    for (auto _ : state) simulation.step();
    const drape::StepReport& report = simulation.report();
    state.counters["particles"] = static_cast<double>(simulation.cloths()[0].model.grid.particles());
    state.counters["contacts"] = static_cast<double>(report.contacts);
    state.counters["candidates"] = static_cast<double>(report.traversal.candidates);
}

void register_all() {
    for (const char* scene : {"drop", "original", "hang"}) {
        for (const int leaf : {2, 4, 5, 7, 8, 10, 15}) {
            const std::string name = std::string("whole_frame/") + scene + "/leaf:" + std::to_string(leaf);
            benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
                simulated_frame(state, scene, leaf);
            })->Unit(benchmark::kMicrosecond);
        }
    }
}

const bool registered = (register_all(), true);

}  // namespace
