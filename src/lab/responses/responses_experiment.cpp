#include <cmath>

#include "lab/contact/contact_trial.h"
#include "lab/experiments.h"
#include "lab/measure/methods.h"
#include "responses.h"

namespace drape {
namespace {

constexpr double earth_g = 9.81;                      // m/s^2
constexpr double half_a_degree = 0.0087268677907587;  // its tangent

/// A sheet of 0.25 m, 6 x 6 particles, above a solid ground at y = 0; no thickness, no drag. The ball is far away.
ContactScene sheet_above_ground(Real height, const SpringLaw& springs) {
    ContactScene scene;
    scene.settings.cloths.resize(1);
    ClothParameters& cloth = scene.settings.cloths[0];
    cloth.particles = {6, 6};
    cloth.width = cloth.height = Real(0.25);
    cloth.place = Vec3(0, height, 0);
    cloth.pinned.kind = Pins::Kind::None;
    cloth.drag = 0;
    cloth.structural = cloth.shear = cloth.bend = springs;
    scene.settings.balls.emplace_back().position = Vec3(0, 100, 0);
    scene.settings.solver.integrator = IntegratorKind::SymplecticEuler;
    scene.settings.contact.thickness = 0;
    scene.settings.contact.update = UpdateKind::Merge;
    scene.settings.contact.continuous = Continuous::Never;  // a step beyond the limit may move cloth far in its plane
    scene.settings.ground = {.height = 0};
    return scene;
}

/// A sheet on its ground, step by step.
struct SheetTrial : ContactTrial {
    using ContactTrial::ContactTrial;

    void step() { advance(), respond(); }

    [[nodiscard]] double mean(int axis) const { return static_cast<double>(state().x.col(axis).mean()); }
    [[nodiscard]] double speed(int axis) const { return static_cast<double>(state().v.col(axis).mean()); }
};

/// Whether a sheet that rests on a penalty is thrown off, farther than 100 times the depth at which it rests.
bool is_thrown(const ContactScene& scene, double depth, Real step) {
    constexpr int steps = 2000;
    SheetTrial sheet(scene, step);
    for (int k = 0; k < steps; ++k) {
        sheet.step();
        if (!(std::abs(sheet.mean(1)) < 100 * depth)) return true;
    }
    return false;
}

}  // namespace

Row drop_sheet(ResponseKind kind, Real step) {
    constexpr double height = 0.5, restitution = 0.6, longest = 2;
    ContactScene scene = sheet_above_ground(static_cast<Real>(height), {200, Real(0.02)});
    scene.settings.solver.integrator = IntegratorKind::VelocityVerlet;  // falls without error
    scene.settings.contact.response = kind;
    scene.settings.ground.restitution = Real(restitution);
    SheetTrial sheet(scene, step);
    const double h = static_cast<double>(step);
    bool touched = false;
    for (double time = h; time < longest; time += h) {
        sheet.step();
        touched = touched || sheet.speed(1) > 0;
        if (!touched || sheet.mean(1) <= 0 || sheet.speed(1) <= 0) continue;
        const double up = std::sqrt(sheet.speed(1) * sheet.speed(1) + 2 * earth_g * sheet.mean(1));
        const double left = time - (up - sheet.speed(1)) / earth_g, reached = up * up / (2 * earth_g);
        return {{"impact_error_s", std::abs(left - std::sqrt(2 * height / earth_g))},
                {"height_error", std::abs(reached / (restitution * restitution * height) - 1)}};
    }
    return {{"height_error", 1}};
}

Row lay_on_slope(ResponseKind kind, Real step) {
    constexpr double half = 0.5;  // s
    // The tangent of a difference of angles
    const double friction = 0.5, slope = (friction - half_a_degree) / (1 + friction * half_a_degree);
    const double along = slope / std::sqrt(1 + slope * slope), down = 1 / std::sqrt(1 + slope * slope);
    ContactScene scene = sheet_above_ground(0, {50, Real(0.02)});
    scene.settings.solver.integrator = IntegratorKind::BackwardEuler;  // stable at each of the steps
    scene.settings.contact.response = kind;
    scene.settings.ground.friction = static_cast<Real>(friction);
    scene.gravity = Vec3(static_cast<Real>(earth_g * along), static_cast<Real>(-earth_g * down), 0);
    SheetTrial sheet(scene, step);
    const auto steps = std::llround(half / static_cast<double>(step));
    for (std::int64_t k = 0; k < steps; ++k) sheet.step();
    const double start = sheet.mean(0);
    double sweeps = 0;
    std::vector<double> costs;
    for (std::int64_t k = 0; k < steps; ++k) {
        sheet.advance();
        ResponseReport report;
        costs.push_back(cpu_time_of([&] { report = sheet.respond(); }));
        sweeps += report.sweeps / static_cast<double>(steps);
    }
    const double time = static_cast<double>(steps) * static_cast<double>(step);
    return {{"drift_m_per_s", std::abs(sheet.mean(0) - start) / time},
            {"sweeps", sweeps},
            {"respond_s", quartiles_of(std::move(costs))}};
}

Row find_penalty_limit(Real stiffness, Real restitution, IntegratorKind integrator) {
    ContactScene scene = sheet_above_ground(0, {});
    scene.settings.contact.response = ResponseKind::Penalty;
    scene.settings.contact.stiffness = stiffness;
    scene.settings.ground.restitution = restitution;
    scene.settings.solver.integrator = integrator;
    const Real mass = make_cloth_model(scene.settings.cloths[0]).particle_mass;
    const Real depth = mass * static_cast<Real>(earth_g) / stiffness;
    scene.settings.cloths[0].place.y() = -depth;
    const Real predicted = penalty_step_limit(stiffness, restitution, 1 / mass, displacement_factor(integrator));
    Real low = predicted / 10, high = 4 * predicted;
    while (high > Real(1.005) * low) {
        const Real step = std::sqrt(low * high);
        (is_thrown(scene, static_cast<double>(depth), step) ? high : low) = step;
    }
    return {{"predicted_step_s", predicted}, {"measured_step_s", std::sqrt(low * high)}};
}

namespace {

Rows run_at_step(ResponseKind kind, double rate) {
    const auto step = static_cast<Real>(1 / rate);
    Row row{{"part", "step"}, {"response", kind}, {"step_s", 1 / rate}};
    row.set(drop_sheet(kind, step));
    row.set(lay_on_slope(kind, step));
    return {row};
}

Rows run_limit(double stiffness, double restitution) {
    Row row{{"part", "limit"},
            {"response", ResponseKind::Penalty},
            {"stiffness_N_per_m", stiffness},
            {"restitution", restitution}};
    row.set(find_penalty_limit(static_cast<Real>(stiffness), static_cast<Real>(restitution)));
    return {row};
}

ExperimentCases step_cases(bool quick) {
    return cases_over(run_at_step, values_of<ResponseKind>(),
                      quick ? std::vector{60.0, 240.0, 960.0, 3840.0}
                            : std::vector{60.0, 120.0, 240.0, 480.0, 960.0, 1920.0, 3840.0, 7680.0, 15360.0});
}

ExperimentCases limit_cases(bool quick) {
    return cases_over(run_limit, quick ? std::vector{1e2, 1e3} : std::vector{1e1, 1e2, 1e3, 1e4, 1e5},
                      std::vector{0.0, 0.5, 1.0});
}

std::vector<Chart> step_charts(const Rows& rows) {
    const auto responses = words_of(rows, "response");
    return {{"responses", {{"responses", in_words(responses)}}}};
}

std::vector<Chart> limit_charts(const Rows&) { return {{"responses_limit", {}}}; }

}  // namespace

Experiment responses_experiment() {
    return {"responses",
            "which response is right, and at which step?",
            5,
            {word_column("part", {"step", "limit"}), name_column<ResponseKind>("response"),
             positive_column("step_s").or_nan(), number_column("impact_error_s").or_nan(),
             number_column("height_error").or_nan(), number_column("drift_m_per_s").or_nan(),
             number_column("sweeps").or_nan(), number_column("respond_s").or_nan().with_quartiles(),
             positive_column("stiffness_N_per_m").or_nan(),  // of a penalty
             number_column("restitution").or_nan(), positive_column("predicted_step_s").or_nan(),
             positive_column("measured_step_s").or_nan()},
            {{"part", "response", "step_s", "stiffness_N_per_m", "restitution"},
             {"impact_error_s", "height_error", "drift_m_per_s", "predicted_step_s", "measured_step_s"}},
            {{"step", step_cases, step_charts}, {"limit", limit_cases, limit_charts}}};
}

}  // namespace drape
