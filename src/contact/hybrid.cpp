#include "impulse.h"
#include "penalty.h"

// The penalty-impulse hybrid: an impulse where bodies meet faster than gravity alone brings them together within a few
// steps, a penalty where they rest. @cite constantinescu2005

namespace drape {
namespace {

bool is_rest(const ContactProblem& problem, const ContactPlane& contact) { return !is_impact(problem, contact); }

}  // namespace

ResponseReport respond_by_hybrid(ContactProblem& problem) {
    const Sweeps impacts = solve_impacts(problem), rest = solve_penalties(problem, is_rest);
    return {.residual = std::max(impacts.residual * problem.h, rest.residual), .sweeps = impacts.count + rest.count};
}

}  // namespace drape
