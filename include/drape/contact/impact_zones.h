#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "drape/contact/feature_motion.h"
#include "drape/contact/near_pairs.h"
#include "drape/contact/response.h"

namespace drape {

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
    /// @param first number of each cloth's first particle among all, and of all in the end; it has to last
    /// @param least distance that cloth is to keep from cloth, whatever presses it [m]
    /// @return whether there are any
    bool find(std::span<const NearPair> pairs, std::span<const ClothInContact> cloths,
              std::span<const std::size_t> first, Real least);

    /// Holds back what was found, and what meets these in turn.
    /// @param pairs all that may meet
    void prevent_crossing(std::span<const NearPair> pairs, std::span<const ClothInContact> cloths);

    /// How many particles are in zones, since the last `find`.
    [[nodiscard]] std::int64_t particles() const;

private:
    struct Member {
        int cloth, particle;
        Vec3 displacement, velocity;  ///< as they would have been [m, m/s]
    };
    struct Zone {
        std::vector<Member> members;
        Real part = 1;  ///< of the motion within
    };

    [[nodiscard]] std::size_t number_of(int cloth, int particle) const;
    [[nodiscard]] int zone_of(const NearPair& pair, std::size_t k) const;
    [[nodiscard]] FeatureMotion motion_of(const NearPair& pair, std::span<const ClothInContact> cloths) const;
    [[nodiscard]] FeatureMotion free_motion_of(const NearPair& pair, std::span<const ClothInContact> cloths) const;
    [[nodiscard]] bool within_one_zone(const NearPair& pair) const;
    [[nodiscard]] int largest_zone_of(const NearPair& pair) const;
    void join(const NearPair& pair, std::span<const ClothInContact> cloths, Real part);
    void add(int zone, const Member& member);
    static Vec3 mean(std::span<const ClothInContact> cloths, const Zone& zone, Vec3 Member::*value);
    void move_zones(std::span<const ClothInContact> cloths) const;

    Real least_ = 0;                      ///< distance [m]
    std::span<const std::size_t> first_;  ///< particle of each cloth, among all
    std::vector<int> zone_of_;            ///< of each particle; -1: none
    std::vector<int> place_in_;           ///< there
    std::vector<Zone> zones_;             ///< those that have joined others are empty
};

}  // namespace drape
