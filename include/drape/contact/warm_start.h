#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "drape/contact/response.h"

namespace drape {

/// What a response starts from: the pushes of the substep before. @cite catto2005
/// To an implicit method they are a force that lasts for its step: a velocity that is given before the step, or half
/// before and half after it where a force displaces by half of what its velocity would (`displacement_share`). What
/// rests does not move then. An explicit method takes its forces from the start of the step, where a velocity would be
/// answered by dampers: it is given the pushes after the step, displacements too. Either way the response has little
/// left to solve. Under an implicit method, but for adaptive ones, the push of a contact that rolls goes ahead of it,
/// where it would feed the rocking of cloth otherwise. What the projection displaces by under the implicit midpoint
/// rule does not measure a force. The impulses that stop velocities do measure it, and go on instead, unless a free
/// ball touches the cloth. Only responses that solve for pushes can use them; a penalty follows from the depth.
/// @tparam AnyContact `Contact`, of one cloth with balls and ground, or `PairContact`
template <class AnyContact>
class WarmStart {
public:
    /// Room for this many contacts without allocating.
    void reserve(std::size_t contacts) { last_.reserve(contacts), parted_.reserve(contacts), gaps_.reserve(contacts); }

    /// Takes the pushes of the substep before.
    /// @param h the substep to come [s]
    /// @param gravity [m/s^2]
    /// @param cloths as they are now: a particle may have been grabbed, or a mass set, since
    /// @param contacts of the substep before; left empty where the response solves for pushes
    void take(const ResponseParameters& parameters, Real h, Real gravity, std::span<const ClothInContact> cloths,
              std::vector<AnyContact>& contacts);

    /// Forgets the pushes.
    void forget() { last_.clear(); }

    /// Gives what a method is to have before its step, and after it. Balls have moved before either.
    void before_step(std::span<const ClothInContact> cloths, std::span<Ball> balls) const;
    void after_step(std::span<const ClothInContact> cloths, std::span<Ball> balls) const;

    /// Tells the contacts that were found now what was given to them. Those of before that were not found again join
    /// them, for the response to take back what they do not need.
    void carry_over(const ResponseParameters& parameters, std::span<const ClothInContact> cloths,
                    std::span<const Ball> balls, std::vector<AnyContact>& contacts);

    /// The contacts whose pushes were taken; zero of those that may have been an impact.
    [[nodiscard]] std::span<const AnyContact> pushes() const { return last_; }

private:
    void insert(std::vector<AnyContact>& contacts) const;

    Real h_ = 0;                  ///< of the last pushes [s]
    Real before_ = 0;             ///< what of a velocity is given before the step
    bool is_explicit_ = true;     ///< nothing is, and displacements are given
    bool of_velocities_ = false;  ///< the pushes are impulses; what they displaced by goes back where a contact parted
    std::vector<AnyContact> last_, parted_;
    std::vector<std::ptrdiff_t> gaps_;  ///< where those that have parted belong
};

}  // namespace drape
