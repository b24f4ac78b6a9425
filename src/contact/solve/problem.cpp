#include "problem.h"

#include <algorithm>

#include "drape/model/stencils.h"
#include "mobility.h"

namespace drape {
namespace {

/// A ball meets an impulse along the normal with its mass, and one across it with its inertia too: 1/m + r^2 / I = 7/2
/// / m.
constexpr Real sliding_share = Real(3.5);

/// Whether a structural spring at the particles of a contact was taut at the start of the substep: contact comes after
/// the limit, but leaves no more than it draws in cloth that can give way.
/// @param drawn by the motor within the substep [m]
bool is_taut_at(const ContactProblem& problem, const ContactRow& row, Real drawn) {
    return std::ranges::any_of(row.moved(), [&](const RowParticle& p) {
        const ClothInContact& cloth = problem.cloths[static_cast<std::size_t>(p.cloth)];
        const Real limit = cloth.model.stretch_limit;
        bool found = false;
        if (limit == 0) return found;
        for_each_spring_at(cloth.model, p.particle, [&](const SpringStencil& springs, int other) {
            const Real longest = (1 + limit + taut_stretch) * springs.rest_length + drawn;
            const Real square = (cloth.before.row(p.particle) - cloth.before.row(other)).squaredNorm();
            found = found || (springs.structural() && square > longest * longest);
        });
        return found;
    });
}

/// Where the particles of a contact were, and what an impulse meets.
void set_particles(const ContactProblem& problem, const ContactRow& row, RowState& state) {
    state.start.setZero();
    for (const RowParticle& p : row.moved()) {
        state.start += p.weight * position(problem.cloths[static_cast<std::size_t>(p.cloth)].before, p.particle);
    }
    const auto is_still = [](const Body& body) {
        return !body.gives_way() && body.moved.isZero(0) && body.turned.isZero(0) && body.velocity.isZero(0) &&
               body.spin.isZero(0);
    };
    state.stands = row.body == no_body || is_still(problem.body(row.body));
    const auto [mobilities, of_particles] = mobility_of(problem.cloths, row);
    state.mobilities = mobilities;
    Real of_bodies = 0;
    bool has_motor = false;
    Real drawn = 0;
    for (const int number : {row.first_body, row.body}) {
        if (number == no_body) continue;
        const Body& body = problem.body(number);
        of_bodies += body.inverse_mass;
        has_motor = has_motor || body.is_motor;
        if (body.is_motor) drawn += body.moved.norm();
    }
    const Real sliding = of_particles + sliding_share * of_bodies;
    state.inverse_mass = of_particles + of_bodies;
    state.stops = has_motor && (state.inverse_mass == 0 || (drawn > 0 && is_taut_at(problem, row, drawn)));
    state.mass = state.inverse_mass > 0 ? 1 / state.inverse_mass : Real(0);
    state.sliding_mass = sliding > 0 ? 1 / sliding : Real(0);
}

/// Takes the motion of all that is in contact.
void take_motion(ContactProblem& problem) {
    auto& [states, displacements, velocities] = problem.scratch;
    for (ContactMotion* motion : {&displacements, &velocities}) {
        motion->particles.clear();
        motion->bodies.clear();
    }
    for (const ClothInContact& cloth : problem.cloths) {
        displacements.particles.push_back(&cloth.state.x);
        velocities.particles.push_back(&cloth.state.v);
    }
    for (const Body& body : problem.bodies) {
        displacements.bodies.push_back({body.moved, body.turned});
        velocities.bodies.push_back({body.velocity, body.spin});
    }
}

/// Where a body is now.
Vec3 centre_of(const ContactProblem& problem, int body) {
    const Vec3& moved = problem.scratch.displacements.bodies[static_cast<std::size_t>(body)].linear;
    return problem.body(body).centre + (moved - problem.body(body).moved);
}

/// Whether a contact is no impact to the hybrid, though its bodies approach each other by more than gravity alone makes
/// them. Where a force displaces by half of its velocity, what lies still has the other half at the end of the substep:
/// it rests if it has hardly come nearer, or has pushed in the substep before, which only contacts of cloth know.
bool rests(const ContactProblem& problem, const ContactRow& row, const RowState& state) {
    if (problem.parameters.displacement_factor == 1) return false;
    const Real nearer = -relative(problem, problem.scratch.displacements, row, state).dot(row.normal);
    if (nearer <= problem.resting_speed() * problem.h) return true;
    return row.lasts && state.approach <= std::min(rest_steps * problem.gravity.norm() * problem.h, fastest_rest);
}

/// Fills what does not change while contacts are solved, but for masses.
void prepare(const ContactProblem& problem, ContactRow& row, RowState& state) {
    state.surface = {.friction = problem.parameters.friction};
    if (row.body != no_body) state.surface = problem.body(row.body).surface;
    for (RowImpulse* total : {&row.displacement, &row.impulse}) {
        total->friction -= total->friction.dot(row.normal) * row.normal;
    }
    state.approach = -relative(problem, problem.scratch.velocities, row, state).dot(row.normal);
    const bool by_hybrid = problem.parameters.kind == ResponseKind::Hybrid;
    if (by_hybrid && is_impact(problem, state) && rests(problem, row, state)) {
        state.approach = problem.resting_speed();  // so that it is no impact
    }
    const bool bounces = is_impact(problem, state);
    target_of(state, Quantity::Velocity) = bounces ? state.surface.restitution * state.approach : Real(0);
}

}  // namespace

/// Flat, because GCC would call a function for each sum of three numbers.
__attribute__((flatten)) void prepare(ContactProblem& problem) {
    problem.scratch.states.assign(problem.rows.size(), {});
    take_motion(problem);
    for (std::size_t r = 0; r < problem.rows.size(); ++r) {
        ContactRow& row = problem.rows[r];
        RowState& state = problem.state(r);
        set_particles(problem, row, state);
        follow(problem, row);
        prepare(problem, row, state);
    }
}

void finish(ContactProblem& problem) {
    const auto& [states, displacements, velocities] = problem.scratch;
    for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
        Body& body = problem.bodies[b];
        if (!body.gives_way()) continue;
        body.centre = centre_of(problem, static_cast<int>(b));
        body.moved = displacements.bodies[b].linear;
        body.turned = displacements.bodies[b].angular;
        body.velocity = velocities.bodies[b].linear;
        body.spin = velocities.bodies[b].angular;
    }
}

void follow(const ContactProblem& problem, ContactRow& row) {
    Vec3 offset = Vec3::Zero();
    for (const RowParticle& p : row.moved()) offset += p.weight * problem.scratch.displacements.of(p);
    if (row.first_body != no_body) offset += centre_of(problem, row.first_body);
    if (row.body != no_body) offset -= centre_of(problem, row.body);
    row.depth = row.distance - row.normal.dot(offset);
}

void find_again(const ContactProblem& problem, ContactRow& row, RowState& state) {
    const bool of_surface = row.kind == RowKind::Particle || row.kind == RowKind::Triangle;
    if (of_surface && !row.separated && problem.body(row.body).is_ball()) {
        const ContactMotion& x = problem.scratch.displacements;
        const Vec3 centre = centre_of(problem, row.body);
        ClosestPoint at{x.of(row.particles[0]), {1, 0, 0}};
        if (row.kind == RowKind::Triangle) {
            at = closest_point_on_triangle(centre, at.point, x.of(row.particles[1]), x.of(row.particles[2]));
        }
        const Vec3 offset = at.point - centre;
        const Real distance = offset.norm();
        if (offset.dot(row.normal) > same_side * distance) {
            for (std::size_t k = 0; k < row.count; ++k) row.particles[k].weight = at.barycentric[k];
            row.normal = offset / distance;
            set_particles(problem, row, state);
            row.displacement.friction -= row.displacement.friction.dot(row.normal) * row.normal;
        }
    }
    follow(problem, row);
}

}  // namespace drape
