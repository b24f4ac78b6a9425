#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <vector>

#include "contact/tuning.h"
#include "drape/contact/closest_point.h"
#include "drape/contact/response.h"

namespace drape {

/// What is known of a contact while it is answered.
struct RowState {
    std::array<Real, 4> mobilities{};  ///< of an impulse, that they move by: weight times inverse mass [1/kg]
    Vec3 start = Vec3::Zero();         ///< weighted sum of where they were at the start of the substep [m]
    Real inverse_mass = 0;  ///< that an impulse along the normal meets, of both sides; 0 if none moves [1/kg]
    Real mass = 0;          ///< 1 / inverse_mass, or 0 [kg]
    Real sliding_mass = 0;  ///< the same across the normal [kg]
    Surface surface;
    Real approach = 0;              ///< speed at which they meet, less than zero where they part [m/s]
    Real remaining = 0;             ///< of the substep, after the impact [s]
    std::array<Real, 2> targets{};  ///< least motion along the normal, of displacements and velocities [m, m/s]
    bool stands = false;            ///< its second side, or there is none: it has no motion, and takes none
    bool stops = false;             ///< a motor, because its other side is taut, or nothing moves it
    bool included = true;           ///< in the response under way
    bool active = false;            ///< in the solve under way

    [[nodiscard]] bool can_move() const { return inverse_mass > 0 || stops; }
};

/// What contacts change: displacements within the substep, or velocities.
enum class Quantity { Displacement, Velocity };

/// One of both, of all that takes part.
struct ContactMotion {
    /// Of a body, and how fast it turns.
    struct OfBody {
        Vec3 linear, angular;
    };

    Quantity quantity;
    std::vector<Points*> particles;  ///< of each cloth: its positions at the end of the substep, or velocities
    std::vector<OfBody> bodies;

    [[nodiscard]] auto of(const RowParticle& p) const {
        return particles[static_cast<std::size_t>(p.cloth)]->row(p.particle).transpose();
    }
};

/// What a solver keeps from one substep to the next, to allocate nothing.
struct ContactSolver::Scratch {
    std::vector<RowState> states;  ///< of each row
    ContactMotion displacements{Quantity::Displacement, {}, {}}, velocities{Quantity::Velocity, {}, {}};
};

/// All contacts that are solved together, and what is known of the substep.
struct ContactProblem {
    const ResponseParameters& parameters;
    Real h;        ///< the substep [s]
    Vec3 gravity;  ///< [m/s^2]
    std::span<const ClothInContact> cloths;
    std::span<Body> bodies;
    std::span<ContactRow> rows;
    ContactSolver::Scratch& scratch;

    [[nodiscard]] RowState& state(std::size_t row) const { return scratch.states[row]; }
    [[nodiscard]] Body& body(int number) const { return bodies[static_cast<std::size_t>(number)]; }

    /// An approach slower than this is resting, and does not bounce [m/s].
    [[nodiscard]] Real resting_speed() const { return resting_steps * h * gravity.norm(); }
};

/// Calls visit(row, state) for all contacts of the response under way, in the order in which they are solved.
template <class Visit>
void for_each_row(const ContactProblem& problem, Visit visit) {
    for (std::size_t r = 0; r < problem.rows.size(); ++r) {
        if (problem.state(r).included) visit(problem.rows[r], problem.state(r));
    }
}

inline Real& target_of(RowState& state, Quantity quantity) { return state.targets[static_cast<std::size_t>(quantity)]; }

/// Whether bodies meet faster than a few steps of gravity would make them; if not, they rest on each other.
inline bool is_impact(const ContactProblem& problem, const RowState& state) {
    return state.approach > problem.resting_speed();
}

/// How a body moves where a contact touches it.
/// @param outwards out of the body
inline Vec3 motion_of_body(const ContactProblem& problem, const ContactMotion& motion, int body, const Vec3& outwards) {
    const auto& [linear, angular] = motion.bodies[static_cast<std::size_t>(body)];
    return linear + angular.cross(problem.body(body).arm(outwards));
}

/// How the first side of a contact moves against the second.
inline Vec3 relative(const ContactProblem& problem, const ContactMotion& motion, const ContactRow& row,
                     const RowState& state) {
    Vec3 sum = Vec3::Zero();
    for (const RowParticle& p : row.moved()) sum += p.weight * motion.of(p);
    if (motion.quantity == Quantity::Displacement) sum -= state.start;
    if (row.first_body != no_body) sum += motion_of_body(problem, motion, row.first_body, -row.normal);
    if (!state.stands) sum -= motion_of_body(problem, motion, row.body, row.normal);
    return sum;
}

/// Gives an impulse to the first side of a contact, and the opposite one to the second.
inline void apply_impulse(const ContactProblem& problem, ContactMotion& motion, const ContactRow& row,
                          const RowState& state, const Vec3& impulse) {
    const auto push_body = [&](int number, const Vec3& outwards, const Vec3& push) {
        if (number == no_body || problem.body(number).inverse_mass == 0) return;
        const Body& body = problem.body(number);
        auto& [linear, angular] = motion.bodies[static_cast<std::size_t>(number)];
        linear += body.inverse_mass * push;
        angular += body.inverse_inertia() * body.arm(outwards).cross(push);
    };
    for (std::size_t k = 0; k < row.count; ++k) motion.of(row.particles[k]) += state.mobilities[k] * impulse;
    push_body(row.first_body, -row.normal, impulse);
    if (!state.stands) push_body(row.body, row.normal, -impulse);
}

/// Fills what is known of each row, and takes the motion of all that is in contact.
void prepare(ContactProblem& problem);

/// Gives bodies the motion that the response has left.
void finish(ContactProblem& problem);

/// Updates the depth of a contact, less than zero where it has parted, to where all is now; the normal stays.
void follow(const ContactProblem& problem, ContactRow& row);

/// Finds a contact of cloth with a ball again where they have moved: the point that is closest now, and its plane, if
/// it is on the side where they met. Others follow.
void find_again(const ContactProblem& problem, ContactRow& row, RowState& state);

/// What came of sweeps.
struct Sweeps {
    int count = 0;
    Real residual = 0;  ///< largest change of a contact's motion in the last one [m or m/s]

    Sweeps operator+(const Sweeps& other) const { return {count + other.count, std::max(residual, other.residual)}; }
};

/// Chooses the contacts that a solve is about, of those in the response under way.
/// @param chooses chooses(row, state)
template <class Chooses>
void choose(ContactProblem& problem, Chooses chooses) {
    for_each_row(problem, [&](const ContactRow& row, RowState& state) {
        state.active = state.can_move() && chooses(row, state);
    });
}

/// Calls visit(row, state) for these.
template <class Visit>
void for_each_chosen(const ContactProblem& problem, Visit visit) {
    for_each_row(problem, [&](ContactRow& row, RowState& state) {
        if (state.active) visit(row, state);
    });
}

/// Solves the chosen contacts one after the other, again and again, until none changes by more than a tolerance: of
/// displacements, a small part of what gravity moves a particle by within a step or, if more, of the thickness between
/// cloths that touch, or the last digits of a metre; of velocities, what that is within a step, but between cloths no
/// more than what is seen as rest.
/// @param friction_alone impulses along the normals stay as they are
[[nodiscard]] Sweeps solve(ContactProblem& problem, ContactMotion& motion, bool friction_alone = false);

// What the responses are made of, each in a file of its own. Residuals are in displacements [m].

/// Puts all contacts back onto their planes.
[[nodiscard]] Sweeps respond_by_projection(ContactProblem& problem);

/// Gives impulses to the contacts that are impacts.
[[nodiscard]] Sweeps respond_by_impulses(ContactProblem& problem);

/// Pushes by springs and dampers at the chosen contacts, which have entered.
[[nodiscard]] Sweeps respond_by_penalties(ContactProblem& problem);

}  // namespace drape
