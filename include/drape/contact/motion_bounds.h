#pragma once

#include <span>
#include <vector>

#include "drape/contact/near_pairs.h"
#include "drape/model/cloth_model.h"

namespace drape {

/// What bounds have cost.
struct BoundedMotion {
    int particles = 0;       ///< that were held back
    Real longest = 0;        ///< by which one was held back [m]
    double energy = 0;       ///< kinetic energy that this took [J]
    Vec3 momentum{0, 0, 0};  ///< and momentum [kg m/s]

    BoundedMotion& operator+=(const BoundedMotion& other);
};

/// How far each particle may go in a substep for no two features to touch on their way: the fail-safe of contact
/// between cloths. Two features at a distance d cannot meet while the particles of the one stay within a part of d of
/// where they were, and those of the other within the rest, for then no point of the one comes farther towards the
/// other than its part. The parts are as the reaches of both, which the search for pairs has assumed: features that it
/// did not find near are farther apart than their reaches together. A substep that begins without a crossing ends
/// without one, whatever the response has done.
class MotionBounds {
public:
    /// Forgets all pairs.
    /// @param particles of each cloth
    /// @param reaches of all particles, cloth after cloth; they have to last until the bounds are used [m]
    void start(std::span<const int> particles, std::span<const Real> reaches);

    /// @param pair at the start of the substep
    void tighten(const NearPair& pair);

    /// Moves what has gone too far back along its way to where it may be, and shortens its velocity as much.
    /// @param cloth its number
    /// @param before positions at the start of the substep [m]
    /// @par Cost O(particles)
    BoundedMotion hold_back(int cloth, const ClothModel& model, const Points& before, ClothState& state) const;

private:
    [[nodiscard]] std::size_t number_of(const NearPair& pair, std::size_t k) const;

    /// Of its part of the distance, that a particle may go: what is left keeps features apart in spite of rounding.
    static constexpr Real share = Real(0.9);

    std::span<const Real> reaches_;
    std::vector<std::size_t> first_;  ///< particle of each cloth, in `bounds_`
    std::vector<Real> bounds_;        ///< [m]
};

}  // namespace drape
