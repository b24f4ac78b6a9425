#pragma once

#include "contact_solver.h"
#include "drape/contact/contact_activity.h"

namespace drape {

/// Changes of less than this part of the tolerance do not make a sweep solve the contacts beside them again.
inline constexpr Real of_tolerance_neglected = Real(0.1);

/// As `sweep_until`, but most sweeps leave out the contacts whose bodies nothing has pushed since they were solved, for
/// they would not change. Where cloth lies on cloth that is nearly all of them after a few sweeps, while a few go on
/// for as long as they may. The first sweep and the last one are over all: that nothing changes any more by more than
/// the tolerance is seen of every contact, as without this.
template <class Solve>
Sweeps sweep_active(ContactProblem& problem, ContactActivity& activity, Real tolerance, Solve solve) {
    activity.begin(problem.cloths, problem.balls);
    for_each_contact(problem, [&](const auto& contact) { activity.add(contact); });
    const Real neglected = of_tolerance_neglected * tolerance;
    Sweeps sweeps;
    Real square = 0;
    bool all = true, converged = false;
    do {
        square = 0;
        auto next = activity.entries().begin();
        for_each_contact(problem, [&](auto& contact) {
            ContactActivity::Entry& entry = *next++;
            if (!all && !activity.is_pending(entry)) return;
            const Real change = solve(contact);
            square = std::max(square, change);
            activity.solved(entry, change > neglected * neglected);
        });
        ++sweeps.count;
        const bool calm = square <= tolerance * tolerance;
        converged = all && calm;
        all = calm || sweeps.count + 1 == most_sweeps;
    } while (!converged && sweeps.count < most_sweeps);
    sweeps.residual = std::sqrt(square);
    return sweeps;
}

}  // namespace drape
