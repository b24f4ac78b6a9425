#pragma once

#include <vector>

#include "lab/experiment/experiment.h"

namespace drape {

/// Which steps stay bounded under which method, over stiffness and damping, beside the predicted limit.
Experiment stability_experiment();

/// What accuracy costs: the error of each method at a horizon against its time, over a ladder of steps.
Experiment precision_experiment();

/// Time of the hierarchy's build and query against how well it tells what touches, on recorded motions: by volume,
/// sphere fit, update policy and leaf size, by level, by the budget of a search, over frames, and by the number of
/// particles. Every query is checked against brute force; a disagreement ends the run.
Experiment hierarchy_experiment();

/// How many contacts a run misses and how far it lets the ball into the cloth, over step and speed of the ball, with
/// the full search and with limited ones, against the full search at a step a hundred times smaller.
Experiment contact_experiment();

/// What response and fail-safe leave where a sheet is thrown at another: crossings, penetration, error of the momentum
/// that is passed on, tests and time, over thickness and step, with the fail-safe and without, against a shorter step.
Experiment self_contact_experiment();

/// The five tests of the dissertation that the original was written for: a hierarchy of spheres against one of boxes,
/// on the original's scene.
Experiment original_experiment();

/// What a ball passes unseen between two steps, by its speed, beside what is predicted; and what it costs to find
/// what it may have met. Every such query is checked against all cells; a disagreement ends the run.
Experiment continuous_experiment();

/// The scene `drop` by every integrator, response and detection, with every volume and update: penetration, energy and
/// speed within bounds, and the same bits by every tree as by brute force; a disagreement ends the run.
Experiment combinations_experiment();

/// The four responses: what a step costs them in time of impact, height of a bounce and friction, and the step limit
/// of the penalty, predicted and measured.
Experiment responses_experiment();

/// How fast the scenes `drop` and `trampoline` are when they fall asleep, and after that with sleep switched off, by
/// every integrator and response that is stable there.
Experiment rest_experiment();

/// Implicit steps of large cloths: what a solve to a tolerance leaves beside the error of the step, and how the time of
/// a step grows with the particles.
Experiment solve_experiment();

/// The largest cloth that each method moves at 60 frames a second, and how far it then is from the converged one:
/// falling free, on a ball, and folding, on one thread and on two.
Experiment realtime_experiment();

/// How much model each scene needs: what is taken away from the full one until a need breaks, what one notch less of
/// each knob breaks, and how far the motion moves with one knob as in the full model.
Experiment minimal_experiment();

/// Which steps of each method hold a cloth, which leave it soft, and at which it blows up.
Experiment steps_experiment();

/// Every experiment of the laboratory.
inline std::vector<Experiment> all_experiments() {
    return {stability_experiment(),    precision_experiment(), hierarchy_experiment(),  contact_experiment(),
            self_contact_experiment(), original_experiment(),  continuous_experiment(), combinations_experiment(),
            responses_experiment(),    rest_experiment(),      solve_experiment(),      realtime_experiment(),
            minimal_experiment(),      steps_experiment()};
}

}  // namespace drape
