#pragma once

#include <vector>

#include "drape/sim/contact_stage.h"

namespace drape {

/// Two free sheets of 1 m: the first, waved and askew, is thrown at the second, which lies still in the air.
struct ThrownSheet {
    Settings settings;              ///< of the sheets and their contact, the step left open
    std::vector<ClothState> start;  ///< of the sheets
    Vec3 gravity = Vec3::Zero();    ///< [m/s^2]
    double end = 0;                 ///< of a run [s]
};

/// @param speed of the first sheet [m/s]
/// @param thickness of both [m]
ThrownSheet throw_sheet(Real speed, Real thickness);

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

/// A simulation without all that contact between cloths does not need: the integrator and the contact stage of
/// `Simulation`, to the same bits, but that it does not divide steps, and may have another fail-safe or none.
class SelfContactTrial {
public:
    SelfContactTrial(const ThrownSheet& scene, Real step, FailSafe fail_safe);

    SelfContactStep advance();

    [[nodiscard]] const ClothState& state(std::size_t sheet) const { return cloths_[sheet].state; }

    /// Of one sheet [kg m/s].
    [[nodiscard]] Vec3 momentum(std::size_t sheet) const;

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

    Settings settings_;
    FailSafe fail_safe_;
    bool searched_ = true;  ///< in the last try
    Real h_;
    std::vector<Cloth> cloths_;
    ContactStage stage_;
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
SelfContactHistory watch_sheets(const ThrownSheet& scene, Real step, FailSafe fail_safe);

/// By how much what a run has given to the second sheet differs from what a reference has, part of that.
double momentum_error(const SelfContactHistory& run, const SelfContactHistory& reference);

}  // namespace drape
