#include "inertial_guess.h"

namespace drape {

void InertialGuess::advance(const ClothModel& model, ClothState& state, Real h) {
    external_ = model;
    external_.structural = external_.shear = external_.bend = {};
    const Real h_less_drag = h * model.particle_mass / inertia(model, h);
    forces_(external_, state.x, state.v, [&](const ForceRun& run) {
        run.add_accelerations(h_less_drag, state.v);
        run.add(h, state.v, state.x);
    });
}

void set_velocity_from_displacement(const ClothModel& model, const Points& start, Real h, ClothState& state) {
    for (Eigen::Index p = 0; p < start.rows(); ++p) {
        if (model.inverse_mass[p] > 0) state.v.row(p) = (state.x.row(p) - start.row(p)) / h;
    }
}

}  // namespace drape
