#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"
#include "drape/session/session.h"
#include "drape/session/state_csv.h"
#include "drape/sim/simulation.h"

namespace drape {

/// Whether a run warns of nothing, but for steps that projective dynamics has not solved in its few rounds.
inline bool only_few_rounds(const std::string& warning) {
    return warning.empty() ||
           (warning.starts_with("projective_dynamics has not solved") && warning.find(';') == std::string::npos);
}

/// A cloth of 10 x 8 particles, hung by two corners, and a ball that it swings against.
inline Settings small_settings() {
    Settings settings;
    ClothParameters& cloth = settings.cloths[0];
    cloth.particles = {10, 8};
    cloth.mass = 0.1F;
    cloth.place = Vec3(-0.5, 0.6, 0);
    cloth.pinned.kind = Pins::Kind::Two;
    cloth.structural = {200, 0.05};
    cloth.shear = {50, 0.05};
    cloth.bend = {2, 0.01};
    BallSettings ball;
    ball.radius = 0.25;
    ball.position = Vec3(0, 0.2, 0.4);
    ball.motion = BallMotion::Keys;
    settings.balls.push_back(ball);
    settings.ground.solid = false;
    settings.solver.dt = Real(1) / 1024;  // its multiples are exact
    settings.solver.integrator = IntegratorKind::SymplecticEuler;
    return settings;
}

/// `small_settings` with assignments on them.
inline Simulation small_simulation(const std::vector<std::string>& assignments = {}) {
    Settings settings = small_settings();
    assign_all(settings, assignments);
    return {"drop", std::move(settings)};
}

/// A shipped scene with assignments on it.
inline Settings shipped_settings(const std::string& scene, const std::vector<std::string>& assignments = {}) {
    Settings settings = load_scene(scene);
    assign_all(settings, assignments);
    return settings;
}
inline Simulation shipped_simulation(const std::string& scene, const std::vector<std::string>& assignments = {}) {
    return {scene, shipped_settings(scene, assignments)};
}

/// The shipped scenes that are made to fail, or the others.
inline std::vector<std::string> scenes_that_fail(bool fail) {
    std::vector<std::string> names = scene_names();
    std::erase_if(names, [&](const std::string& name) { return name.starts_with("fails_") != fail; });
    return names;
}

/// Every method but some.
inline std::vector<IntegratorKind> methods_but(const std::vector<IntegratorKind>& others) {
    std::vector<IntegratorKind> methods = values_of<IntegratorKind>();
    std::erase_if(methods, [&](IntegratorKind kind) { return std::ranges::count(others, kind) > 0; });
    return methods;
}

/// What the case of a test suite is called: as its parameter, or the two of which that is made.
constexpr auto name_of_param = [](const auto& about) -> std::string {
    if constexpr (std::is_enum_v<decltype(about.param)>) {
        return name_of(about.param);
    } else if constexpr (std::is_convertible_v<decltype(about.param), std::string>) {
        return about.param;
    } else {
        return name_of(std::get<0>(about.param)) + "_" + name_of(std::get<1>(about.param));
    }
};

inline void make_steps(Simulation& simulation, int count) {
    for (int i = 0; i < count; ++i) simulation.step();
}

/// In as much wall time as they take.
inline void make_steps(Session& session, int count) {
    session.send(command::Step{count});
    session.advance(0, 1e9);
}
inline void go_to(Session& session, std::int64_t step) {
    session.go_to(step);
    session.advance(0, 1e9);
}

/// Steps until a time, or until the cloth is lost, which fails the test.
/// @param look at it after each step
inline void run_until(
    Simulation& simulation, double time, const std::function<void()>& look = [] {}) {
    while (simulation.report().time < time && simulation.report().status == Status::Ok) {
        simulation.step();
        look();
    }
    EXPECT_EQ(simulation.report().status, Status::Ok) << simulation.report().error;
}

inline void send(Simulation& simulation, const std::string& text) { simulation.apply(parse_command(text)); }

inline Vec3 position_of(const Simulation& simulation, int particle) {
    return simulation.cloths()[0].state.x.row(particle).transpose();
}

/// Of the first cloth's particles and the balls together.
/// @pre no ball is too heavy to be moved
inline Vec3 whole_momentum(const Simulation& simulation) {
    const Cloth& cloth = simulation.cloths()[0];
    Vec3 sum = cloth.model.particle_mass * cloth.state.v.colwise().sum().transpose();
    for (const Ball& ball : simulation.balls()) sum += ball.velocity / ball.inverse_mass;
    return sum;
}

/// What `--state` writes of this moment.
inline std::string state_text(const Simulation& simulation) {
    std::ostringstream out;
    write_state_header(out, simulation);
    write_state(out, simulation);
    return out.str();
}

/// The report's figure of that name.
inline double figure(const StepReport& report, std::string_view name) {
    for (const ReportField& field : report_fields()) {
        if (field.name == name) return field.read(report);
    }
    ADD_FAILURE() << name;
    return 0;
}

}  // namespace drape
