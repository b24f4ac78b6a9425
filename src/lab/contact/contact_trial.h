#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "drape/scene/start_state.h"
#include "drape/sim/contact_stage.h"

namespace drape {

/// A simulation without all that contact does not need: the integrator and the contact stage of `Simulation`, to the
/// same bits, but that it does not divide steps. Balls go their way at constant velocity whatever they meet.
struct ContactTrial {
    /// @param start of the cloths; none: at rest
    explicit ContactTrial(Settings of, const std::optional<StartState>& start = {});

    /// Moves balls and cloths by a step of that length [s] and finds what then touches.
    void advance(Real h);

    /// Answers what was found.
    void respond() {
        stage.solve(report);
        stage.end();
    }

    /// Of a cloth [kg m/s].
    [[nodiscard]] Vec3 momentum(std::size_t cloth) const {
        return cloths[cloth].model.particle_mass * cloths[cloth].state.v.colwise().sum().transpose();
    }

    Settings settings;
    std::vector<Cloth> cloths;
    std::vector<Ball> balls;
    ContactStage stage;
    StepReport report;  ///< of the last step
    Points unpushed;    ///< where the integrator has left the first cloth [m]
};

/// Cloths, and how they start.
struct ContactScene {
    Settings settings;
    StartState start;
};

/// Two free sheets of 1 m without gravity: the first, waved and askew, is thrown at the second, which lies still in the
/// air.
/// @param speed of the first sheet [m/s]
/// @param thickness of both [m]
ContactScene throw_sheet(Real speed, Real thickness);

/// What is done where pairs would meet within a step, for all that the response has done.
enum class FailSafe {
    Zones,      ///< that of a simulation: particles of these pairs are held back, see `ImpactZones`
    Rejection,  ///< the step is taken back and made again in two halves, and each of them alike; where the search gives
                ///< up, too
    None
};

/// What a step of a trial has done, by columns of the table of `self_contact`: `pair_tests` of two volumes and of two
/// features; particles that were `held_back`; steps and parts of steps that were taken back, `rejected`; and 1 as
/// `unsearched_steps` if the search gave up, as `unsafe_steps` if a part would still cross after the most halvings.
using SelfContactCounts = std::map<std::string, std::int64_t>;

/// Makes a step of a trial, which may have another fail-safe than a simulation or none.
/// @param h [s]
SelfContactCounts make_step(ContactTrial& sheets, FailSafe fail_safe, Real h);

/// How two sheets meet themselves and each other.
struct SheetMeeting {
    std::int64_t crossings = 0;  ///< of edges through triangles that they share no particle with
    Real penetration = 0;  ///< by which features that share no particle are nearer than the thickness, at most; all of
                           ///< it where cloth crosses cloth [m]
};

/// By every pair of cells, so that no search is trusted.
SheetMeeting meeting_of(const ContactTrial& sheets);

}  // namespace drape
