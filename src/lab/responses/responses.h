#pragma once

#include "drape/contact/response.h"
#include "drape/integrate/integrator.h"
#include "lab/experiment/experiment.h"

namespace drape {

// Each gives some cells of a row of the experiment `responses`.

/// Drops a small sheet from 0.5 m in a vacuum onto the ground, with the restitution 0.6. A fall of H takes
/// sqrt(2 H / g), and the first bounce comes to e^2 H.
/// @return `impact_error_s` of the time at which the way back, as a parabola, leaves the ground, and `height_error` of
///         that parabola's height, part of what the restitution leaves; only the latter, 1, if nothing comes back
Row drop_sheet(ResponseKind kind, Real step);

/// Lays a sheet that should stick on a slope that is half a degree flatter than the friction angle.
/// @return `drift_m_per_s` down the slope and `sweeps` of the response, means over the second half of a second, and
///         `respond_s`, CPU time of a response
Row lay_on_slope(ResponseKind kind, Real step);

/// Where steps of the penalty begin to shake a sheet that rests on the ground. The sheet has no springs.
/// @param stiffness of the penalty [N/m]
/// @return `predicted_step_s`, and `measured_step_s` to within 0.5 %, by bisection
Row find_penalty_limit(Real stiffness, Real restitution, IntegratorKind integrator = IntegratorKind::SymplecticEuler);

}  // namespace drape
