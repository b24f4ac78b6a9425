#include "drape/contact/response.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact_geometry.h"

namespace drape {
namespace {

/// Depth that is left, as a fraction of the radius: a resting contact then lasts from step to step instead of
/// flickering.
constexpr Real slop = Real(1e-4);

/// A push shorter than this fraction of the radius leaves a triangle's closest point where it is in the triangle.
constexpr Real short_push = Real(1e-3);

/// A push shorter than this fraction of the radius is not worth another sweep.
constexpr Real tolerance = Real(1e-6);

/// Sweeps over the contacts. Positions stop earlier once no contact had to be corrected.
constexpr int position_sweeps = 6;
constexpr int velocity_sweeps = 3;

/// An approach slower than this many steps of gravity is resting, and does not bounce.
constexpr Real resting_steps = 4;

const Ball& ball_of(const Contact& contact, std::span<const Ball> balls) {
    return balls[static_cast<std::size_t>(contact.ball)];
}

/// What a push at the contact point meets: 1/m = sum w_k^2 / m_k over its corners. Zero if nothing can move.
Real inverse_mass_at(const ClothModel& model, const Contact& contact) {
    Real sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        sum += contact.barycentric[k] * contact.barycentric[k] * model.inverse_mass[contact.corners[k]];
    }
    return sum;
}

/// Moves (or speeds up) a contact's corners, each by its share w_k / m_k of an impulse that acts at the contact point.
void push(const ClothModel& model, const Contact& contact, const Vec3& impulse, Points& p) {
    for (std::size_t k = 0; k < 3; ++k) {
        const int corner = contact.corners[k];
        p.row(corner) += contact.barycentric[k] * model.inverse_mass[corner] * impulse.transpose();
    }
}

/// The depth after short pushes: the same point of the triangle, where the particles are now. The distance to the
/// centre is stationary there, so what is left out is of second order.
void follow(const Points& x, const Ball& ball, Real thickness, Contact& contact) {
    contact.point = at_point(contact, x);
    const Real distance = (contact.point + contact.offset - ball.centre).norm();
    contact.depth = std::max(ball.radius + thickness + contact.radius - distance, Real(0));
}

/// Pushes one contact out to its slop, x_k += w_k / m_k (depth - slop) m n.
/// @return how far, 0 if it is out or nothing can move
Real push_out(const ClothModel& model, Real radius, const Contact& contact, Points& x) {
    const Real distance = push_of(contact, radius);
    const Real inverse_mass = distance > tolerance * radius ? inverse_mass_at(model, contact) : Real(0);
    if (inverse_mass == 0) return 0;
    push(model, contact, distance / inverse_mass * contact.normal, x);
    return distance;
}

/// How far particles have been moved since the contacts were found.
enum class Moved { Not, Little, Far };

/// Finds a contact again where particles may have moved.
void refresh(const Points& x, const Ball& ball, Real thickness, Moved moved, Contact& contact) {
    if (moved == Moved::Far) locate(x, ball, thickness, contact);
    if (moved == Moved::Little) follow(x, ball, thickness, contact);
}

/// One sweep of push_out: each contact sees the particles that its neighbours have moved.
/// @return whether any contact had to be corrected
bool push_all_out(const ClothModel& model, Real thickness, std::span<const Ball> balls, Moved& moved,
                  std::vector<Contact>& contacts, Points& x) {
    bool corrected = false;
    for (Contact& contact : contacts) {
        const Ball& ball = ball_of(contact, balls);
        refresh(x, ball, thickness, moved, contact);
        const Real distance = push_out(model, ball.radius, contact, x);
        corrected = corrected || distance > 0;
        if (distance > 0) moved = std::max(moved, Moved::Little);
        if (distance > short_push * ball.radius) moved = Moved::Far;
    }
    return corrected;
}

/// Pushes all contacts out, and finds them where they are then.
void separate(const ClothModel& model, Real thickness, std::span<const Ball> balls, std::vector<Contact>& contacts,
              Points& x) {
    Moved moved = Moved::Not;
    for (int sweep = 0; sweep < position_sweeps; ++sweep) {
        if (!push_all_out(model, thickness, balls, moved, contacts, x)) break;
    }
    for (Contact& contact : contacts) refresh(x, ball_of(contact, balls), thickness, moved, contact);
}

/// The speed along the normal at which one contact is to leave: that of the ball, and of a fast approach as much as the
/// restitution returns.
void aim(const ClothModel& model, Real restitution, const Vec3& ball_velocity, Real resting, const Points& v,
         Contact& contact) {
    const Real ball_speed = ball_velocity.dot(contact.normal);
    const Real approach = ball_speed - at_point(contact, v).dot(contact.normal);
    contact.inverse_mass = inverse_mass_at(model, contact);
    contact.impulse = 0;
    contact.leaving_speed = ball_speed + (approach > resting ? restitution * approach : Real(0));
}

/// Stops one contact's approach, or throws it back: its impulse J grows by m (leaving speed - n.v), downward too where
/// its neighbours have pushed already, and never pulls, J >= 0 (projected Gauss-Seidel).
void stop_approach(const ClothModel& model, Contact& contact, Points& v) {
    if (contact.inverse_mass == 0) return;
    const Real missing = contact.leaving_speed - at_point(contact, v).dot(contact.normal);
    const Real impulse = std::max(contact.impulse + missing / contact.inverse_mass, Real(0));
    if (impulse == contact.impulse) return;
    push(model, contact, (impulse - contact.impulse) * contact.normal, v);
    contact.impulse = impulse;
}

/// Coulomb friction: slows the sliding of one contact by an impulse of at most the coefficient times the normal one.
/// @return what the ball's motion gives the cloth through normal and sliding impulses [J]
double slow_sliding(const ClothModel& model, Real friction, const Vec3& ball_velocity, const Contact& contact,
                    Points& v) {
    if (contact.impulse <= 0) return 0;
    const auto work = static_cast<double>(contact.impulse * contact.normal.dot(ball_velocity));
    const Vec3 relative = at_point(contact, v) - ball_velocity;
    const Vec3 sliding = relative - relative.dot(contact.normal) * contact.normal;
    const Real speed = sliding.norm();
    if (speed == 0) return work;
    const Real impulse = std::min(speed / contact.inverse_mass, friction * contact.impulse);
    push(model, contact, -(impulse / speed) * sliding, v);
    return work - static_cast<double>(impulse / speed * sliding.dot(ball_velocity));
}

}  // namespace

Real push_of(const Contact& contact, Real radius) { return contact.depth - slop * radius; }

ResponseReport resolve_contacts(const ClothModel& model, const ResponseParameters& parameters,
                                std::span<const Ball> balls, Real h, std::vector<Contact>& contacts,
                                ClothState& state) {
    separate(model, parameters.thickness, balls, contacts, state.x);
    const Real resting = resting_steps * h * model.gravity.norm();
    for (Contact& contact : contacts) {
        aim(model, parameters.restitution, ball_of(contact, balls).velocity, resting, state.v, contact);
    }
    for (int sweep = 0; sweep < velocity_sweeps; ++sweep) {
        for (Contact& contact : contacts) stop_approach(model, contact, state.v);
    }
    ResponseReport report;
    for (const Contact& contact : contacts) {
        report.ball_work +=
            slow_sliding(model, parameters.friction, ball_of(contact, balls).velocity, contact, state.v);
    }
    for (const Contact& contact : contacts) report.depth = std::max(report.depth, contact.depth);
    return report;
}

}  // namespace drape
