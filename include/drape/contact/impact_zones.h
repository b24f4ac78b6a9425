#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "drape/contact/near_pairs.h"
#include "drape/contact/response.h"

namespace drape {

/// Two features as they move through a substep, on which each particle moves straight and evenly.
struct FeatureMotion {
    int first_count = 1;                 ///< particles of the first feature: 1 against a triangle, or 2 for two edges
    std::array<Vec3, 4> start{};         ///< the particles of the first feature, then those of the second [m]
    std::array<Vec3, 4> displacement{};  ///< [m]

    /// How far the features are apart after a part of the displacement [m].
    [[nodiscard]] Real distance_after(Real part) const;

    /// No two of their points come nearer to each other, nor farther from each other, than by this in all [m].
    [[nodiscard]] Real max_approach() const;
};

/// Which part of their displacement two features may go and still stay apart: 1 if they come nowhere nearer to each
/// other than a tenth of their distance, or else a part after which at least that is left. Nor do they come nearer than
/// the least distance that cloth is to keep, or nearer at all if they are already: else a load that lasts would press
/// them together substep by substep, down to rounding. By conservative advancement: what is left of the distance,
/// divided by the longest approach, is a part of the displacement on which they cannot meet.
/// @param distance at the start, above zero [m]
/// @param least that cloth is to keep [m]
/// @par Cost a distance a round; what is not about to meet needs none or one
Real safe_part_of(const FeatureMotion& motion, Real distance, Real least);

/// The fail-safe of contact between cloths: whatever the response has done, a substep that begins without a crossing
/// or a touch ends without one. Particles of features that would meet as they move form a zone @cite provot1997 which
/// goes on with its mean motion, and with only such a part of the motion within it that none of its features meet: what
/// moves as a whole keeps its distances. What a zone then meets joins it. In the end all may be one zone, and that has
/// nothing to meet: so this ends. A zone keeps its momentum, unless something in it is pinned. A bound on the motion of
/// each particle would be simpler, but bound the speed: where particles are d apart, none might move by more than d / 2
/// within a substep, though all move alike.
class ImpactZones {
public:
    /// Looks for pairs that meet.
    /// @param cloths, first number of each cloth's first particle among all, and of all in the end; they have to last
    /// @param least distance that cloth is to keep from cloth, whatever presses it [m]
    /// @return whether there are any
    bool find(std::span<const NearPair> pairs, std::span<const ClothInContact> cloths,
              std::span<const std::size_t> first, Real least);

    /// Holds back what was found, and what meets these in turn.
    /// @param pairs all that may meet
    void prevent_crossing(std::span<const NearPair> pairs);

    /// How many particles are in zones, since the last `find`.
    [[nodiscard]] std::int64_t particles() const;

private:
    struct Member {
        int cloth, particle;
    };
    struct Zone {
        std::vector<Member> members;
        Real part = 1;  ///< of the motion within
    };

    [[nodiscard]] std::size_t number_of(const Member& member) const {
        return first_[static_cast<std::size_t>(member.cloth)] + static_cast<std::size_t>(member.particle);
    }
    [[nodiscard]] const ClothInContact& cloth_of(int number) const { return cloths_[static_cast<std::size_t>(number)]; }
    [[nodiscard]] const ClothState& free_state_of(int cloth) const { return free_[static_cast<std::size_t>(cloth)]; }
    [[nodiscard]] int zone_of(const NearPair& pair, std::size_t k) const;
    [[nodiscard]] FeatureMotion motion_of(const NearPair& pair, bool freely) const;
    [[nodiscard]] bool keeps_together(const NearPair& pair) const;
    void join(const NearPair& pair, Real part);
    template <class Own>
    [[nodiscard]] Vec3 mean(const Zone& zone, Own own) const;
    void move_zones() const;

    Real least_ = 0;  ///< distance [m]
    std::span<const ClothInContact> cloths_;
    std::span<const std::size_t> first_;  ///< particle of each cloth, among all
    std::vector<ClothState> free_;        ///< where the cloths would have come to, when there was a zone last
    std::vector<int> zone_of_;            ///< of each particle; -1: none
    std::vector<Zone> zones_;             ///< those that have joined others are empty
};

}  // namespace drape
