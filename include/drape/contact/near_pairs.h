#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "drape/bounds/aabb.h"
#include "drape/bounds/broad_phase.h"
#include "drape/contact/contact_row.h"
#include "drape/model/grid.h"

namespace drape {

/// The particles of two features: a particle and a triangle, or an edge and an edge.
struct FeaturePair {
    std::array<int, 2> cloths{};     ///< numbers of the first feature's cloth and of the second's
    std::uint8_t first_count = 1;    ///< particles of the first feature: 1, or 2 for an edge against an edge
    std::array<int, 4> particles{};  ///< those of the first feature, then those of the second
    auto operator<=>(const FeaturePair&) const = default;

    /// Which feature the k-th particle belongs to, 0 or 1; and the number of its cloth.
    [[nodiscard]] std::size_t feature_of(std::size_t k) const { return static_cast<int>(k) < first_count ? 0 : 1; }
    [[nodiscard]] int cloth_of(std::size_t k) const { return cloths[feature_of(k)]; }
};

/// Two features that are near each other; of one cloth, they share no particle.
struct NearPair {
    FeaturePair features;
    int triangle = -1;              ///< of the second cloth, against a particle; -1: an edge against an edge
    std::array<Real, 4> weights{};  ///< of the particles in the closest points; those of each feature sum to 1
    Vec3 normal = Vec3::Zero();     ///< from the second's closest point to the first's, length 1
    Real distance = 0;              ///< of the closest points; 0: no more than rounding [m]
    bool is_representative = true;  ///< these two points are not those of another pair, which is answered for them

    /// What the k-th particle has of the offset from the second's closest point to the first's: less than zero for
    /// those of the second.
    [[nodiscard]] Real signed_weight(std::size_t k) const {
        return features.feature_of(k) == 0 ? weights[k] : -weights[k];
    }
};

/// A cloth as the search for pairs sees it.
struct ClothAt {
    int number;  ///< among all cloths
    const Grid& grid;
    const Points& x;  ///< n x 3 [m]
};

/// Finds the closest points of two features again where their cloths are now.
/// @param first, second the cloths of the features
void locate(const ClothAt& first, const ClothAt& second, NearPair& pair);

/// The contact of two features that are kept apart by a thickness [m].
ContactRow row_of(const NearPair& pair, Real thickness);

/// The boxes of all cells of a cloth, each grown by as far as its particles reach.
class CellBoxes {
public:
    /// @param reaches of each particle [m]; empty: none of them reaches farther than it is
    /// @par Cost O(cells)
    void build(const Grid& grid, const Points& x, std::span<const Real> reaches = {});

    [[nodiscard]] const Aabb& of(int cell) const { return boxes_[static_cast<std::size_t>(cell)]; }

    /// About all cells of a range.
    [[nodiscard]] Aabb of(const Grid& grid, const CellRange& cells) const;

private:
    std::vector<Aabb> boxes_;
};

/// A cloth, how far its particles reach, and the boxes of its cells that were built about both.
struct BoxedCloth {
    ClothAt cloth;
    const CellBoxes& boxes;
    std::span<const Real> reaches = {};  ///< of each particle [m]
};

/// Finds every particle and triangle, and every two edges, that share no particle and are nearer to each other than
/// both reach, each once: a feature reaches as far as that of its particles which reaches farthest. @cite bridson2002
/// @param leaves where they may be, as a query for pairs of these two cloths found
/// @param pairs receives them, after what it has; in no particular order
/// @par Cost O(pairs of cells in the leaves) tests of boxes, O(pairs of cells whose boxes come near) exact ones
void find_near_pairs(const BoxedCloth& first, const BoxedCloth& second, std::span<const LeafPair> leaves,
                     std::vector<NearPair>& pairs);

/// How many times an edge of one cloth crosses a triangle of the other, or, of one cloth, a triangle that it shares no
/// particle with: from one side to the other, through its inside. As a rule, two triangles that cross count twice.
/// What only touches, as far as rounding tells, does not count.
/// @param leaves where cells may meet, as a query for pairs of these two cloths found
/// @par Cost O(pairs of cells in the leaves)
std::int64_t count_crossings(const BoxedCloth& first, const BoxedCloth& second, std::span<const LeafPair> leaves);

}  // namespace drape
