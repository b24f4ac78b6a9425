#pragma once

#include "contact_trial.h"

namespace drape {

/// Two free sheets of 1 m without gravity: the first, waved and askew, is thrown at the second, which lies still in the
/// air.
/// @param speed of the first sheet [m/s]
/// @param thickness of both [m]
ContactScene throw_sheet(Real speed, Real thickness);

/// What is done where pairs would meet within a step, for all that the response has done.
enum class FailSafe {
    None,
    Zones,      ///< that of a simulation: particles of these pairs are held back, see `ImpactZones`
    Rejection,  ///< the step is taken back and made again in two halves, and each of them alike; where the search gives
                ///< up, too
};

/// What a step of a trial has done.
struct SelfContactStep {
    std::int64_t pair_tests = 0;  ///< of two volumes, and of two features
    std::int64_t held_back = 0;   ///< particles
    std::int64_t rejected = 0;    ///< steps and parts of steps that were taken back
    bool searched = true;         ///< the search has not given up
    bool halved_enough = true;    ///< false: a part would still cross after the most halvings
};

/// A trial of two cloths, which may have another fail-safe than a simulation or none.
class SelfContactTrial : public ContactTrial {
public:
    SelfContactTrial(const ContactScene& scene, Real step, FailSafe fail_safe)
        : ContactTrial(scene, step), fail_safe_(fail_safe) {}

    /// Makes a step, with what then touches and the fail-safe.
    SelfContactStep step();

    /// How many edges cross triangles that they share no particle with, in a sheet or between both: by every pair of
    /// cells, so that no search is trusted.
    [[nodiscard]] std::int64_t crossings() const;

    /// By how much two features that share no particle are nearer than the thickness, at most [m].
    [[nodiscard]] Real penetration() const;

private:
    template <class Visit>
    void for_each_two_sheets(Real reach, Visit visit) const;
    bool make(Real h, SelfContactStep& step);
    void make_in_halves(Real h, int halvings_left, SelfContactStep& step);

    FailSafe fail_safe_;
    bool searched_ = true;  ///< in the last try
};

/// What one run saw.
struct SelfContactHistory {
    std::int64_t crossings = 0;   ///< at the end
    double crossed_steps = 0;     ///< part of the steps that ended with crossings
    double unsearched_steps = 0;  ///< part of the steps in which the search gave up
    double unsafe_steps = 0;      ///< part of the steps that could not be halved often enough
    double penetration = 0;       ///< largest after any step; the thickness, where cloth crosses cloth [m]
    Vec3 given = Vec3::Zero();    ///< momentum that the first sheet has lost at the end [kg m/s]
    double momentum_change = 0;   ///< of both together, part of that at the start
    double pair_tests = 0;        ///< a step
    double held_back = 0;         ///< particles, a step
    double rejected = 0;          ///< tries, a step
};

/// Runs a scene to its end.
SelfContactHistory watch_sheets(const ContactScene& scene, Real step, FailSafe fail_safe);

/// By how much what a run has given to the second sheet differs from what a reference has, part of that.
double momentum_error(const SelfContactHistory& run, const SelfContactHistory& reference);

}  // namespace drape
