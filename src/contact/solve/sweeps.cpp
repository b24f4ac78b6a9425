#include "problem.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drape {
namespace {

/// Stops a motor at what is stronger. A body that cannot be moved carries it along; taut cloth only stops it. It comes
/// no deeper into what it is in already, and may leave.
/// @param wedged it stays where it was if it was led into this, which fits everything that stands still
/// @return how far it is taken back [m]
Real stop_motor(const ContactProblem& problem, const ContactRow& row, RowState& state, bool wedged) {
    ContactMotion &displacements = problem.scratch.displacements, &velocities = problem.scratch.velocities;
    const Real along = relative(problem, displacements, row, state).dot(row.normal);
    const Real lacks = target_of(state, Quantity::Displacement) - along;
    if (!(lacks > 0)) return 0;
    const bool is_first = row.first_body != no_body && problem.body(row.first_body).is_motor;
    const auto number = static_cast<std::size_t>(is_first ? row.first_body : row.body);
    Vec3 &moved = displacements.bodies[number].linear, &velocity = velocities.bodies[number].linear;
    const Vec3 towards = is_first ? Vec3(-row.normal) : row.normal;
    const bool by_taut = state.inverse_mass > 0;
    const Real approach = by_taut ? towards.dot(moved) : -along;
    const Real speed = by_taut ? towards.dot(velocity) : -relative(problem, velocities, row, state).dot(row.normal);
    const Real back = std::min(lacks, std::max(approach, Real(0)));
    if (wedged && back > touch_distance) {
        if (towards.dot(problem.bodies[number].moved) > touch_distance) moved.setZero(), velocity.setZero();
        return 0;
    }
    moved -= back * towards;
    velocity -= std::max(speed, Real(0)) * towards;
    return back;
}

/// Solves one contact for itself: its impulse along the normal grows by what its target lacks, n J >= 0, and friction
/// stops what slides, as far as |F| <= mu J lets it. @cite catto2005
/// @return the square of how much that changes its motion [m^2 or m^2/s^2]
Real solve_row(const ContactProblem& problem, ContactMotion& motion, bool friction_alone, ContactRow& row,
               RowState& state) {
    RowImpulse& total = motion.quantity == Quantity::Displacement ? row.displacement : row.impulse;
    if (friction_alone && total.normal == 0) return 0;
    const Vec3 moves = relative(problem, motion, row, state);
    const Real along = moves.dot(row.normal), lacks = target_of(state, motion.quantity) - along;
    const Real normal = friction_alone ? total.normal : std::max(total.normal + lacks * state.mass, Real(0));
    // Most contacts that carry nothing go on so, and need no root
    if (normal == 0 && total.normal == 0 && total.friction.isZero(0)) return 0;

    const Real most = state.surface.friction * normal;
    Vec3 friction = total.friction - state.sliding_mass * (moves - along * row.normal);
    const Real square = friction.squaredNorm();
    if (square > most * most) friction *= most / std::sqrt(square);
    const Vec3 change = (normal - total.normal) * row.normal + (friction - total.friction);
    if (change.isZero(0)) return 0;
    total = {normal, friction};
    apply_impulse(problem, motion, row, state, change);
    return change.squaredNorm() * state.inverse_mass * state.inverse_mass;
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

}  // namespace

/// Flat, because GCC would call a function for each sum of three numbers.
__attribute__((flatten)) Sweeps solve(ContactProblem& problem, ContactMotion& motion, bool friction_alone) {
    const Real tolerance = tolerance_of(problem, motion);
    const bool displaces = motion.quantity == Quantity::Displacement;
    Sweeps sweeps;
    Real square = 0;  // of the largest change
    do {
        square = 0;
        for_each_chosen(problem, [&](ContactRow& row, RowState& state) {
            if (state.stops && displaces && sweeps.count <= max_motor_sweeps) {
                const Real taken = stop_motor(problem, row, state, sweeps.count == max_motor_sweeps);
                square = std::max(square, taken * taken);
            }
            square = std::max(square, solve_row(problem, motion, friction_alone, row, state));
        });
        ++sweeps.count;
    } while (square > tolerance * tolerance && sweeps.count < max_sweeps);
    sweeps.residual = std::sqrt(square);
    return sweeps;
}

}  // namespace drape
