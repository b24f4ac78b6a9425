#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "drape/base/copied.h"
#include "drape/contact/response.h"

namespace drape {

/// What a response starts from: the pushes of the substep before. @cite catto2005
/// Those that go on are the impulses that stopped velocities, as forces among those of the cloth: what rests does not
/// move in the step then, and the projection has little left to displace. What it did displace by is no measure of the
/// force. It holds every contact to its depth, and where one is a micrometre too high it pushes less: given on, that
/// rocks the cloth between its contacts.
/// There are exceptions, and BDF2 is one: there displacements go on. A method that takes its forces from the start of
/// the step alone would answer a push there by dampers: it is given the pushes after the step, displacements too. For
/// pairs, displacements go on: to an implicit method as a velocity before the step, to others after it. So they do for
/// all contacts where cloths meet, if a force displaces by all of what its velocity would, and, under methods without a
/// step limit but Dormand-Prince, while a free ball touches the cloth: contacts that nothing holds to their depth part
/// under it in long substeps. The push of a contact that rolls goes ahead of it, where it would feed the rocking of
/// cloth otherwise: where it is a force of the step, and under implicit methods to which a force displaces by all of
/// what its velocity would. Only responses that solve for pushes can use them; a penalty follows from the depth. The
/// hybrid is told no more than which contacts were there before.
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
    /// @param contacts of the substep before; emptied, except under penalties
    void take(const ResponseParameters& parameters, Real h, Real gravity, std::span<const ClothInContact> cloths,
              std::vector<AnyContact>& contacts);

    /// Forgets the pushes.
    void forget() { last_.clear(); }

    /// The pushes that are forces of the step, n x 3 [N]; null if none are. They last until this is called again.
    [[nodiscard]] const Real* within_step(const ClothModel& model);

    /// Gives free balls what pushes them by these forces. They have moved before the step.
    void push_balls(std::span<Ball> balls) const;

    /// The contacts of the others.
    [[nodiscard]] std::span<const AnyContact> beside_step() const {
        return of_velocities_ || !has_pushes_ ? std::span<const AnyContact>{} : last_;
    }

    /// Gives these: what a method is to have before its step, and after it. Balls have moved before either.
    void before_step(std::span<const ClothInContact> cloths, std::span<Ball> balls) const;
    void after_step(std::span<const ClothInContact> cloths, std::span<Ball> balls) const;

    /// The work of the others on a cloth, as steady forces along all that its particles have moved by in the substep
    /// [J].
    [[nodiscard]] double work_beside_step(std::span<const ClothInContact> cloths, int cloth) const;

    /// Tells the contacts that were found now what was given to them. Those of before that were not found again join
    /// them, for the response to take back what they do not need.
    void carry_over(const ResponseParameters& parameters, std::span<const ClothInContact> cloths,
                    std::span<const Ball> balls, std::vector<AnyContact>& contacts);

    /// The contacts whose pushes were taken; zero of those that may have been an impact.
    [[nodiscard]] std::span<const AnyContact> pushes() const { return last_; }

private:
    void keep_without_pushes(std::vector<AnyContact>& contacts);
    void insert(std::vector<AnyContact>& contacts) const;

    Real h_ = 0;                  ///< of the last pushes [s]
    Real ground_height_ = 0;      ///< as of the last `take` [m]
    bool is_explicit_ = true;     ///< pushes beside the step are given after it, displacements too; else before it
    bool has_pushes_ = true;      ///< else `last_` tells which contacts there were, no more
    bool of_velocities_ = false;  ///< the pushes are impulses; what they displaced by goes back where a contact parted
    NotCopied<std::vector<Real>> forces_;  ///< of `within_step`
    std::vector<AnyContact> last_, parted_;
    std::vector<std::ptrdiff_t> gaps_;  ///< where those that have parted belong
};

}  // namespace drape
