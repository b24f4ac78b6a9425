#include "inertial_guess.h"

namespace drape {

void InertialGuess::advance(const ClothModel& model, ClothState& state, Real h) {
    external_ = model;
    external_.structural = external_.shear = external_.bend = {};
    const Real h_less_drag = h * model.particle_mass / inertia(model, h);
    forces_(external_, state.x, state.v, [&](const ForceRun& run) {
        run.of(state.v) += h_less_drag * run.accelerations();
        run.of(state.x) += h * run.of(state.v);
    });
}

void take_velocity_from_way(const ClothModel& model, const Points& start, Real h, ClothState& state) {
    for (Eigen::Index p = 0; p < start.rows(); ++p) {
        if (model.inverse_mass[p] > 0) state.v.row(p) = (state.x.row(p) - start.row(p)) / h;
    }
}

}  // namespace drape
