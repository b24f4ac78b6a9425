#pragma once

#include <memory>
#include <span>
#include <vector>

#include "drape/bounds/fold_test.h"
#include "drape/contact/near_pairs.h"
#include "drape/contact/response.h"

namespace drape {

/// What a search has cost.
struct SelfSearchReport {
    TraversalStats traversal;
    std::int64_t cells = 0;   ///< pairs of them that were tested exactly
    std::int64_t listed = 0;  ///< pairs of features that are looked at
    bool kept_list = false;   ///< the list of the last search still served
};

/// Finds where the cloths of a scene come near themselves and each other. What was found within a wide margin serves
/// as a list for as long as nothing has moved far enough for other pairs to come near @cite verlet1967: most substeps
/// look at those pairs of the list alone whose particles have moved enough since, and where it is empty they cost one
/// pass over the displacements.
class SelfSearch {
public:
    /// Takes new hierarchies.
    void use(const BroadPhaseParameters& parameters, std::span<const ClothModel* const> models);

    /// Finds the pairs, at the start of the substep, that may come into contact within it, after the integrator's step.
    /// @param thickness of the cloths [m]
    SelfSearchReport find(std::span<const ClothInContact> cloths, Real thickness);

    /// Positions have been set from outside.
    void forget() { margin_ = 0; }

    /// In the order of their features, whatever found them.
    [[nodiscard]] std::span<const NearPair> pairs() const { return near_; }

    /// How far each particle may come to reach within the substep, with half the thickness: features of pairs that were
    /// not found are farther apart than both reach together. Cloth after cloth [m].
    [[nodiscard]] std::span<const Real> reaches() const { return reaches_; }

    /// How far both features of a pair reach together [m].
    [[nodiscard]] Real reach_of(const FeaturePair& pair) const { return sum_of_largest(pair, reaches_); }

private:
    struct Surface {
        std::unique_ptr<BroadPhase> tree;
        FoldTest folds;
        CellBoxes boxes;
        bool boxed = false;  ///< since the last list was begun
        Points kept;         ///< what the list was made from
    };

    /// A pair as it was when the list was made.
    struct Listed {
        FeaturePair features;
        int triangle;
        Real distance;  ///< [m]
    };

    Real find_reaches(std::span<const ClothInContact> cloths, Real thickness);
    [[nodiscard]] Real sum_of_largest(const FeaturePair& pair, std::span<const Real> of_particles) const;
    void make_list(std::span<const ClothInContact> cloths, SelfSearchReport& report);
    void search(std::span<const ClothInContact> cloths, int first, int second, SelfSearchReport& report);

    std::vector<Surface> surfaces_;  ///< of each cloth
    Real margin_ = 0;                ///< of the list; 0: there is none
    std::vector<LeafPair> leaves_;
    std::vector<Listed> list_;
    std::vector<NearPair> near_;
    std::vector<std::size_t> first_particle_;  ///< of each cloth, among all
    std::vector<Real> reaches_;                ///< of all particles [m]
    std::vector<Real> strayed_;                ///< by what each has moved since the list was made, and its reach [m]
};

}  // namespace drape
