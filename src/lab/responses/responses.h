#pragma once

#include "drape/contact/response.h"
#include "drape/integrate/integrator.h"
#include "lab/measure/statistics.h"

namespace drape {

/// What a fall of 0.5 m onto the ground has come to, with the restitution 0.6.
struct Bounce {
    double impact_error = no_number;  ///< of the time at which the way back, as a parabola, leaves the ground [s]
    double height_error = no_number;  ///< of the height of that parabola, part of what the restitution leaves
};

/// Drops a small sheet in a vacuum. A fall of H takes sqrt(2 H / g), and the first bounce comes to e^2 H.
/// @return nan for the time, and 1 for the height, if nothing comes back
Bounce drop_sheet(ResponseKind kind, Real step);

/// How a sheet that should stick moves.
struct Slide {
    double drift = no_number;       ///< down the slope, mean over the second half of a second [m/s]
    double sweeps = no_number;      ///< of the response over its contacts, mean over the steps
    Quartiles cost = no_quartiles;  ///< CPU time of a response [s]
};

/// Lays a sheet on a slope that is half a degree flatter than the friction angle.
Slide lay_on_slope(ResponseKind kind, Real step);

/// Where steps of the penalty begin to shake a sheet that rests on the ground, beside what is predicted [s].
struct PenaltyLimit {
    double predicted = no_number, measured = no_number;
};

/// Finds the measured one to within 0.5 %, by bisection. The sheet has no springs.
/// @param stiffness of the penalty [N/m]
PenaltyLimit find_penalty_limit(Real stiffness, Real restitution,
                                IntegratorKind integrator = IntegratorKind::SymplecticEuler);

}  // namespace drape
