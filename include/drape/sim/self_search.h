#pragma once

#include <span>
#include <vector>

#include "drape/base/copied.h"
#include "drape/bounds/fold_test.h"
#include "drape/contact/near_pairs.h"
#include "drape/contact/response.h"
#include "drape/sim/pair_list.h"

namespace drape {

/// What a search has cost.
struct SelfSearchReport {
    TraversalStats traversal;
    std::int64_t listed = 0;  ///< pairs of features that are looked at
    bool gave_up = false;     ///< so much is near that the list would be too long; nothing was found
};

/// Finds where the cloths of a scene come near themselves and each other. What was found within a wide margin serves
/// as a list for as long as nothing has moved far enough for other pairs to come near @cite verlet1967: most substeps
/// look at those pairs of the list alone whose particles have moved enough since, and where it is empty they cost some
/// passes over the displacements. What all particles move by in the mean brings none of them nearer to another, and
/// does not count.
class SelfSearch {
public:
    /// Pairs that there may be, a particle in the mean.
    static constexpr int max_pairs = 400;

    /// Takes new hierarchies.
    void use(const BroadPhaseParameters& parameters, std::span<const ClothModel* const> models);

    /// What it finds does not depend on them.
    /// @param threads that share the work, at least 1
    void share(int threads) { list_.use(threads); }

    /// Finds the pairs, at the start of the substep, that may come into contact within it, after the integrator's step.
    /// @param thickness of the cloths [m]
    SelfSearchReport find(std::span<const ClothInContact> cloths, Real thickness);

    /// Looks whether any particle has been pushed farther than `find` has assumed, and if so finds the pairs that may
    /// meet on these longer ways too.
    /// @return whether it had to
    bool extend(std::span<const ClothInContact> cloths, SelfSearchReport& report);

    /// How many times cloths cross themselves and each other, see `count_crossings`.
    /// @param x positions of each cloth [m]
    std::int64_t count_crossings(std::span<const Points* const> x);

    /// In how many places cloths touch themselves and each other at distance 0.
    /// @param x positions of each cloth [m]
    std::int64_t count_coincident(std::span<const Points* const> x);

    /// Positions have been set from outside.
    void forget();

    /// In the order of their features, whatever found them.
    [[nodiscard]] std::span<const NearPair> pairs() const { return near_; }

    /// Of the cloths, as in the last search [m].
    [[nodiscard]] Real thickness() const { return thickness_; }

    /// How far each particle of a cloth may come, that the last list was made for.
    [[nodiscard]] std::span<const Real> allowances(int cloth) const { return of_cloth(allowance_, cloth); }

    /// How far both features of a pair reach together within the substep [m].
    [[nodiscard]] Real reach_of(const NearPair& pair) const;

    /// The number of each cloth's first particle among all, and of all in the end.
    [[nodiscard]] std::span<const std::size_t> first_particles() const { return first_; }

private:
    using Numbers = Eigen::Array<Real, Eigen::Dynamic, 1>;  ///< of the particles of all cloths

    struct Surface {
        Copied<BroadPhase> tree;
        FoldTest folds;
        CellBoxes boxes;
        bool boxed = false;  ///< since the last list was begun
        Points kept;         ///< what the list was made from
        Real spacing;        ///< of its particles at rest [m]
        Grid grid;
    };

    template <class Count>
    std::int64_t count_between(std::span<const Points* const> x, Real reach, Count count);
    void find_reaches(std::span<const ClothInContact> cloths, Real factor, Numbers& reaches, Numbers& strayed);
    void find_mean_motion(std::span<const ClothInContact> cloths);
    [[nodiscard]] Real next_ahead() const;
    void set_allowances(Real factor);
    [[nodiscard]] bool is_too_far() const;
    [[nodiscard]] bool is_too_long(std::size_t list) const;
    void look_at_pairs(std::span<const ClothInContact> cloths, SelfSearchReport& report);
    void renew_list(std::span<const ClothInContact> cloths, Real factor, SelfSearchReport& report);
    void make_list(std::span<const ClothInContact> cloths, SelfSearchReport& report);
    void search(std::span<const ClothInContact> cloths, int first, int second, SelfSearchReport& report);
    [[nodiscard]] Real sum_of_largest(const FeaturePair& pair, const Numbers& of_particles) const;
    [[nodiscard]] std::span<const Real> of_cloth(const Numbers& of_particles, int cloth) const;

    Real thickness_ = 0;
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
