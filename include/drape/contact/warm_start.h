#pragma once

#include <span>
#include <vector>

#include "drape/contact/response.h"

namespace drape {

/// What a response starts from: the pushes of the substep before. @cite catto2005
/// Given before the step of an implicit method, they are to it a force that lasts for the step, and what rests hardly
/// moves. An explicit method takes its forces from the start of the step, where they would be a velocity that dampers
/// answer: they are given after it. Either way the response has little left to solve. Only responses that solve for
/// pushes can use them; a penalty follows from the depth.
class WarmStart {
public:
    /// Room for this many contacts without allocating.
    void reserve(std::size_t contacts) { last_.reserve(contacts), merged_.reserve(contacts); }

    /// Gives the pushes of the last response to the velocities.
    /// @param contacts of the substep before; taken, and left empty, where the response solves for pushes
    /// @param displaces positions too: the step has been made
    void give(const ResponseParameters& parameters, Real h, const ClothModel& model, std::vector<Contact>& contacts,
              std::span<Ball> balls, ClothState& state, bool displaces);

    /// Tells the contacts that were found now what was given to them. Those of before that were not found again join
    /// them, for the response to take back what they do not need.
    void carry_over(const ResponseParameters& parameters, const Points& x, std::span<const Ball> balls,
                    std::vector<Contact>& contacts);

private:
    Real h_ = 0;  ///< of the last pushes [s]
    std::vector<Contact> last_, merged_;
};

}  // namespace drape
