#include "drape/contact/response.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact_geometry.h"
#include "drape/base/vectorise.h"

namespace drape {
namespace {

/// Depth that is left in place, over the radius: a resting contact then lasts from step to step instead of flickering.
constexpr Real slop = Real(1e-4);

/// A push shorter than this, over the radius, leaves a triangle's closest point where it is in the triangle.
constexpr Real short_push = Real(1e-3);

/// A push shorter than this, over the radius, is not worth another sweep.
constexpr Real tolerance = Real(1e-6);

/// Sweeps over the contacts. Positions stop earlier once no contact had to be corrected.
constexpr int position_sweeps = 6;
constexpr int velocity_sweeps = 3;

/// An approach slower than this many steps of gravity is resting, and does not bounce.
constexpr Real resting_steps = 4;

/// The sum of w^2/m over a contact's corners: what a push at the contact point meets. Zero if nothing can move.
Real inverse_mass_at(const ClothModel& model, const Contact& contact) {
    Real sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        sum += contact.barycentric[k] * contact.barycentric[k] * model.inverse_mass[contact.corners[k]];
    }
    return sum;
}

/// Moves (or speeds up) a contact's corners, each by its share of an impulse that acts at the contact point.
DRAPE_INLINE void push(const ClothModel& model, const Contact& contact, const Vec3& impulse, Points& p) {
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

/// Pushes every contact that is deeper than the slop out to it; its neighbours see the moved particles.
void separate(const ClothModel& model, const ResponseParameters& parameters, std::span<const Ball> balls,
              std::vector<Contact>& contacts, Points& x) {
    bool moved = false, moved_far = false;  // contacts are fresh until the first particle moves
    bool corrected = true;
    const auto refresh = [&](Contact& contact) {
        const Ball& ball = balls[static_cast<std::size_t>(contact.ball)];
        if (moved_far) {
            locate(x, ball, parameters.thickness, contact);
        } else if (moved) {
            follow(x, ball, parameters.thickness, contact);
        }
    };
    for (int sweep = 0; sweep < position_sweeps && corrected; ++sweep) {
        corrected = false;
        for (Contact& contact : contacts) {
            refresh(contact);
            const Real radius = balls[static_cast<std::size_t>(contact.ball)].radius;
            const Real distance = push_of(contact, radius);
            const Real inverse_mass = distance > tolerance * radius ? inverse_mass_at(model, contact) : Real(0);
            if (inverse_mass == 0) continue;
            push(model, contact, distance / inverse_mass * contact.normal, x);
            corrected = moved = true;
            moved_far = moved_far || distance > short_push * radius;
        }
    }
    for (Contact& contact : contacts) refresh(contact);
}

/// Stops every contact point that approaches its ball, or throws it back. Each contact's impulse is corrected from
/// sweep to sweep, downward too where its neighbours have pushed already, and never pulls (projected Gauss-Seidel).
void stop_approach(const ClothModel& model, const ResponseParameters& parameters, std::span<const Ball> balls, Real h,
                   std::vector<Contact>& contacts, Points& v) {
    const Real resting = resting_steps * h * model.gravity.norm();
    for (Contact& contact : contacts) {
        const Vec3& ball_velocity = balls[static_cast<std::size_t>(contact.ball)].velocity;
        const Real ball_speed = ball_velocity.dot(contact.normal);
        const Real approach = ball_speed - at_point(contact, v).dot(contact.normal);
        contact.inverse_mass = inverse_mass_at(model, contact);
        contact.impulse = 0;
        contact.leaving_speed = ball_speed + (approach > resting ? parameters.restitution * approach : Real(0));
    }
    for (int sweep = 0; sweep < velocity_sweeps; ++sweep) {
        for (Contact& contact : contacts) {
            if (contact.inverse_mass == 0) continue;
            const Real missing = contact.leaving_speed - at_point(contact, v).dot(contact.normal);
            const Real impulse = std::max(contact.impulse + missing / contact.inverse_mass, Real(0));
            if (impulse == contact.impulse) continue;
            push(model, contact, (impulse - contact.impulse) * contact.normal, v);
            contact.impulse = impulse;
        }
    }
}

/// Slows the sliding of every contact by at most the friction coefficient times its normal impulse.
/// @return what the balls' motion gives the cloth through normal and sliding impulses [J]
double slow_sliding(const ClothModel& model, const ResponseParameters& parameters, std::span<const Ball> balls,
                    const std::vector<Contact>& contacts, Points& v) {
    double work = 0;
    for (const Contact& contact : contacts) {
        if (contact.impulse <= 0) continue;
        const Vec3& ball_velocity = balls[static_cast<std::size_t>(contact.ball)].velocity;
        work += static_cast<double>(contact.impulse * contact.normal.dot(ball_velocity));
        const Vec3 relative = at_point(contact, v) - ball_velocity;
        const Vec3 sliding = relative - relative.dot(contact.normal) * contact.normal;
        const Real speed = sliding.norm();
        if (speed == 0) continue;
        const Real impulse = std::min(speed / contact.inverse_mass, parameters.friction * contact.impulse);
        push(model, contact, -(impulse / speed) * sliding, v);
        work -= static_cast<double>(impulse / speed * sliding.dot(ball_velocity));
    }
    return work;
}

}  // namespace

Real push_of(const Contact& contact, Real radius) { return contact.depth - slop * radius; }

ResponseReport resolve_contacts(const ClothModel& model, const ResponseParameters& parameters,
                                std::span<const Ball> balls, Real h, std::vector<Contact>& contacts,
                                ClothState& state) {
    separate(model, parameters, balls, contacts, state.x);
    stop_approach(model, parameters, balls, h, contacts, state.v);
    ResponseReport report;
    report.ball_work = slow_sliding(model, parameters, balls, contacts, state.v);
    for (const Contact& contact : contacts) report.depth = std::max(report.depth, contact.depth);
    return report;
}

}  // namespace drape
