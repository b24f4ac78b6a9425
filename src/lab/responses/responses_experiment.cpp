#include <cmath>

#include "lab/contact/contact_trial.h"
#include "lab/experiments.h"

namespace drape {
namespace {

constexpr double earth_g = 9.81;  // m/s^2

/// A sheet of 0.25 m, 6 x 6 particles, above a solid ground at y = 0; no thickness, no drag. The ball is far away.
Settings sheet_above_ground(ResponseKind response, IntegratorKind integrator, Real height, const SpringLaw& springs) {
    Settings settings;
    settings.cloths = {{.particles = {6, 6},
                        .width = Real(0.25),
                        .height = Real(0.25),
                        .place = Vec3(0, height, 0),
                        .pinned = {Pins::Kind::None, {}},
                        .structural = springs,
                        .shear = springs,
                        .bend = springs,
                        .drag = 0}};
    settings.balls.emplace_back().position = Vec3(0, 100, 0);
    settings.solver.integrator = integrator;
    settings.contact.response = response;
    settings.contact.thickness = 0;
    settings.contact.update = UpdateKind::Merge;
    settings.contact.continuous = Continuous::Never;  // a step beyond the limit may move cloth far in its plane
    settings.ground = {.height = 0};
    return settings;
}

/// Drops a small sheet from 0.5 m in a vacuum onto the ground, with the restitution 0.6. A fall of H takes
/// sqrt(2 H / g), and the first bounce comes to e^2 H.
/// @return `impact_error_s` of the time at which the way back, as a parabola, leaves the ground, and `height_error` of
///         that parabola's height, part of what the restitution leaves; only the latter, 1, if nothing comes back
Row drop_sheet(ResponseKind kind, Real step) {
    constexpr double height = 0.5, restitution = 0.6, longest = 2;
    // Verlet falls without error
    Settings settings = sheet_above_ground(kind, IntegratorKind::VelocityVerlet, Real(height), {200, Real(0.02)});
    settings.ground.restitution = Real(restitution);
    ContactTrial sheet(settings);
    const ClothState& state = sheet.cloths[0].state;
    const double h = static_cast<double>(step);
    bool touched = false;
    for (double time = h; time < longest; time += h) {
        sheet.advance(step), sheet.respond();
        const double speed = state.v.col(1).mean(), y = state.x.col(1).mean();
        touched = touched || speed > 0;
        if (!touched || y <= 0 || speed <= 0) continue;
        const double up = std::sqrt(speed * speed + 2 * earth_g * y);
        const double left = time - (up - speed) / earth_g, reached = up * up / (2 * earth_g);
        return {{"impact_error_s", std::abs(left - std::sqrt(2 * height / earth_g))},
                {"height_error", std::abs(reached / (restitution * restitution * height) - 1)}};
    }
    return {{"height_error", 1}};
}

/// Lays a sheet that should stick on a slope that is half a degree flatter than the friction angle.
/// @return `drift_m_per_s` down the slope and `sweeps` of the response, means over the second half of a second, and
///         `respond_s`, CPU time of a response
Row lay_on_slope(ResponseKind kind, Real step) {
    constexpr double half_a_degree = 0.0087268677907587;  // its tangent
    // The tangent of a difference of angles
    const double friction = 0.5, slope = (friction - half_a_degree) / (1 + friction * half_a_degree);
    const double along = slope / std::sqrt(1 + slope * slope), down = 1 / std::sqrt(1 + slope * slope);
    // Backward Euler is stable at each of the steps
    Settings settings = sheet_above_ground(kind, IntegratorKind::BackwardEuler, 0, {50, Real(0.02)});
    settings.ground.friction = static_cast<Real>(friction);
    ContactTrial sheet(settings);
    sheet.cloths[0].model.gravity = Vec3(static_cast<Real>(earth_g * along), static_cast<Real>(-earth_g * down), 0);
    const auto steps = std::llround(0.5 / static_cast<double>(step));
    for (std::int64_t k = 0; k < steps; ++k) sheet.advance(step), sheet.respond();
    const double start = sheet.cloths[0].state.x.col(0).mean(), seconds = static_cast<double>(steps) * step;
    double sweeps = 0;
    std::vector<double> costs;
    for (std::int64_t k = 0; k < steps; ++k) {
        sheet.advance(step);
        costs.push_back(cpu_time_of([&] { sheet.respond(); }));
        sweeps += static_cast<double>(sheet.report.contact_sweeps) / static_cast<double>(steps);
    }
    return {{"drift_m_per_s", std::abs(sheet.cloths[0].state.x.col(0).mean() - start) / seconds},
            {"sweeps", sweeps},
            {"respond_s", quartiles_of(std::move(costs))}};
}

Rows run_at_step(ResponseKind kind, double step) {
    Row row = drop_sheet(kind, static_cast<Real>(step));
    row.set(lay_on_slope(kind, static_cast<Real>(step)));
    return {row};
}

/// Finds where steps of the penalty begin to shake a sheet that rests on the ground, to within 0.5 %, by bisection. The
/// sheet has no springs.
Rows run_limit(ResponseKind penalty, Real stiffness, Real restitution) {
    Settings settings = sheet_above_ground(penalty, IntegratorKind::SymplecticEuler, 0, {});
    settings.contact.stiffness = stiffness;
    settings.ground.restitution = restitution;
    const Real mass = make_cloth_model(settings.cloths[0]).particle_mass;
    const Real depth = mass * static_cast<Real>(earth_g) / stiffness;
    settings.cloths[0].place.y() = -depth;
    // Farther than 100 times the depth at which it rests
    const auto is_thrown = [&](Real step) {
        ContactTrial sheet(settings);
        bool rests = true;
        for (int k = 0; rests && k < 2000; ++k) {
            sheet.advance(step), sheet.respond();
            rests = std::abs(sheet.cloths[0].state.x.col(1).mean()) < 100 * depth;
        }
        return !rests;
    };
    const Real predicted = penalty_step_limit(stiffness, restitution, 1 / mass);
    Real low = predicted / 10, high = 4 * predicted;
    while (high > Real(1.005) * low) {
        const Real step = std::sqrt(low * high);
        (is_thrown(step) ? high : low) = step;
    }
    return {Row{{"predicted_step_s", predicted}, {"measured_step_s", std::sqrt(low * high)}}};
}

}  // namespace

Experiment responses_experiment() {
    return {"responses",
            "which response is right, and at which step?",
            5,
            {"part", "response", "step_s", "impact_error_s", "height_error", "drift_m_per_s", "sweeps",
             quartile_columns("respond_s"),
             "stiffness_N_per_m",  // of a penalty
             "restitution", "predicted_step_s", "measured_step_s"},
            {{"step",
              cases_over(run_at_step, Axis<ResponseKind>{"response", values_of<ResponseKind>()},
                         steps_a_second({60, 240, 960, 3840}, {60, 120, 240, 480, 960, 1920, 3840, 7680, 15360})),
              {{"responses"}}},
             {"limit",
              cases_over(run_limit, Axis<ResponseKind>{"response", {ResponseKind::Penalty}},
                         Axis<Real>{"stiffness_N_per_m", {1e2, 1e3}, {1e1, 1e2, 1e3, 1e4, 1e5}},
                         Axis<Real>{"restitution", {0, Real(0.5), 1}}),
              {{"responses_limit"}}}}};
}

}  // namespace drape
