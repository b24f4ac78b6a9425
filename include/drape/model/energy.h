#pragma once

#include "drape/base/kernels.h"
#include "drape/model/cloth_model.h"

namespace drape {

/// Mechanical energy of a cloth [J].
struct Energy {
    double kinetic = 0;
    double gravity = 0;  ///< relative to y = 0
    double spring = 0;
    [[nodiscard]] double total() const { return kinetic + gravity + spring; }
};

/// What takes mechanical energy from a cloth at a moment, and what gives it [W]. With no error in time,
/// dE/dt = wind + hand + pins - damping - drag.
struct Power {
    double damping = 0;  ///< taken by the springs: sum of c (n.(v_a - v_b))^2
    double drag = 0;     ///< taken by the air: sum of b v^2
    double wind = 0;     ///< given by the wind: sum of f.v
    double hand = 0;     ///< given by what moves the particles that are held: sum of -f.v over them
    double pins = 0;     ///< what of that pins that move give, once it is told apart
};

/// @par Cost as `compute_dissipation`
Energy compute_energy(const ClothModel& model, const ClothState& state, Kernels kernels);

/// The most that the wind can give a cloth, whatever its motion [W]. A plate that yields to a wind W with the speed w
/// is given 1/2 C rho A (W - w)^2 w, which is the most at w = W/3. Twice that of the cloth at rest, for it may be
/// stretched.
double max_wind_power(const ClothModel& model);

/// Both at one moment.
struct EnergyFlow {
    Energy energy;
    Power power;
};

/// But for the power of wind, hand and pins.
/// @par Cost O(n), as a force evaluation; sums run in a fixed order
EnergyFlow compute_dissipation(const ClothModel& model, const Points& x, const Points& v, Kernels kernels);

/// @param wind n x 3, overwritten where wind blows: its forces [N]
/// @par Cost O(n), as a force evaluation, and somewhat more where wind blows
EnergyFlow compute_energy_flow(const ClothModel& model, const Points& x, const Points& v, Points& wind,
                               Kernels kernels);

/// The energy a second that whatever moves a held particle puts in at a moment [W]: the work against the forces of
/// springs, air and gravity on that particle, but for the wind's; less than zero where they pull it along.
double held_power(const ClothModel& model, const Points& x, const Points& v, int particle);

}  // namespace drape
