#pragma once

#include <span>
#include <string>

#include "drape/scene/settings.h"
#include "drape/sim/cloth.h"
#include "drape/sim/step_report.h"

namespace drape {

/// The most substeps of a step that the limits ask for.
constexpr double max_substeps = 1000;

/// Predicts the longest stable substep and says in the report how near to it a substep is, and in how many of them a
/// step is made: under `on_unstable = substep` as many as the limit asks for, else `fewest`.
/// @par Cost that of `predicted_limit` for each cloth; allocates
void plan_substeps(std::span<const Cloth> cloths, const Settings& settings, int fewest, StepReport& report);

/// Whether it is time to plan again: springs that are drawn out or pushed together vibrate faster than at the start.
/// Substeps then only become more: a symplectic method whose step changes to and fro gains energy.
bool plan_is_due(const SolverSettings& solver, const StepReport& report);

/// In how many substeps a step is made: as planned, or more under an implicit method while cloth or balls touch.
int substeps_in_contact(const Settings& settings, bool may_touch, int planned);

/// Whether steps are divided because a free ball may come to a cloth within half a second, under XPBD: its springs are
/// softer in a long step than in a short one. A sheet whose steps were divided only once a ball touched it would sag
/// until then, and throw the ball higher than it fell from. @cite macklin2019
/// @par Cost O(particles)
bool softens_before_ball(const Settings& settings, std::span<const Cloth> cloths, std::span<const Ball> balls);

/// How many substeps a step needs for no ball and no particle near it to come nearer to each other within one than half
/// the ball's radius, by their speeds at its start and gravity; at most 128. What else forces add within the step is
/// not foreseen. 1 where `contact.continuous` is false.
/// @par Cost O(particles), and O(particles) more for each ball that fast cloth may come to
int substeps_of_balls(const Settings& settings, std::span<const Cloth> cloths, std::span<const Ball> balls);

/// Whether cloth or a free ball may touch anything within an undivided step whose substeps in contact would be shorter,
/// where the response has penalties: at the end of a long step a penalty is pressed in so deep that it throws off what
/// has just touched it.
/// @par Cost O(particles x (balls + solids)); none for other methods and responses
bool may_touch(const Settings& settings, std::span<const Cloth> cloths, std::span<const Ball> balls,
               std::span<const Solid> solids);

/// In how many substeps a step is made where cloths meet themselves and each other: in none of them a particle goes
/// farther than half of what particles are apart at rest, but for what all move by together. What is longer would bring
/// every neighbour near. By the velocities at its start, and at most 32.
int substeps_of_motion(std::span<const Cloth> cloths, const SolverSettings& solver);

/// The longest `solver.dt` that is stable undivided, by the limits of the method, as in the report, and of the penalty
/// [s]. Infinity: no limit; 0: no step is stable, or none that may be set.
/// @param planned substeps of a step without contact
double longest_step(const Settings& settings, std::span<const Cloth> cloths, const StepReport& report, int planned);

/// What is wrong where a substep is longer, as a sentence with a space after it; empty if nothing.
std::string limit_advice(const Settings& settings, double longest, int substeps);

/// That a substep is longer than the limit of the penalty at a particle of some cloth, where the response has one, in
/// one line; empty if it is not.
/// @param planned substeps of a step without contact
std::string penalty_limit_warning(const Settings& settings, std::span<const Cloth> cloths, int planned);

/// That a step is longer than the method's limit, in one line; empty if it is not.
/// @param planned substeps of a step, as in the report's ratio
std::string step_limit_warning(const SolverSettings& solver, const StepReport& report, int planned);

}  // namespace drape
