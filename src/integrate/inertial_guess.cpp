#include "inertial_guess.h"

#include "drape/model/forces.h"

namespace drape {
namespace {

Real inertia_without_wind(const ClothModel& model, Real h) { return model.particle_mass + h * model.drag; }

}  // namespace

void find_inertia(const ClothModel& model, const ClothState& state, Real h, Numbers& inertia) {
    inertia.setConstant(model.grid.particles(), inertia_without_wind(model, h));
    if (model.air.density == 0) return;
    for (int triangle = 0; triangle < model.grid.triangles(); ++triangle) {
        const auto [a, b, c] = model.grid.triangle_corners(triangle);
        const Vec3 g = wind_resistance(model.air, {state.x.row(a), state.x.row(b), state.x.row(c)},
                                       {state.v.row(a), state.v.row(b), state.v.row(c)}, false);
        for (const int corner : {a, b, c}) inertia[corner] += 3 * h * g.squaredNorm();
    }
}

void InertialGuess::advance(const ClothModel& model, const Numbers& inertia, ClothState& state, Real h) {
    const Real calm = inertia_without_wind(model, h), h_less_drag = h * model.particle_mass / calm;
    external_ = model;
    external_.structural = external_.shear = external_.bend = {};
    external_.inverse_mass *= calm / inertia;
    forces_(external_, state.x, state.v, [&](const ForceRun& run) {
        run.of(state.v) += h_less_drag * run.accelerations();
        run.of(state.x) += h * run.of(state.v);
    });
}

void set_velocity_from_displacement(const ClothModel& model, const Points& start, Real h, ClothState& state) {
    for (Eigen::Index p = 0; p < start.rows(); ++p) {
        if (model.inverse_mass[p] > 0) state.v.row(p) = (state.x.row(p) - start.row(p)) / h;
    }
}

}  // namespace drape
