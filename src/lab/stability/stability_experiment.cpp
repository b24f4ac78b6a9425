#include <algorithm>
#include <cmath>
#include <limits>

#include "drape/integrate/stability.h"
#include "drape/integrate/stability_trial.h"
#include "lab/experiments.h"
#include "lab/measure/methods.h"

namespace drape {
namespace {

/// Where the limit is linear: a free flat sheet without gravity, so that it is tried in the state that the prediction
/// is about. Elsewhere: a sheet that falls and swings, hung by two corners.
/// @param sweep what varies
/// @param side particles along each
/// @param spring every one
Rows run_stability_case(const Method& method, const char* sweep, int side, const SpringLaw& spring, int steps) {
    const IntegratorParameters& parameters = method.parameters;
    ClothParameters cloth;
    cloth.particles = {side, side};
    cloth.structural = cloth.shear = cloth.bend = spring;
    cloth.drag = 0;
    if (!has_step_limit(parameters.integrator)) cloth.pinned.kind = Pins::Kind::Two;
    ClothModel model = make_cloth_model(cloth);
    if (has_step_limit(parameters.integrator)) model.gravity.setZero();
    const ClothState state = make_rest_state(cloth);

    // Where trials should start to fail, and how exactly that is known
    const StepLimit limit = predicted_limit(model, state, parameters.integrator, parameters.kernels);
    Real expected = limit.step, tolerance = Real(0.03);
    if (parameters.integrator == IntegratorKind::ExplicitEuler) {
        const StepLimit fastest = predicted_limit(model, state, IntegratorKind::SymplecticEuler, parameters.kernels);
        expected =
            observable_limit_of_explicit_euler(model, state, fastest.omega, fastest.zeta, parameters.kernels, steps);
        tolerance = Real(0.15);
    }

    Rows rows;
    const auto note = [&](Real step, TrialEnd end) {
        const bool below = step<(1 - tolerance) * expected, above = step>(1 + tolerance) * expected;
        const bool agrees = below == (end == TrialEnd::Bounded);
        rows.push_back({{"method", method.name},
                        {"sweep", sweep},
                        {"side", side},
                        {"stiffness_N_per_m", spring.stiffness},
                        {"damping_N_s_per_m", spring.damping},
                        {"omega_per_s", limit.omega},
                        {"zeta", limit.zeta},
                        {"predicted_step_s", limit.step},
                        {"expected_step_s", expected},
                        {"step_s", step},
                        {"end", end},
                        {"agreement", !below && !above ? "close"
                                      : agrees         ? "agrees"
                                                       : "disagrees"}});
    };
    Real measured = std::numeric_limits<Real>::infinity();
    if (std::isfinite(expected)) {
        // The search knows the prediction only as a rough start
        measured = measured_limit(model, state, parameters, Real(0.6) * expected, steps, note);
        for (const double part : {0.1, 0.25, 0.5, 0.75, 0.9, 1.1, 1.25, 2.0, 4.0, 10.0}) {
            const Real step = static_cast<Real>(part) * expected;
            note(step, try_step(model, state, parameters, step, steps));
        }
    } else {
        for (const Real step : {Real(1e-3), Real(1) / 240, Real(1) / 60, Real(1) / 30, Real(0.05)}) {
            const TrialEnd end = try_step(model, state, parameters, step, steps);
            note(step, end);
            if (end != TrialEnd::Bounded) measured = std::min(measured, step);
        }
    }
    for (Row& row : rows) row.set("measured_step_s", measured);
    return rows;
}

ExperimentCases stability_cases(bool quick) {
    const auto methods =
        methods_named({"explicit_euler", "symplectic_euler", "velocity_verlet", "rk4", "backward_euler_clamped",
                       "backward_euler_exact", "implicit_midpoint_clamped", "implicit_midpoint_exact", "bdf2_clamped",
                       "bdf2_exact", "xpbd_1", "xpbd_20", "projective_dynamics"});
    ExperimentCases all;
    for (const Method& method : methods) {
        const bool limited = has_step_limit(method.parameters.integrator);
        const int charted = limited ? (quick ? 16 : 30) : (quick ? 8 : 16);
        const int steps = limited ? 3000 : (quick ? 300 : 1000);
        const auto add = [&](const char* sweep, int side, Real stiffness, Real damping) {
            all.push_back([=] { return run_stability_case(method, sweep, side, {stiffness, damping}, steps); });
        };
        const auto add_stiffnesses = [&](const char* sweep, int side, Real damping) {
            for (const double k : {1e2, 1e3, 1e4, 1e5, 1e6}) add(sweep, side, static_cast<Real>(k), damping);
        };
        if (limited && !quick) {
            for (const int side : {16, 64}) add_stiffnesses("stiffness", side, 0);
        }
        add_stiffnesses("stiffness", charted, 0);
        if (!limited) add_stiffnesses("damped_stiffness", charted, Real(0.1));
        for (const double c :
             quick ? std::vector{0.01, 0.1, 1., 10.} : std::vector{0.01, 0.03, 0.1, 0.3, 1., 3., 10.}) {
            add("damping", charted, Real(1e4), static_cast<Real>(c));
        }
    }
    return all;
}

}  // namespace

Experiment stability_experiment() {
    return {"stability",
            "which steps stay bounded, and is that what is predicted?",
            6,
            {"method",
             "sweep",  // what varies
             "side",   // particles along each
             "stiffness_N_per_m",
             "damping_N_s_per_m",  // of every spring
             "omega_per_s",
             "zeta",              // of the mode that sets the limit
             "predicted_step_s",  // the linear limit
             "expected_step_s",   // where trials should start to fail
             "measured_step_s",   // where they did
             "step_s", "end", "agreement"},
            {{"", stability_cases, {{"stability"}}, "method"}}};
}

}  // namespace drape
