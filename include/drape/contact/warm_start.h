#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "drape/contact/response.h"

namespace drape {

/// What a response starts from: what it gave in the substep before, found again by the features that touch
/// @cite catto2005. Once the integrator has made its step, each contact that rests is given its last displacement,
/// and its last impulse times the share by which a force of the method displaces (see `displacement_share`): given all
/// of it where that is 1/2, cloth rocks between its contacts for ever. The response takes back what is too much. Only
/// responses that solve for pushes can use them; a penalty follows from the depth. The hybrid is told no more than
/// which contacts were there before.
/// @tparam AnyContact `Contact`, of one cloth with balls and ground, or `PairContact`
template <class AnyContact>
class WarmStart {
public:
    /// Room for this many contacts, without allocating.
    void reserve(std::size_t contacts) {
        last_.reserve(contacts), separated_.reserve(contacts), gaps_.reserve(contacts);
    }

    /// Takes the pushes of the substep before.
    /// @param h the substep to come [s]
    /// @param gravity [m/s^2]
    /// @param cloths as they are now: a particle may have been grabbed, or a mass set, since
    /// @param contacts of the substep before; emptied, except under penalties
    void take(const ResponseParameters& parameters, Real h, Real gravity, std::span<const ClothInContact> cloths,
              std::vector<AnyContact>& contacts);

    /// Forgets the pushes.
    void forget() { last_.clear(); }

    /// Gives them, after the integrator's step. Balls have moved before.
    void give(std::span<const ClothInContact> cloths, std::span<Ball> balls) const;

    /// Their work on a cloth, as steady forces along all that its particles have moved by in the substep [J].
    [[nodiscard]] double work(std::span<const ClothInContact> cloths, int cloth) const;

    /// Tells the contacts that were found now what was given to them. Those of before that were not found again join
    /// them, for the response to take back what they do not need.
    void carry_over(const ResponseParameters& parameters, std::span<const ClothInContact> cloths,
                    std::span<const Ball> balls, std::vector<AnyContact>& contacts);

    /// The contacts whose pushes are given; zero of those that may have been an impact.
    [[nodiscard]] std::span<const AnyContact> pushes() const {
        return has_pushes_ ? std::span<const AnyContact>(last_) : std::span<const AnyContact>{};
    }

private:
    void keep_without_pushes(std::vector<AnyContact>& contacts);
    void insert(std::vector<AnyContact>& contacts) const;

    Real h_ = 0;              ///< of the last pushes [s]
    Real ground_height_ = 0;  ///< as of the last `take` [m]
    bool has_pushes_ = true;  ///< else `last_` tells which contacts there were, no more
    std::vector<AnyContact> last_, separated_;
    std::vector<std::ptrdiff_t> gaps_;  ///< where those that have parted belong
};

}  // namespace drape
