#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "drape/base/copied.h"
#include "drape/contact/response.h"

namespace drape {

/// What a response starts from: the pushes of the substep before. @cite catto2005
/// To an implicit method they are a force that lasts for its step: a velocity that is given before the step. What rests
/// does not move then. An explicit method takes its forces from the start of the step, where a velocity would be
/// answered by dampers: it is given the pushes after the step, displacements too. Either way the response has little
/// left to solve.
/// Where a force displaces by half of what its velocity would (`displacement_share`), what the projection displaces by
/// does not measure it. The impulses that stop velocities do, and go on instead, as forces among those of the cloth:
/// these methods ask for the forces more than once in a step, and what rests must rest there too. This is not done for
/// pairs, nor while a free ball touches the cloth: then displacements go on as for the others. Nor is it done for the
/// response by impulses, of which an implicit method of this kind gets half before its step and half after it.
/// The push of a contact that rolls goes ahead of it, where it would feed the rocking of cloth otherwise: where it is a
/// force of the step, and under implicit methods to which a force displaces by all of what its velocity would.
/// Only responses that solve for pushes can use them; a penalty follows from the depth.
/// @tparam AnyContact `Contact`, of one cloth with balls and ground, or `PairContact`
template <class AnyContact>
class WarmStart {
public:
    /// Room for this many contacts, and the forces on so many particles, without allocating.
    void reserve(std::size_t contacts, std::size_t particles) {
        last_.reserve(contacts), parted_.reserve(contacts), gaps_.reserve(contacts);
        forces_.reserve(3 * particles);
    }

    /// Takes the pushes of the substep before.
    /// @param h the substep to come [s]
    /// @param gravity [m/s^2]
    /// @param cloths as they are now: a particle may have been grabbed, or a mass set, since
    /// @param contacts of the substep before; left empty where the response solves for pushes
    void take(const ResponseParameters& parameters, Real h, Real gravity, std::span<const ClothInContact> cloths,
              std::vector<AnyContact>& contacts);

    /// Forgets the pushes.
    void forget() { last_.clear(); }

    /// The pushes that are forces of the step, n x 3 [N]; null if none are. They last until this is called again.
    [[nodiscard]] const Real* within_step(const ClothModel& model);

    /// The contacts of the others.
    [[nodiscard]] std::span<const AnyContact> beside_step() const {
        return of_velocities_ ? std::span<const AnyContact>{} : last_;
    }

    /// Gives these: what a method is to have before its step, and after it. Balls have moved before either.
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
    NotCopied<std::vector<Real>> forces_;  ///< of `within_step`
    std::vector<AnyContact> last_, parted_;
    std::vector<std::ptrdiff_t> gaps_;  ///< where those that have parted belong
};

}  // namespace drape
