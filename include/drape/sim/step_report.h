#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "drape/bounds/broad_phase.h"
#include "drape/integrate/integrator.h"
#include "drape/model/ball.h"
#include "drape/model/energy.h"
#include "drape/sim/energy_ledger.h"

namespace drape {

/// Whether the run can go on. Diverged: no; the last step has diverged, or could not be made, or a check that
/// `on_unstable = stop` asks for has ended the run.
enum class Status { Ok, Diverged };

/// Wall time of each stage of one step [s].
struct StageTimes {
    double step = 0, build = 0, traverse = 0, narrow = 0, pairs = 0, respond = 0;
    [[nodiscard]] double total() const { return step + build + traverse + narrow + pairs + respond; }
};

/// Where `contact.continuous` is false: that cloth and a ball or a solid are so fast that one may pass through
/// the other.
struct TunnellingRisk {
    std::int64_t starts = 0;  ///< of such dangers, each after half a second without
    double last = 0;          ///< time of the last substep in danger [s]
    double speed = 0;         ///< at which they approach each other at most, as the last danger started [m/s]
    double safe_speed = 0;    ///< up to which nothing passes through in such a substep [m/s]
};

/// Where a run has diverged: the first particle, and the other end of the worst of its springs; -1: none.
struct FailureSpot {
    int cloth = -1, particle = -1, other = -1;
};

/// What one step was and did; each stage fills its fields as it ends. Times and solves are those of all substeps,
/// counts those of the last.
struct StepReport {
    std::int64_t step = 0;              ///< steps since the start
    int substeps = 1;                   ///< of equal length, that a step is divided into
    double time = 0;                    ///< simulated [s]
    double step_limit_ratio = 0;        ///< length of a substep / predicted stability limit of the method; 0: no limit
    bool limit_is_lower_bound = false;  ///< the limit is at least as long as predicted: the true ratio may be less
    StageTimes times;
    SolveReport solve;
    TraversalStats traversal;             ///< for the balls
    TraversalStats ground;                ///< for the ground; zero where the hierarchy was not asked
    TraversalStats solids;                ///< for the solids
    double stretch_excess = 0;            ///< beyond the limit, of a structural spring at the end of the step
    double worst_stretch_excess = 0;      ///< since the start
    double overstretched = 0;             ///< time since the start with one above 0.1 and the limit itself [s]
    std::int64_t false_candidates = 0;    ///< cells handed on of which no triangle touches
    std::int64_t contacts = 0;            ///< points in contact, and nodes that were taken for them
    double contact_residual = 0;          ///< of the response, see `ResponseReport::residual` [m]
    TraversalStats between_cloths;        ///< for pairs of features of cloths
    std::int64_t listed_pairs = 0;        ///< of these, that are looked at
    std::int64_t pairs = 0;               ///< that the response was given
    std::int64_t failsafe_particles = 0;  ///< particles, by the fail-safe between cloths
    std::int64_t contact_sweeps = 0;      ///< of the response over its contacts
    double penetration = 0;               ///< largest depth left after the response [m]
    std::int64_t false_contacts = 0;      ///< of nodes at which the search has ended and in which no triangle touches
    double missed_penetration = 0;        ///< largest depth of any triangle after the response to a limited search [m]
    bool asleep = false;                  ///< counts and contacts are those of the last step that was awake
    std::int64_t unconverged = 0;         ///< steps since the start with a solve that kept more than its tolerance
    double worst_residual = 0;            ///< since the start, as `SolveReport::residual`
    double energy_excess = 0;             ///< largest of any cloth since the start, see `EnergyWatch` [J]
    IntegratorKind unsolved_by{};         ///< the method of the last of them
    IntegratorKind gained_by{};           ///< the method of `energy_gain_step`
    std::int64_t energy_gain_step = 0;    ///< the first that found energy gained from the integrator; 0: none
    double rms_speed = 0;                 ///< of the particles [m/s]
    Energy energy;  ///< this, balance and stretch are filled by `Simulation::view`, not by every step
    EnergyBalance balance = EnergyBalance::unknown();  ///< since the ledger began, over all cloths
    double stretch = 0;                                ///< largest elongation of a structural spring, as `energy`
    TunnellingRisk crossing;                           ///< since the start
    Status status = Status::Ok;
    FailureSpot failure;
    std::string error;  ///< one sentence on what broke, with particle and step; empty while all is well

    /// Sets to zero what limit and contacts of a substep add up to.
    void forget_contacts() {
        traversal = ground = solids = between_cloths = {};
        contacts = false_candidates = false_contacts = 0;
        penetration = missed_penetration = contact_residual = 0;
        contact_sweeps = listed_pairs = pairs = failsafe_particles = 0;
    }
};

/// What figures are about; the panel sets them apart by it, and shows those of `Limit` only while the search is
/// limited, those of `Pairs` only while cloths meet themselves and each other, those of `Balance` only while a ledger
/// is kept, those of `Doubt` only once there is one.
enum class ReportGroup { Time, Doubt, Stages, Hierarchy, Limit, Pairs, Energy, Balance };

/// Whether cloth was drawn out to far more than its limit, and not just until a new limit was kept.
inline bool is_overstretched(const StepReport& report) {
    constexpr double moment = 0.05;  // s
    return report.overstretched > moment;
}

/// Whether a run that goes on is not to be trusted: steps were not solved, the integrator has made energy, or cloth was
/// drawn out.
inline bool in_doubt(const StepReport& report) {
    return report.unconverged > 0 || report.energy_gain_step > 0 || is_overstretched(report);
}

/// One field of a report, for CSV, panel and tests.
struct ReportField {
    std::string_view name;  ///< as in the CSV header
    std::string_view unit;  ///< "s", "us", "m", "m/s", "J"; "1" for a ratio; empty for counts and flags
    double (*read)(const StepReport&);
    std::string_view label = {};  ///< in the panel; empty: it is not there
    ReportGroup group = ReportGroup::Time;
    int importance = 0;                            ///< in the panel the least goes first where there is no room
    double (*whole)(const StepReport&) = nullptr;  ///< what it is a part of, if it is one
};

/// All fields, in the order of CSV and panel.
std::span<const ReportField> report_fields();

/// A figure of each ball, for CSV and tests.
struct BallField {
    std::string_view name, unit;
    double (*read)(const Ball&);
};

/// Where each ball is, how fast it moves and how fast it turns, in the order of the CSV.
std::span<const BallField> ball_fields();

}  // namespace drape
