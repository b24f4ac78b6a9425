// One step of the positional methods at a frame's length, by grid and by iterations.

#include <benchmark/benchmark.h>

#include <string>

#include "drape/integrate/integrator.h"

namespace {

using drape::Grid;
using drape::IntegratorKind;
using drape::Real;

/// A sheet on two pins, a second into its fall.
void positional_step(benchmark::State& state, IntegratorKind kind, int side, int iterations) {
    constexpr Real h = Real(1) / 60;
    drape::ClothParameters parameters;
    parameters.particles = {side, side};
    parameters.pinned.kind = drape::Pins::Kind::Two;
    const drape::ClothModel model = make_cloth_model(parameters);
    drape::ClothState cloth = make_rest_state(parameters);
    const auto integrator = make_integrator({.kind = kind, .iterations = iterations}, model.grid);
    for (int step = 0; step < 60; ++step) integrator->step(model, cloth, h);
    for (auto _ : state) integrator->step(model, cloth, h);
    state.counters["particles"] = static_cast<double>(model.grid.particles());
}

void register_all() {
    for (const IntegratorKind kind : {IntegratorKind::Xpbd, IntegratorKind::ProjectiveDynamics}) {
        for (const int side : {16, 30, 64, 128}) {
            for (const int iterations : {1, 10}) {
                const std::string name = "positional_step/" + std::string(name_of(kind)) +
                                         "/side:" + std::to_string(side) + "/iterations:" + std::to_string(iterations);
                benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
                    positional_step(state, kind, side, iterations);
                })->Unit(benchmark::kMicrosecond);
            }
        }
    }
}

const bool registered = (register_all(), true);

}  // namespace
