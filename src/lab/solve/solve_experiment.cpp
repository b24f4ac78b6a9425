#include <cmath>
#include <memory>

#include "drape/base/numbers.h"
#include "lab/experiments.h"
#include "lab/measure/methods.h"
#include "lab/measure/states.h"

namespace drape {
namespace {

constexpr Real picture = Real(1) / 60;                   // s
constexpr Real exact = Real(1e-9), nearly = Real(1e-6);  // tolerances
constexpr int shorter = 16, measured_steps = 10;

/// A metre square; drag is that of the whole cloth, whatever the grid.
ClothParameters sheet_of(int side) {
    ClothParameters cloth;
    cloth.particles = {side, side};
    cloth.mass = Real(0.2);
    cloth.pinned.kind = Pins::Kind::Two;
    cloth.structural = {1000, Real(0.01)};
    cloth.shear = {500, Real(0.01)};
    cloth.bend = {100, Real(0.01)};
    cloth.drag = Real(0.5) / static_cast<Real>(cloth.particles.particles());
    return cloth;
}

struct SolveRun {
    Points x;
    double iterations = 0;
    std::vector<double> costs;
};

/// @param parts of a picture's time that a step has
SolveRun run_sheet(const IntegratorParameters& parameters, int side, Real time, int parts = 1) {
    const ClothParameters cloth = sheet_of(side);
    const ClothModel model = make_cloth_model(cloth);
    ClothState state = make_rest_state(cloth);
    const auto integrator = make_integrator(parameters, model.grid);
    const auto steps = std::lround(time / picture) * parts;
    SolveRun run;
    for (std::int64_t k = 0; k < steps; ++k) {
        SolveReport report;
        const double cost =
            cpu_time_of([&] { report = integrator->step(model, state, picture / static_cast<Real>(parts)); });
        if (k < steps - measured_steps) continue;
        run.iterations += static_cast<double>(report.iterations) / measured_steps;
        run.costs.push_back(cost);
    }
    run.x = state.x;
    return run;
}

IntegratorParameters solved_to(Real tolerance, IntegratorParameters parameters) {
    parameters.tolerance = tolerance;
    return parameters;
}

Row row_of(const char* part, const Method& method, int side, Real time, const SolveRun& run) {
    return {{"part", part},
            {"method", method.name},
            {"side", side},
            {"time_s", time},
            {"step_s", picture},
            {"tolerance", tolerance_of(method.parameters)},
            {"newton_steps", method.parameters.newton_steps},
            {"iterations", run.iterations},
            {"cost_s", quartiles_of(run.costs)}};
}

/// One method on one grid, to each tolerance.
Rows run_tolerances(Method method, int side) {
    constexpr Real time = Real(0.5);
    const Points solved = run_sheet(solved_to(exact, method.parameters), side, time).x;
    const Points truth = run_sheet(solved_to(nearly, method.parameters), side, time, shorter).x;
    Rows rows;
    for (const Real tolerance : {Real(1e-1), Real(1e-2), Real(1e-3), Real(1e-4), Real(1e-5), Real(1e-6), Real(1e-7)}) {
        method.parameters.tolerance = tolerance;
        const SolveRun run = run_sheet(method.parameters, side, time);
        rows.push_back(row_of("tolerance", method, side, time, run));
        rows.back().set(
            {{"solver_error_m", position_error(run.x, solved, 1)}, {"step_error_m", position_error(solved, truth, 1)}});
    }
    return rows;
}

/// One method by steps of several lengths, with one Newton step in each and with more.
Rows run_newton(Method method, int side) {
    constexpr Real time = Real(0.5);
    const IntegratorParameters best{.kind = IntegratorKind::ImplicitMidpoint, .newton_steps = 3};
    const Points truth = run_sheet(best, side, time, 4 * shorter).x;
    Rows rows;
    for (const int newton_steps : {1, 2, 3}) {
        for (const int parts : {1, 2, 4, 8}) {
            method.parameters.newton_steps = newton_steps;
            const SolveRun run = run_sheet(method.parameters, side, time, parts);
            rows.push_back(row_of("newton", method, side, time, run));
            rows.back().set(
                {{"step_s", static_cast<double>(picture) / parts}, {"step_error_m", position_error(run.x, truth, 1)}});
        }
    }
    return rows;
}

std::vector<Method> solved_methods() {
    return methods_named({"backward_euler_clamped", "implicit_midpoint_clamped", "bdf2_clamped"});
}

ExperimentCases tolerance_cases(bool quick) {
    return cases_over(run_tolerances, solved_methods(), quick ? std::vector{24} : std::vector{32, 64, 128});
}

ExperimentCases newton_cases(bool quick) {
    return cases_over(run_newton, solved_methods(), std::vector{quick ? 16 : 64});
}

/// Falling, and once it swings in folds.
ExperimentCases size_cases(bool quick) {
    const Method method = methods_named({"backward_euler_clamped"})[0];
    return cases_over(
        [=](Real time, int side) {
            return Rows{row_of("size", method, side, time, run_sheet(method.parameters, side, time))};
        },
        std::vector{Real(0.2), Real(1)}, quick ? std::vector{24, 32} : std::vector{32, 45, 64, 91, 128, 181, 256});
}

std::vector<Chart> tolerance_charts(const Rows& all) {
    const Rows rows = rows_with(all, "method", "backward_euler_clamped");
    if (rows.empty()) return {};
    const auto sides = words_of(rows, [](const Row& row) { return real_text(row.number("side")); });
    return {{"solve_tolerance", {{"sides", in_words(sides)}}}};
}

std::vector<Chart> newton_charts(const Rows& rows) {
    return {{"solve_newton", {{"methods", in_words(words_of(rows, "method"))}}}};
}

std::vector<Chart> size_charts(const Rows&) { return {{"solve_size", {}}}; }

}  // namespace

Experiment solve_experiment() {
    return {"solve",
            "what does an implicit step cost on a large cloth, and how far must it be solved?",
            5,
            {word_column("part", {"tolerance", "newton", "size"}),
             word_column("method", names_in(solved_methods(), &Method::name)), whole_column("side", 2),
             positive_column("time_s"),  // simulated, from rest
             positive_column("step_s"), positive_column("tolerance"), whole_column("newton_steps", 1),
             number_column("solver_error_m").or_nan(),     // RMS over the particles, against `exact` solves
             number_column("step_error_m").or_nan(),       // of such, against steps a sixteenth as long or less
             number_column("iterations"),                  // of a step, in the mean over the last ten
             positive_column("cost_s").with_quartiles()},  // CPU time of a step, over the same
            {{"part", "method", "side", "time_s", "newton_steps"},
             {"tolerance", "step_s", "iterations", "cost_s", "solver_error_m", "step_error_m"}},
            {{"tolerance", tolerance_cases, tolerance_charts},
             {"newton", newton_cases, newton_charts},
             {"size", size_cases, size_charts}}};
}

}  // namespace drape
