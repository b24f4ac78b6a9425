#include "problem.h"

#include <limits>

namespace drape {
namespace {

/// What friction is to give to a contact in all, to stop what is left of its sliding, within Coulomb's cone.
/// @param most it may give
Vec3 friction_within(const RowState& state, const RowImpulse& total, const Vec3& sliding, Real most) {
    const Vec3 wanted = total.friction - state.sliding_mass * sliding;
    const Real square = wanted.squaredNorm();
    return square > most * most ? Vec3(most / std::sqrt(square) * wanted) : wanted;
}

/// Gives a contact an impulse in place of what it was given before.
/// @return the square of how much that changes its motion [m^2 or m^2/s^2]
Real give(const ContactProblem& problem, ContactMotion& motion, ContactRow& row, const RowState& state,
          const RowImpulse& wanted) {
    RowImpulse& total = accumulated(row, motion.quantity);
    const Vec3 change = (wanted.normal - total.normal) * row.normal + (wanted.friction - total.friction);
    if (change.isZero(0)) return 0;
    total = wanted;
    apply_impulse(problem, motion, row, state, change);
    return change.squaredNorm() * state.inverse_mass * state.inverse_mass;
}

/// Solves one contact for itself: its impulse along the normal grows by what its target lacks, n J >= 0, and friction
/// stops what slides, as far as |F| <= mu J lets it. @cite catto2005
Real solve_row(const ContactProblem& problem, ContactMotion& motion, ContactRow& row, RowState& state) {
    const RowImpulse& total = accumulated(row, motion.quantity);
    const Vec3 moves = relative(problem, motion, row, state);
    const Real along = moves.dot(row.normal), lacks = target_of(state, motion.quantity) - along;
    const Real normal = std::max(total.normal + lacks * state.mass, Real(0));
    const Vec3 sliding = moves - along * row.normal;
    return give(problem, motion, row, state,
                {normal, friction_within(state, total, sliding, state.surface.friction * normal)});
}

Real solve_friction_of(const ContactProblem& problem, ContactMotion& motion, ContactRow& row, const RowState& state) {
    const RowImpulse& total = accumulated(row, motion.quantity);
    if (total.normal == 0) return 0;
    const Vec3 moves = relative(problem, motion, row, state);
    const Vec3 sliding = moves - moves.dot(row.normal) * row.normal;
    return give(problem, motion, row, state,
                {total.normal, friction_within(state, total, sliding, state.surface.friction * total.normal)});
}

Real tolerance_of(const ContactProblem& problem, const ContactMotion& motion) {
    const bool moves = motion.quantity == Quantity::Displacement;
    Real of_pairs = thickness_tolerance * problem.parameters.pair_thickness;
    if (!moves) of_pairs = std::min(of_pairs, pair_velocity_tolerance * problem.h);
    bool has_pairs = false;
    for_each_row(problem,
                 [&](const ContactRow& row, const RowState&) { has_pairs = has_pairs || row.kind == RowKind::Pair; });
    const Real fall = problem.gravity.norm() * problem.h * problem.h;
    const Real within_step =
        std::max({gravity_tolerance * fall, has_pairs ? of_pairs : Real(0), 4 * std::numeric_limits<Real>::epsilon()});
    return moves ? within_step : within_step / problem.h;
}

/// Calls solve_one(row, state) for the chosen contacts, again and again.
template <class SolveOne>
Sweeps sweep_rows(ContactProblem& problem, const ContactMotion& motion, SolveOne solve_one) {
    return sweep_until(tolerance_of(problem, motion), [&] {
        Real square = 0;
        for_each_chosen(problem,
                        [&](ContactRow& row, RowState& state) { square = std::max(square, solve_one(row, state)); });
        return square;
    });
}

}  // namespace

Sweeps solve(ContactProblem& problem, ContactMotion& motion) {
    if (!problem.scratch.order.empty()) return solve_compact(problem, motion, tolerance_of(problem, motion));
    // Flat, because GCC would call a function for each sum of three numbers
    return sweep_rows(
        problem, motion, [&](ContactRow & row, RowState & state) __attribute__((flatten)) {
            return solve_row(problem, motion, row, state);
        });
}

Sweeps solve_friction(ContactProblem& problem, ContactMotion& motion) {
    return sweep_rows(problem, motion,
                      [&](ContactRow& row, RowState& state) { return solve_friction_of(problem, motion, row, state); });
}

}  // namespace drape
