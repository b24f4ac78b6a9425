#include "drape/contact/response.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact_solver.h"
#include "drape/contact/contact_rows.h"
#include "resting.h"
#include "tuning.h"

namespace drape {
namespace {

const Ball& ball_of(const BodyContact& contact, std::span<const Ball> balls) {
    return balls[static_cast<std::size_t>(contact.ball)];
}

/// A ball meets a push along the normal with its mass, and one across it with its inertia too: 1/m + r^2 / I = 7/2 / m.
constexpr Real sliding_share = Real(3.5);

Real inverse_mass_of(int number, std::span<const Ball> balls) {
    return is_plane(number) ? Real(0) : balls[static_cast<std::size_t>(number)].inverse_mass;
}

/// The weighted sum of where its particles were at the start of the substep.
Vec3 start_of(const ContactProblem& problem, const ContactPlane& contact) {
    return weighted_sum(
        contact, [&](int cloth) -> const Points& { return problem.cloths[static_cast<std::size_t>(cloth)].before; });
}

/// @param inverse, sliding inverse masses of both bodies together, along the normal and across it
void set_masses(Real inverse, Real sliding, ContactPlane& contact) {
    contact.inverse_mass = inverse;
    contact.mass = inverse > 0 ? 1 / inverse : Real(0);
    contact.sliding_mass = sliding > 0 ? 1 / sliding : Real(0);
}

/// Where the particles of a contact were, and what a push meets.
void set_particles(const ContactProblem& problem, Contact& contact) {
    list_particles(problem.cloths, contact);
    contact.start = start_of(problem, contact);
    const Real first = inverse_mass_of_particles(contact), second = inverse_mass_of(contact.ball, problem.balls);
    set_masses(first + second, first + sliding_share * second, contact);
}
void set_particles(const ContactProblem& problem, PairContact& contact) {
    list_particles(problem.cloths, contact);
    contact.start = start_of(problem, contact);
    const Real inverse_mass = inverse_mass_of_particles(contact);
    set_masses(inverse_mass, inverse_mass, contact);
}

Real friction_of(const ResponseParameters& parameters, const BodyContact& contact) {
    return contact.ball == the_ground ? parameters.ground.friction : parameters.friction;
}
Real friction_of(const ResponseParameters& parameters, const PairContact& /*contact*/) { return parameters.friction; }

/// Whether a contact is no impact to the hybrid, though its bodies approach each other by more than gravity alone makes
/// them. Where a force displaces by half of its velocity, what lies still has the other half at the end of the substep:
/// it rests if it has hardly come nearer, or has pushed in the substep before, which only contacts of cloth know.
template <class AnyContact>
bool rests(const ContactProblem& problem, const AnyContact& contact) {
    if (problem.share == 1) return false;
    const Real nearer = -relative(problem.displacements(), contact).dot(contact.normal);
    if (nearer <= problem.resting * problem.h) return true;
    return contact.lasts && contact.approach <= std::min(rest_steps * problem.gravity * problem.h, fastest_rest);
}

/// Fills what does not change while contacts are solved, but for masses.
template <class AnyContact>
void prepare(ContactProblem& problem, AnyContact& contact) {
    contact.friction_coefficient = friction_of(problem.parameters, contact);
    for (ContactPush* given : {&contact.displacement, &contact.impulse}) {
        given->friction -= given->friction.dot(contact.normal) * contact.normal;
    }
    contact.impulse.target = 0;
    contact.approach = -relative(problem.velocities(), contact).dot(contact.normal);
    if (problem.parameters.kind == ResponseKind::Hybrid && is_impact(problem, contact) && rests(problem, contact)) {
        contact.approach = problem.resting;  // so that it is no impact
    }
    if (is_impact(problem, contact)) {
        contact.impulse.target = restitution_of(problem.parameters, contact) * contact.approach;
    }
}

const ClothInContact& cloth_of(const ContactProblem& problem, const Contact& contact) {
    return problem.cloths[static_cast<std::size_t>(contact.cloth)];
}

/// Flat, because GCC would call a function for each sum of three numbers.
__attribute__((flatten)) void prepare_all(ContactProblem& problem) {
    for (std::size_t c = 0; c < problem.cloths.size(); ++c) {
        const ClothInContact& cloth = problem.cloths[c];
        for (Contact& contact : cloth.contacts) {
            contact.cloth = static_cast<int>(c);
            set_particles(problem, contact);
            follow(problem, contact);
            prepare(problem, contact);
        }
    }
    for (PairContact& contact : problem.pairs) {
        set_particles(problem, contact);
        follow(problem, contact);
        prepare(problem, contact);
    }
    for (BallContact& contact : problem.ball_contacts) {
        const Real inverse_mass =
            inverse_mass_of(contact.first, problem.balls) + inverse_mass_of(contact.ball, problem.balls);
        set_masses(inverse_mass, sliding_share * inverse_mass, contact);
        prepare(problem, contact);
    }
}

/// Of displacements within the substep.
/// @param of_pairs that between cloths [m]
Real tolerance_of(const ContactProblem& problem, Real of_pairs) {
    const Real fall = problem.gravity * problem.h * problem.h;
    return std::max({gravity_tolerance * fall, problem.pairs.empty() ? Real(0) : of_pairs,
                     4 * std::numeric_limits<Real>::epsilon()});
}

ResponseReport respond_in_kind(ContactProblem& problem) {
    switch (problem.parameters.kind) {
        case ResponseKind::Projection:
            return respond_by_projection(problem);
        case ResponseKind::Penalty:
            return respond_by_penalties(problem);
        case ResponseKind::Impulse:
            return respond_by_impulses(problem);
        case ResponseKind::Hybrid:
            return respond_by_hybrid(problem);
    }
    return {};
}

/// Pairs are always answered by projection: penalties of many pairs at one particle would add up, and an impulse is for
/// what meets, not for what is to keep apart.
ResponseReport respond(ContactProblem& problem) {
    if (problem.parameters.kind == ResponseKind::Projection || problem.pairs.empty()) return respond_in_kind(problem);
    const auto pairs = std::exchange(problem.pairs, {});
    ResponseReport report = respond_in_kind(problem);
    problem.pairs = pairs;
    for (PairContact& contact : pairs) follow(problem, contact);
    ContactProblem of_pairs = problem;
    of_pairs.with_bodies = false;
    of_pairs.ball_contacts = {};
    const ResponseReport more = respond_by_projection(of_pairs);
    report.sweeps += more.sweeps;
    report.residual = std::max(report.residual, more.residual);
    return report;
}

}  // namespace

void follow(const ContactProblem& problem, Contact& contact) {
    contact.point = at_point(contact, cloth_of(problem, contact).state.x);
    contact.depth = depth_now(problem.parameters, problem.balls, contact);
}

void find_again(const ContactProblem& problem, Contact& contact) {
    if (is_plane(contact.ball) || contact.separated) return follow(problem, contact);
    const Ball& ball = ball_of(contact, problem.balls);
    find_closest(cloth_of(problem, contact).state.x, ball, problem.parameters.thickness, contact);
    set_particles(problem, contact);
    contact.displacement.friction -= contact.displacement.friction.dot(contact.normal) * contact.normal;
}

void follow(const ContactProblem& problem, PairContact& contact) {
    const Vec3 offset = contact.start + relative(problem.displacements(), contact);
    contact.depth = problem.parameters.pair_thickness - offset.dot(contact.normal);
}

void follow(const ContactProblem& problem, BallContact& contact) {
    contact.depth = depth_now(problem.balls, problem.parameters.ground, contact);
}

double work_of_kinematic_bodies(std::span<const Contact> contacts, std::span<const Ball> balls) {
    Real work = 0;
    for (const Contact& contact : contacts) {
        if (contact.ball == the_ground || inverse_mass_of(contact.ball, balls) > 0) continue;
        const Vec3 impulse = contact.impulse.normal * contact.normal + contact.impulse.friction;
        work += impulse.dot(is_solid(contact.ball) ? contact.plane.velocity : ball_of(contact, balls).velocity);
    }
    return static_cast<double>(work);
}

double kinetic_energy(std::span<const Ball> balls) {
    Real sum = 0;
    for (const Ball& ball : balls) {
        if (ball.inverse_mass == 0) continue;
        sum += ball.velocity.squaredNorm() / ball.inverse_mass + ball.spin.squaredNorm() / ball.inverse_inertia();
    }
    return static_cast<double>(sum / 2);
}

Real push_of(const PairContact& contact, std::span<const Ball> /*balls*/) { return contact.depth - max_slop; }

Real push_of(const BodyContact& contact, std::span<const Ball> balls) {
    if (is_plane(contact.ball)) return contact.depth - max_slop;
    return contact.depth - slop_in(ball_of(contact, balls));
}

Real push_of(const BallContact& contact, std::span<const Ball> balls) {
    const BodyContact& second = contact;
    const Real radius = balls[static_cast<std::size_t>(contact.first)].radius;
    return std::max(push_of(second, balls), contact.depth - ball_slop_of_radius * radius);
}

Real restitution_of(const ResponseParameters& parameters, const BodyContact& contact) {
    return contact.ball == the_ground ? parameters.ground.restitution : parameters.restitution;
}

Real displacement_tolerance(const ContactProblem& problem) {
    return tolerance_of(problem, thickness_tolerance * problem.parameters.pair_thickness);
}

Real velocity_tolerance(const ContactProblem& problem) {
    const Real of_pairs =
        std::min(thickness_tolerance * problem.parameters.pair_thickness, pair_velocity_tolerance * problem.h);
    return tolerance_of(problem, of_pairs) / problem.h;
}

__attribute__((flatten)) Real depth_left(const ResponseParameters& parameters, std::span<const ClothInContact> cloths,
                                         std::span<const Ball> balls) {
    Real deepest = 0;
    for (const ClothInContact& cloth : cloths) {
        for (Contact& contact : cloth.contacts) {
            contact.point = at_point(contact, cloth.state.x);
            contact.depth = depth_now(parameters, balls, contact);
            deepest = std::max(deepest, contact.depth);
        }
    }
    return deepest;
}

Real depth_left(ContactProblem& problem) {
    Real deepest = depth_left(problem.parameters, problem.cloths, problem.balls);
    for (PairContact& contact : problem.pairs) follow(problem, contact);
    for (BallContact& contact : problem.ball_contacts) {
        follow(problem, contact);
        deepest = std::max(deepest, contact.depth);
    }
    return deepest;
}

ResponseReport resolve_contacts(const ResponseParameters& parameters, Real h, std::span<const ClothInContact> cloths,
                                std::span<PairContact> pairs, std::span<Ball> balls,
                                std::span<BallContact> ball_contacts, ContactRows* rows) {
    const bool none = std::ranges::all_of(cloths, [](const ClothInContact& cloth) { return cloth.contacts.empty(); });
    if (none && pairs.empty() && ball_contacts.empty()) return {};
    const Real gravity = cloths.front().model.gravity.norm();
    ContactProblem problem{.parameters = parameters,
                           .h = h,
                           .share = parameters.displacement_share,
                           .gravity = gravity,
                           .resting = resting_steps * h * gravity,
                           .cloths = cloths,
                           .pairs = pairs,
                           .balls = balls,
                           .ball_contacts = ball_contacts,
                           .rows = rows};
    prepare_all(problem);
    const double before = kinetic_energy(balls);
    ResponseReport report = respond(problem);
    report.free_ball_work = before - kinetic_energy(balls);
    report.depth = depth_left(problem);
    return report;
}

}  // namespace drape
