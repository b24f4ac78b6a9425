#pragma once

#include "contact_trial.h"
#include "lab/experiment/experiment.h"

namespace drape {

/// How many contacts a run misses and how far it lets the ball into the cloth, over step and speed of the ball, with
/// the full search and with limited ones, against the full search at a step a hundred times smaller.
Experiment contact_experiment();

/// A hung cloth of 1 m and a ball on its way through the middle of it, from a quarter of a metre before they meet.
/// @param speed of the ball [m/s]
/// @param step of the run, of which the end is a multiple [s]
ContactScene hung_cloth_and_ball(double speed, double step);

}  // namespace drape
