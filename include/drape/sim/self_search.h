#pragma once

#include <span>
#include <vector>

#include "drape/base/copied.h"
#include "drape/base/snapshot_text.h"
#include "drape/bounds/fold_test.h"
#include "drape/contact/impact_zones.h"
#include "drape/contact/near_pairs.h"
#include "drape/contact/response.h"
#include "drape/scene/settings.h"
#include "drape/sim/pair_list.h"

namespace drape {

/// What a search has cost.
struct SelfSearchReport {
    TraversalStats traversal;
    std::int64_t listed = 0;  ///< pairs of features that are looked at
    bool gave_up = false;     ///< so much is near that the list would be too long; nothing was found
};

/// Contact of the cloths of a scene with themselves and with each other: what comes near, and the fail-safe that holds
/// it back. It does nothing, and costs nothing, where a scene has not asked for it.
///
/// What was found within a wide margin serves as a list for as long as nothing has moved far enough for other pairs to
/// come near @cite verlet1967: most substeps look at those pairs of the list alone whose particles have moved enough
/// since, and where it is empty they cost some passes over the displacements. What all particles move by in the mean
/// brings none of them nearer to another, and does not count.
class SelfSearch {
public:
    /// Pairs that there may be, a particle in the mean. What blows up soon has more, and would take minutes.
    static constexpr int max_pairs = 200;

    /// Starts from nothing with these cloths.
    void use(const Settings& settings, std::span<const ClothInContact> cloths);

    /// Goes on with other hierarchies, which find the same.
    void use(BroadPhaseParameters parameters, std::span<const ClothInContact> cloths);

    /// What it finds does not depend on them.
    /// @param threads that share the work, at least 1
    void use_threads(int threads) { list_.use(threads); }

    [[nodiscard]] bool on() const { return on_; }

    /// What was found at the start; pairs are looked for again.
    void exchange(SnapshotText& text) { text.line("cloth_at_start", crossings_at_start_, coincident_at_start_); }

    /// Positions have been set from outside.
    void forget();

    /// Finds the pairs, at the start of the substep, that may come into contact within it, after the integrator's step
    /// and the warm start.
    /// @param thickness of the cloths [m]
    const SelfSearchReport& find(std::span<const ClothInContact> cloths, Real thickness);

    /// The same as contacts.
    /// @param rows receives them, after what is there
    void find_contacts(const ResponseParameters& parameters, std::span<const ClothInContact> cloths,
                       std::vector<ContactRow>& rows);

    /// Looks whether any particle has been pushed farther than `find` has assumed, and if so finds the pairs that may
    /// meet on these longer ways too.
    /// @return whether it had to
    bool extend(std::span<const ClothInContact> cloths);

    /// After the response: whether features would meet within the substep, for all that it has done.
    /// @param responded whether anything may have moved cloth since `find`
    bool would_cross(std::span<const ClothInContact> cloths, bool responded);

    /// If so, holds them back.
    /// @return how many particles
    std::int64_t prevent_crossing(std::span<const ClothInContact> cloths);

    /// What is so near that it has been looked at, in the order of its features, whatever found it.
    [[nodiscard]] std::span<const NearPair> pairs() const { return near_; }

    /// How far each particle of a cloth may come, that the last list was made for.
    [[nodiscard]] std::span<const Real> allowances(int cloth) const { return of_cloth(allowance_, cloth); }

    /// How far both features of a pair reach together within the substep [m].
    [[nodiscard]] Real reach_of(const NearPair& pair) const;

    /// How many times cloth crossed cloth at the start: what keeps the sides of cloths cannot part these.
    [[nodiscard]] std::int64_t crossings_at_start() const { return crossings_at_start_; }

    /// In how many places cloth touched cloth at distance 0 then: they may cross.
    [[nodiscard]] std::int64_t coincident_at_start() const { return coincident_at_start_; }

    /// What the search of this substep has cost.
    [[nodiscard]] const SelfSearchReport& report() const { return report_; }

private:
    using Numbers = Eigen::Array<Real, Eigen::Dynamic, 1>;  ///< of the particles of all cloths

    struct Surface {
        Copied<BroadPhase> tree;
        FoldTest folds;
        CellBoxes boxes = {};
        bool boxed = false;  ///< since the last list or count was begun
        Points kept = {};    ///< what the list was made from
        Real spacing;        ///< of its particles at rest [m]
    };

    std::int64_t count_coincident(std::span<const ClothInContact> cloths);
    template <class Count>
    std::int64_t count_between(std::span<const ClothInContact> cloths, Real reach, Count count);
    void find_reaches(std::span<const ClothInContact> cloths, Real factor, Numbers& reaches, Numbers& strayed);
    void find_mean_motion(std::span<const ClothInContact> cloths);
    [[nodiscard]] Real next_ahead() const;
    void set_allowances(Real factor);
    [[nodiscard]] bool is_too_far() const;
    void look_at_pairs(std::span<const ClothInContact> cloths);
    void renew_list(std::span<const ClothInContact> cloths, Real factor);
    void make_list(std::span<const ClothInContact> cloths);
    BoxedCloth boxed(std::span<const ClothInContact> cloths, std::size_t number, const Numbers& reaches);
    void search(std::span<const ClothInContact> cloths, std::size_t first, std::size_t second);
    [[nodiscard]] Real sum_of_largest(const FeaturePair& pair, const Numbers& of_particles) const;
    [[nodiscard]] std::span<const Real> of_cloth(const Numbers& of_particles, int cloth) const;

    bool on_ = false;
    SelfSearchReport report_;
    std::int64_t crossings_at_start_ = 0, coincident_at_start_ = 0;
    ImpactZones zones_;
    Real thickness_ = 0;              ///< of the cloths, as in the last search [m]
    std::vector<Surface> surfaces_;   ///< of each cloth
    std::vector<std::size_t> first_;  ///< particle of each cloth, among all
    bool listed_ = false;             ///< there is a list
    std::vector<LeafPair> leaves_;
    PairList list_;
    Real ahead_ = 0;  ///< substeps that its margins are for
    std::vector<NearPair> near_;
    Vec3 kept_mean_ = Vec3::Zero();        ///< of the positions of all particles when the list was made [m]
    Vec3 mean_ = Vec3::Zero();             ///< the same at the start of the substep [m]
    Vec3 moved_ = Vec3::Zero();            ///< by how much it moves within the substep [m]
    Numbers reaches_;                      ///< how far each particle may come within it, with half the thickness
    Numbers displacement_since_list_;      ///< the reach, and what each has moved by since the list was made
    Numbers allowance_;                    ///< by the list: it serves while nothing has strayed farther
    Numbers more_reaches_, more_strayed_;  ///< of what the response has moved
};

}  // namespace drape
