#pragma once

#include <cmath>
#include <span>

#include "drape/model/cloth_model.h"
#include "drape/sim/cloth_energy.h"
#include "drape/sim/cloth_integrator.h"
#include "drape/sim/contact_search.h"

namespace drape {

/// A cloth with all that its steps need.
struct Cloth {
    ClothModel model;
    ClothState state;
    ClothState previous;  ///< one step before `state`
    Points before;        ///< positions one substep before, where steps are divided
    ClothIntegrator integrator;
    ContactSearch search;
    ClothEnergy energy;
    int grabbed = -1;    ///< particle that the hand leads; below 0: none
    Real pin_speed = 0;  ///< of the fastest pin that `MovingPins` leads [m/s]
};

/// RMS speed of all particles in the last step, by what they have moved [m/s]. Velocities are no measure of rest: those
/// of cloth that penalties hold are what the forces of the next step take away again.
/// @param step its length [s]
[[nodiscard]] inline double rms_motion(std::span<const Cloth> cloths, double step) {
    Real squares = 0, particles = 0;
    for (const Cloth& cloth : cloths) {
        squares += (cloth.state.x - cloth.previous.x).squaredNorm();
        particles += static_cast<Real>(cloth.state.x.rows());
    }
    return static_cast<double>(std::sqrt(squares / particles)) / step;
}

}  // namespace drape
