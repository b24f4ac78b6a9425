#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "drape/bounds/broad_phase.h"
#include "drape/contact/response.h"
#include "drape/integrate/integrator.h"

namespace drape {

/// What decides how a cloth and a ball move, apart from the scene.
struct Combination {
    IntegratorKind integrator{};
    ResponseKind response{};
    bool continuous = false;  ///< `contact.continuous`
};

/// What finds the triangles that touch; it must not change the motion.
struct SearchTree {
    VolumeKind volume = VolumeKind::Brute;
    UpdateKind update = UpdateKind::Rebuild;
    bool operator==(const SearchTree&) const = default;
};

/// Every integrator with every response, discrete and continuous.
std::vector<Combination> all_combinations();

/// Every volume with every update, brute force left out.
std::vector<SearchTree> all_trees();

/// One tree for each of `all_combinations`, such that any two values of integrator, response, detection, volume and
/// update meet in at least one of them.
/// @param number of the combination
SearchTree sampled_tree(std::size_t number);

/// What a run has come to.
struct CombinationRun {
    std::uint64_t hash = 0;  ///< of the last state
    bool diverged = false;   ///< and ended early
    double step = 0;         ///< [s]
    double touched = 0;      ///< steps that end with contacts
    double penetration = 0;  ///< largest depth of any triangle in the ball, of any particle in the ground, after a
                             ///< response, the thickness included [m]
    double energy_gain = 0;  ///< largest rise of the energy above the least so far, in units of the cloth's weight:
                             ///< the height by which that would lift it [m]
    double speed = 0;        ///< RMS over the particles at the end [m/s]
};

/// Runs the scene `drop` with a smaller cloth, at a step that suits the combination, and measures after each step.
/// @param seconds simulated
/// @param changes more settings, name=value
CombinationRun run_combination(const Combination& combination, const SearchTree& tree, double seconds,
                               const std::vector<std::string>& changes = {});

/// What a run by itself may have wrong, one word each, "none" first.
std::vector<std::string> run_flaws();

/// The first of them that a run has: it has diverged; nothing has touched; the cloth is deeper in the ball or in the
/// ground than it is thick; it has gained energy, which nothing in the scene can give it; it still moves at the end as
/// fast as after a fall of more than 1 cm.
std::string flaw_of(const CombinationRun& run);

}  // namespace drape
