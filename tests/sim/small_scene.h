#pragma once

#include <string>
#include <utility>

#include "drape/sim/setting_table.h"
#include "drape/sim/simulation.h"

namespace drape {

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
    settings.solver.dt = Real(1) / 1024;  // its multiples are exact
    settings.solver.integrator = IntegratorKind::SymplecticEuler;
    return settings;
}

/// `small_settings` with assignments on them.
inline Simulation small_simulation(const std::vector<std::string>& assignments = {}) {
    Settings settings = small_settings();
    for (const std::string& assignment : assignments) assign(settings, assignment);
    return {"drop", std::move(settings)};
}

inline void make_steps(Simulation& simulation, int count) {
    for (int i = 0; i < count; ++i) simulation.step();
}

}  // namespace drape
