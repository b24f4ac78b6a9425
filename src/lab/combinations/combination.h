#pragma once

#include <cstdint>

#include "drape/scene/settings.h"
#include "lab/experiment/experiment.h"

namespace drape {

/// The scene `drop` with a smaller cloth by an integrator with a response, at a step that suits both. What touches is
/// found by brute force.
Settings combination_of(IntegratorKind integrator, ResponseKind response, bool continuous);

/// The same by one of all trees, a volume with an update, which must not change the motion. Any two values of
/// integrator, response, detection, volume and update meet in at least one of those for all combinations.
Settings with_sampled_tree(const Settings& combination);

/// What a run has come to.
struct CombinationRun {
    std::uint64_t hash;  ///< of the last state
    Row row;             ///< of the experiment's table, without what is combined
};

/// Runs a combination and measures after each step. The row tells the first flaw that it has by itself: it has
/// diverged; nothing has touched; the cloth is deeper in the ball or in the ground than it is thick; it has gained
/// energy, which nothing in the scene can give it; it still moves at the end as fast as after a fall of more than 1 cm.
/// @param seconds simulated
CombinationRun run_combination(const Settings& combination, double seconds);

}  // namespace drape
