// What the linear systems of the implicit methods cost, by factors and by iterations.

#include <benchmark/benchmark.h>

#include <string>

#include "drape/integrate/integrator.h"
#include "drape/model/forces.h"
#include "integrate/newton_system.h"

namespace {

using namespace drape;

/// How long a step is, and how stiff the springs are; its names for both.
struct Load {
    Real h, stiffness;
    const char* name;
};
constexpr Load loads[] = {{Real(1) / 2000, 1e3, "/rate:2000/k:1e3"},
                          {Real(1) / 200, 1e3, "/rate:200/k:1e3"},
                          {Real(1) / 60, 1e3, "/rate:60/k:1e3"},
                          {Real(1) / 20, 1e6, "/rate:20/k:1e6"}};

/// A square sheet hung by two corners.
ClothParameters sheet(int side, Real stiffness) {
    ClothParameters parameters;
    parameters.particles = {side, side};
    parameters.pinned.kind = Pins::Kind::Two;
    parameters.structural.stiffness = stiffness;
    parameters.shear.stiffness = stiffness / 2;
    parameters.bend.stiffness = stiffness / 100;
    return parameters;
}

/// The sheet as it has fallen for half a second, by backward Euler.
ClothState fallen(const ClothParameters& parameters, const ClothModel& model) {
    const auto integrator = make_integrator({.kind = IntegratorKind::BackwardEuler}, model.grid);
    ClothState state = make_rest_state(parameters);
    for (int step = 0; step < 30; ++step) integrator->step(model, state, Real(1) / 60);
    return state;
}

void solve(benchmark::State& bench, Hessian hessian, NewtonSystem::Solver solver, int side, const Load& load) {
    const ClothParameters cloth = sheet(side, load.stiffness);
    const ClothModel model = make_cloth_model(cloth);
    const ClothState state = fallen(cloth, model);
    NewtonSystem system(model.grid, hessian, Kernels::Vector, solver);
    Points force(model.grid.particles(), 3), right = force, dv = force;
    compute_forces(model, state.x, state.v, force);
    system.linearise(model, state.x, state.v);
    system.add_stiffness(-load.h, state.v, force);
    krylov::Outcome outcome;
    for (auto _ : bench) {
        right = load.h * force;
        outcome = system.solve(model, load.h, right, dv);
    }
    bench.counters["iterations"] = outcome.iterations;
    bench.counters["residual"] = static_cast<double>(outcome.residual);
}

void register_all() {
    for (const Load& load : loads) {
        for (const Hessian hessian : {Hessian::Clamped, Hessian::Exact}) {
            for (const int side : {4, 8, 16, 30, 64}) {
                for (const auto solver : {NewtonSystem::Solver::Factors, NewtonSystem::Solver::Blocks}) {
                    const std::string name = "implicit_solve/" + name_of(hessian) + "/side:" + std::to_string(side) +
                                             load.name +
                                             (solver == NewtonSystem::Solver::Factors ? "/factors" : "/blocks");
                    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& bench) {
                        solve(bench, hessian, solver, side, load);
                    })->Unit(benchmark::kMicrosecond);
                }
            }
        }
    }
}

const bool registered = (register_all(), true);

}  // namespace
