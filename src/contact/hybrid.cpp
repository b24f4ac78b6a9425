#include <algorithm>

#include "impulse.h"
#include "penalty.h"
#include "tuning.h"

// The penalty-impulse hybrid: an impulse where bodies meet faster than gravity alone brings them together within a few
// steps, a penalty where they rest. @cite constantinescu2005 Where something comes deep into a ball, impulses alone.

namespace drape {
namespace {

bool is_rest(const ContactProblem& problem, const ContactPlane& contact) { return !is_impact(problem, contact); }

bool has_deep_contact(const ContactProblem& problem) {
    return std::ranges::any_of(problem.cloths, [&](const ClothInContact& cloth) {
        return std::ranges::any_of(cloth.contacts, [&](const Contact& contact) {
            if (is_plane(contact.ball) || contact.of_node) return false;
            return is_impact(problem, contact) &&
                   contact.depth > deep_part * problem.balls[static_cast<std::size_t>(contact.ball)].radius;
        });
    });
}

}  // namespace

ResponseReport respond_by_hybrid(ContactProblem& problem) {
    if (has_deep_contact(problem)) return respond_by_impulses(problem);
    const Sweeps impacts = solve_impacts(problem), rest = solve_penalties(problem, is_rest);
    return {.residual = std::max(impacts.residual * problem.h, rest.residual), .sweeps = impacts.count + rest.count};
}

}  // namespace drape
