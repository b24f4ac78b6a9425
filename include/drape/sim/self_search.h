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
/// look at the pairs in the list alone, and where it is empty they cost one pass over the displacements.
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

    /// All others are farther apart [m].
    [[nodiscard]] Real margin() const { return near_margin_; }

private:
    struct Surface {
        std::unique_ptr<BroadPhase> tree;
        FoldTest folds;
        CellBoxes boxes;
        bool boxed = false;  ///< since the last list was begun
        Points kept;         ///< what the list was made from
    };

    void make_list(std::span<const ClothInContact> cloths, SelfSearchReport& report);
    void search(std::span<const ClothInContact> cloths, int first, int second, SelfSearchReport& report);

    Kernels kernels_ = Kernels::Vector;
    std::vector<Surface> surfaces_;  ///< of each cloth
    Real margin_ = 0;                ///< of the list; 0: there is none
    std::vector<LeafPair> leaves_;
    std::vector<NearPair> list_;  ///< as they were when it was made
    std::vector<NearPair> near_;
    Real near_margin_ = 0;
};

}  // namespace drape
