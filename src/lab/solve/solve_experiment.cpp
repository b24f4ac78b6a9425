#include <cmath>

#include "lab/experiments.h"
#include "lab/measure/methods.h"

namespace drape {
namespace {

constexpr Real picture = Real(1) / 60;  // s
constexpr int shorter = 16, measured_steps = 10;

/// Where steps have moved a sheet to, and what they were like.
struct SolveRun {
    Points x;
    Row row;
};

/// A sheet hung by two corners.
/// @param parts of a picture's time that a step has
SolveRun run_sheet(const Method& method, int side, Real time, int parts = 1) {
    ClothParameters cloth = sheet_of(side, 1000, Real(0.01));
    cloth.pinned.kind = Pins::Kind::Two;
    const ClothModel model = make_cloth_model(cloth);
    ClothState state = make_rest_state(cloth);
    const auto integrator = make_integrator(method.parameters, model.grid);
    const auto steps = std::lround(time / picture) * parts;
    double iterations = 0;
    std::vector<double> costs;
    for (std::int64_t k = 0; k < steps; ++k) {
        SolveReport report;
        const double cost =
            cpu_time_of([&] { report = integrator->step(model, state, picture / static_cast<Real>(parts)); });
        if (k < steps - measured_steps) continue;
        iterations += static_cast<double>(report.iterations) / measured_steps;
        costs.push_back(cost);
    }
    return {state.x,
            {{"time_s", time},
             {"step_s", static_cast<double>(picture) / parts},
             {"tolerance", tolerance_of(method.parameters)},
             {"newton_steps", method.parameters.newton_steps},
             {"iterations", iterations},
             {"cost_s", quartiles_of(costs)}}};
}

/// One method on one grid, to each tolerance.
Rows run_tolerances(const Method& method, int side) {
    const auto solved_to = [&](Real tolerance, int parts) {
        Method solved = method;
        solved.parameters.tolerance = tolerance;
        return run_sheet(solved, side, Real(0.5), parts);
    };
    const Points solved = solved_to(Real(1e-9), 1).x, truth = solved_to(Real(1e-6), shorter).x;
    Rows rows;
    for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
        const SolveRun run = solved_to(static_cast<Real>(tolerance), 1);
        rows.push_back(run.row);
        rows.back().set(
            {{"solver_error_m", position_error(run.x, solved)}, {"step_error_m", position_error(solved, truth)}});
    }
    return rows;
}

/// One method by steps of several lengths, with one Newton step in each and with more.
Rows run_newton(Method method, int side) {
    const Method best{"", {.integrator = IntegratorKind::ImplicitMidpoint, .newton_steps = 3}};
    const Points truth = run_sheet(best, side, Real(0.5), 4 * shorter).x;
    Rows rows;
    for (const int newton_steps : {1, 2, 3}) {
        method.parameters.newton_steps = newton_steps;
        for (const int parts : {1, 2, 4, 8}) {
            const SolveRun run = run_sheet(method, side, Real(0.5), parts);
            rows.push_back(run.row);
            rows.back().set("step_error_m", position_error(run.x, truth));
        }
    }
    return rows;
}

/// Falling, and once it swings in folds.
Rows run_size(const Method& method, Real time, int side) { return {run_sheet(method, side, time).row}; }

}  // namespace

Experiment solve_experiment() {
    const Axis<Method> methods{"method",
                               methods_named({"backward_euler_clamped", "implicit_midpoint_clamped", "bdf2_clamped"})};
    return {"solve",
            "what does an implicit step cost on a large cloth, and how far must it be solved?",
            5,
            {"part", "method", "side",
             "time_s",  // simulated, from rest
             "step_s", "tolerance", "newton_steps",
             "solver_error_m",             // RMS over the particles, against solves to 1e-9
             "step_error_m",               // of such, against steps a sixteenth as long or less
             "iterations",                 // of a step, in the mean over the last ten
             quartile_columns("cost_s")},  // CPU time of a step, over the same
            {{"tolerance",
              cases_over(run_tolerances, methods, Axis<int>{"side", {24}, {32, 64, 128}}),
              {{"solve_tolerance"}}},
             {"newton", cases_over(run_newton, methods, Axis<int>{"side", {16}, {64}}), {{"solve_newton"}}},
             {"size",
              cases_over(run_size, Axis<Method>{"method", {methods.whole[0]}}, Axis<Real>{"time_s", {Real(0.2), 1}},
                         Axis<int>{"side", {24, 32}, {32, 45, 64, 91, 128, 181, 256}}),
              {{"solve_size"}}}}};
}

}  // namespace drape
