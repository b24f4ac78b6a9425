#pragma once

#include <algorithm>
#include <cmath>

#include "contact_motion.h"
#include "tuning.h"

namespace drape {

struct ContactRows;

/// All contacts that are solved together, and what is known of the substep.
struct ContactProblem {
    const ResponseParameters& parameters;
    Real h;        ///< the substep [s]
    Real share;    ///< of h, that a constant force displaces for, see `displacement_share`
    Real gravity;  ///< [m/s^2]
    Real resting;  ///< an approach slower than this is resting, and does not bounce [m/s]
    std::span<const ClothInContact> cloths;
    std::span<PairContact> pairs;
    std::span<Ball> balls;
    std::span<BallContact> ball_contacts;
    ContactRows* rows = nullptr;  ///< for solves over compact rows; none: by plain code
    bool with_bodies = true;      ///< contacts of cloths with balls and ground are solved too

    [[nodiscard]] Displacements displacements() const { return {cloths, balls}; }
    [[nodiscard]] Velocities velocities() const { return {cloths, balls}; }
};

/// Whether a contact takes part in a solve.
using IsActive = bool (*)(const ContactProblem&, const ContactPlane&);

/// Whether bodies meet faster than a few steps of gravity would make them; if not, they rest on each other.
inline bool is_impact(const ContactProblem& problem, const ContactPlane& contact) {
    return contact.approach > problem.resting;
}

/// Calls visit(contact) for all contacts, in the order in which they are solved.
template <class Visit>
void for_each_contact(ContactProblem& problem, Visit visit) {
    if (problem.with_bodies) {
        for (const ClothInContact& cloth : problem.cloths) {
            for (Contact& contact : cloth.contacts) visit(contact);
        }
    }
    for (PairContact& contact : problem.pairs) visit(contact);
    for (BallContact& contact : problem.ball_contacts) visit(contact);
}

/// Chooses the contacts that a solve is about.
template <class Chooses>
void choose(ContactProblem& problem, Chooses chooses) {
    for_each_contact(problem,
                     [&](ContactPlane& contact) { contact.active = contact.inverse_mass > 0 && chooses(contact); });
}

/// What friction is to give to a contact in all, to stop what is left of its sliding, within Coulomb's cone.
/// @param most it may give
inline Vec3 friction_within(const ContactPlane& contact, const ContactPush& accumulated, const Vec3& sliding,
                            Real most) {
    const Vec3 wanted = accumulated.friction - contact.sliding_mass * sliding;
    const Real square = wanted.squaredNorm();
    return square > most * most ? Vec3(most / std::sqrt(square) * wanted) : wanted;
}

/// Solves one contact for itself: its push along the normal grows by what its target lacks, n J >= 0, and friction
/// stops what slides, as far as |F| <= mu J lets it. @cite catto2005
/// @return the square of how much that changes its motion [m^2 or m^2/s^2]
template <class Motion, class AnyContact>
Real solve_contact(Motion& motion, AnyContact& contact) {
    if (!contact.active) return 0;
    ContactPush& accumulated = Motion::accumulated(contact);
    const Vec3 moves = relative(motion, contact);
    const Real along = moves.dot(contact.normal);
    const Real normal = std::max(accumulated.normal + (accumulated.target - along) * contact.mass, Real(0));
    const Vec3 friction =
        friction_within(contact, accumulated, moves - along * contact.normal, contact.friction_coefficient * normal);
    const Vec3 push = (normal - accumulated.normal) * contact.normal + (friction - accumulated.friction);
    if (push.isZero(0)) return 0;
    accumulated.normal = normal;
    accumulated.friction = friction;
    push_apart(motion, contact, push);
    return push.squaredNorm() * contact.inverse_mass * contact.inverse_mass;
}

/// The same where the push along the normal is fixed: friction alone.
template <class Motion, class AnyContact>
Real solve_friction(Motion& motion, AnyContact& contact) {
    ContactPush& accumulated = Motion::accumulated(contact);
    if (!contact.active || accumulated.normal == 0) return 0;
    const Vec3 moves = relative(motion, contact);
    const Vec3 sliding = moves - moves.dot(contact.normal) * contact.normal;
    const Vec3 friction =
        friction_within(contact, accumulated, sliding, contact.friction_coefficient * accumulated.normal);
    const Vec3 push = friction - accumulated.friction;
    accumulated.friction = friction;
    push_apart(motion, contact, push);
    return push.squaredNorm() * contact.inverse_mass * contact.inverse_mass;
}

/// What came of sweeps.
struct Sweeps {
    int count = 0;
    Real residual = 0;  ///< largest change of a contact's motion in the last one [m or m/s]
};

/// Sweeps over the contacts until none changes by more than the tolerance.
/// @param solve solve(contact) returns the square of its change
template <class Solve>
Sweeps sweep_until(ContactProblem& problem, Real tolerance, Solve solve) {
    Sweeps sweeps;
    Real square = 0;
    do {
        square = 0;
        for_each_contact(problem, [&](auto& contact) { square = std::max(square, solve(contact)); });
        ++sweeps.count;
    } while (square > tolerance * tolerance && sweeps.count < max_sweeps);
    sweeps.residual = std::sqrt(square);
    return sweeps;
}

/// Tolerances: of displacements, a small part of what gravity moves a particle by within a step or, if more, of the
/// thickness between cloths that touch, or the last digits of a metre; of velocities, what that is within a step, but
/// between cloths no more than what is seen as rest.
[[nodiscard]] Real displacement_tolerance(const ContactProblem& problem);
[[nodiscard]] Real velocity_tolerance(const ContactProblem& problem);

/// The responses, each in a file of its own.
[[nodiscard]] ResponseReport respond_by_projection(ContactProblem& problem);
[[nodiscard]] ResponseReport respond_by_impulses(ContactProblem& problem);
[[nodiscard]] ResponseReport respond_by_penalties(ContactProblem& problem);
[[nodiscard]] ResponseReport respond_by_hybrid(ContactProblem& problem);

/// Updates the point of a contact and its depth, less than zero where they have parted, to where the bodies are now;
/// the normal stays.
void follow(const ContactProblem& problem, Contact& contact);
void follow(const ContactProblem& problem, PairContact& contact);
void follow(const ContactProblem& problem, BallContact& contact);

/// Finds a contact of cloth with a ball again where they have moved: the point that is closest now, and its plane.
/// Others follow.
void find_again(const ContactProblem& problem, Contact& contact);
inline void find_again(const ContactProblem& problem, PairContact& contact) { follow(problem, contact); }
inline void find_again(const ContactProblem& problem, BallContact& contact) { follow(problem, contact); }

/// The restitution between the bodies of a contact; a cloth does not bounce off a cloth.
[[nodiscard]] Real restitution_of(const ResponseParameters& parameters, const BodyContact& contact);
[[nodiscard]] inline Real restitution_of(const ResponseParameters& /*parameters*/, const PairContact& /*contact*/) {
    return 0;
}

/// The largest depth that is left, at the points of the contacts where they are now [m].
[[nodiscard]] Real depth_left(ContactProblem& problem);

}  // namespace drape
