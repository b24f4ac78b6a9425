#include "problem.h"

#include <algorithm>

// The penalty-impulse hybrid: an impulse where two sides meet faster than gravity alone brings them together within a
// few steps, a penalty where they rest. @cite constantinescu2005 Where something comes deep into a ball, impulses
// alone.

namespace drape {
namespace {

bool has_deep_contact(const ContactProblem& problem) {
    bool any = false;
    for_each_row(problem, [&](const ContactRow& row, const RowState& state) {
        const bool of_surface = row.kind == RowKind::Particle || row.kind == RowKind::Triangle;
        if (!of_surface || !is_impact(problem, state) || !problem.body(row.body).is_ball()) return;
        any = any || row.depth > deep_part * problem.body(row.body).radius;
    });
    return any;
}

}  // namespace

ResponseReport respond_by_hybrid(ContactProblem& problem) {
    if (has_deep_contact(problem)) return respond_by_impulses(problem);
    const Sweeps impacts = solve_impacts(problem);
    choose(problem,
           [&](const ContactRow& row, const RowState& state) { return row.depth > 0 && !is_impact(problem, state); });
    const Sweeps rest = solve_penalties(problem);
    return {.residual = std::max(impacts.residual * problem.h, rest.residual), .sweeps = impacts.count + rest.count};
}

}  // namespace drape
