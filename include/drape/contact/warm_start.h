#pragma once

#include <span>
#include <vector>

#include "drape/base/copied.h"
#include "drape/base/snapshot_text.h"
#include "drape/contact/response.h"

namespace drape {

/// What a response starts from: what it gave in the substep before, found again by the features that touch
/// @cite catto2005. Once the integrator has made its step, each contact that rests is given its last displacement, and
/// its last impulse times the factor by which a force of the method displaces (see `displacement_factor`): given all of
/// it where that is 1/2, cloth rocks between its contacts for ever. The response takes back what is too much. Only
/// responses that solve for impulses can use them; a penalty follows from the depth. The hybrid is told no more than
/// which contacts were there before.
class WarmStart {
public:
    /// Room for this many contacts, without allocating.
    void reserve(std::size_t contacts) { last_.reserve(contacts), merged_.reserve(contacts); }

    /// Takes the contacts of the substep before.
    /// @param h the substep to come [s]
    /// @param gravity [m/s^2]
    /// @param cloths as they are now: a particle may have been grabbed, or a mass set, since
    /// @param rows of the substep before; emptied
    void take(const ResponseParameters& parameters, Real h, Real gravity, std::span<const ClothInContact> cloths,
              std::span<const Body> bodies, std::vector<ContactRow>& rows);

    /// What the next substep goes on from, beside the contacts.
    void exchange(SnapshotText& text) { text.line("warm_start", within(h_, 0, 1)); }

    /// Forgets them.
    void forget() { last_.clear(); }

    /// Gives their impulses, after the integrator's step. Balls have moved before.
    void give(std::span<const ClothInContact> cloths, std::span<Body> bodies) const;

    /// Their work on a cloth, as steady forces along all that its particles have moved by in the substep [J].
    [[nodiscard]] double work(std::span<const ClothInContact> cloths, int cloth) const;

    /// Tells the contacts that were found now what was given to them. Those of before that were not found again join
    /// them, for the response to take back what they do not need.
    /// @param rows in the order of `compare`
    void carry_over(std::span<const ClothInContact> cloths, std::span<const Body> bodies,
                    std::vector<ContactRow>& rows);

    /// The contacts of before; those that may have been an impact are given nothing.
    [[nodiscard]] std::span<const ContactRow> rows() const { return last_; }

private:
    Real h_ = 0;  ///< of the last impulses [s]
    std::vector<ContactRow> last_;
    ScratchOnCopy<std::vector<ContactRow>> merged_;
};

}  // namespace drape
