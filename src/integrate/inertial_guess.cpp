#include "inertial_guess.h"

#include "drape/model/forces.h"

namespace drape {

void InertialGuess::advance(const ClothModel& model, ClothState& state, Real h) {
    outer_ = model;
    outer_.structural = outer_.shear = outer_.bend = {};
    compute_forces(outer_, state.x, state.v, f_);
    forces_to_accelerations(model, f_);
    state.v += (h * model.particle_mass / inertia(model, h)) * f_;
    state.x += h * state.v;
}

void take_velocity_from_way(const ClothModel& model, const Points& start, Real h, ClothState& state) {
    for (Eigen::Index p = 0; p < start.rows(); ++p) {
        if (model.inverse_mass[p] > 0) state.v.row(p) = (state.x.row(p) - start.row(p)) / h;
    }
}

}  // namespace drape
