// The explicit step against what it could cost at best, a pass over the state, and at worst, a list of springs.

#include <benchmark/benchmark.h>

#include <string>

#include "drape/integrate/integrator.h"
#include "spring_list.h"

namespace drape::bench {
namespace {

/// A sheet in waves, moving, with every kind of spring.
struct MovingSheet {
    ClothModel model;
    ClothState state;

    explicit MovingSheet(int side) {
        ClothParameters parameters;
        parameters.particles = {side, side};
        model = make_cloth_model(parameters);
        state = make_rest_state(parameters);
        state.v.col(1) = state.x.col(0).array().sin();
        state.x.col(1) = (9 * state.x.col(0) + 7 * state.x.col(2)).array().sin() * Real(0.01);
    }
};

void per_particle(benchmark::State& state, int side) {
    state.counters["particle"] = benchmark::Counter(
        static_cast<double>(side) * side, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Reads and writes every number of the state once.
void read_and_write(benchmark::State& state, int side) {
    MovingSheet sheet(side);
    ClothState& s = sheet.state;
    for (auto _ : state) {
        s.x *= Real(-1);
        s.v *= Real(-1);
        benchmark::ClobberMemory();
    }
    per_particle(state, side);
}

void step(benchmark::State& state, int side, int threads) {
    MovingSheet sheet(side);
    const auto integrator =
        make_integrator({.kind = IntegratorKind::SymplecticEuler, .threads = threads}, sheet.model.grid);
    for (auto _ : state) integrator->step(sheet.model, sheet.state, Real(1e-7));
    per_particle(state, side);
}

/// The same step with the springs as a list.
void spring_list(benchmark::State& state, int side) {
    MovingSheet sheet(side);
    ClothState& s = sheet.state;
    const SpringList springs(sheet.model);
    Points f(s.x.rows(), 3);
    const Real h = Real(1e-7);
    for (auto _ : state) {
        springs.forces(sheet.model, s.x, s.v, f);
        for (int axis = 0; axis < 3; ++axis) {
            s.v.col(axis).array() += h * f.col(axis).array() * sheet.model.inverse_mass;
            s.x.col(axis) += h * s.v.col(axis);
        }
    }
    per_particle(state, side);
}

void register_all() {
    for (const int side : {30, 128, 256, 512, 1024}) {
        const auto add = [side](const std::string& name, auto run) {
            return benchmark::RegisterBenchmark((name + "/side:" + std::to_string(side)).c_str(), run)
                ->Unit(benchmark::kMicrosecond);
        };
        add("state_pass", [side](benchmark::State& state) { read_and_write(state, side); });
        add("spring_list_step", [side](benchmark::State& state) { spring_list(state, side); });
        add("explicit_step/threads:1", [side](benchmark::State& state) { step(state, side, 1); });
        add("explicit_step/threads:2", [side](benchmark::State& state) { step(state, side, 2); })->UseRealTime();
    }
}

const bool registered = (register_all(), true);

}  // namespace
}  // namespace drape::bench
