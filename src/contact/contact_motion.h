#pragma once

#include "contact_geometry.h"
#include "drape/contact/response.h"

namespace drape {

/// Moves (or speeds up) a contact's corners, each by its share w_k / m_k of a push at the contact point.
inline void push_corners(const ClothModel& model, const Contact& contact, const Vec3& push, Points& p) {
    for (std::size_t k = 0; k < 3; ++k) {
        const int corner = contact.corners[k];
        p.row(corner) += contact.barycentric[k] * model.inverse_mass[corner] * push.transpose();
    }
}

/// From a ball's centre to where it touches; `normal` leads out of it.
inline Vec3 arm(const Ball& ball, const Vec3& normal) { return ball.radius * normal; }

/// Displacements within the substep, of cloth and balls: what contacts measure, and where they push.
struct Displacements {
    const ClothModel& model;
    Points& x;
    std::span<Ball> balls;

    [[nodiscard]] Vec3 of_ball(int number, const Vec3& normal) const {
        if (number == the_ground) return Vec3::Zero();
        const Ball& ball = balls[static_cast<std::size_t>(number)];
        return ball.moved + ball.turned.cross(arm(ball, normal));
    }
    void push_ball(int number, const Vec3& normal, const Vec3& push) {
        if (number == the_ground) return;
        Ball& ball = balls[static_cast<std::size_t>(number)];
        ball.moved += ball.inverse_mass * push;
        ball.centre += ball.inverse_mass * push;
        ball.turned += ball.inverse_inertia() * arm(ball, normal).cross(push);
    }
    [[nodiscard]] Vec3 of_first(const Contact& contact) const { return at_point(contact, x) - contact.start; }
    void push_first(const Contact& contact, const Vec3& push) { push_corners(model, contact, push, x); }
    static ContactPush& given(ContactPlane& contact) { return contact.displacement; }
};

/// The same of velocities.
struct Velocities {
    const ClothModel& model;
    Points& v;
    std::span<Ball> balls;

    [[nodiscard]] Vec3 of_ball(int number, const Vec3& normal) const {
        if (number == the_ground) return Vec3::Zero();
        const Ball& ball = balls[static_cast<std::size_t>(number)];
        return ball.velocity + ball.spin.cross(arm(ball, normal));
    }
    void push_ball(int number, const Vec3& normal, const Vec3& push) {
        if (number == the_ground) return;
        Ball& ball = balls[static_cast<std::size_t>(number)];
        ball.velocity += ball.inverse_mass * push;
        ball.spin += ball.inverse_inertia() * arm(ball, normal).cross(push);
    }
    [[nodiscard]] Vec3 of_first(const Contact& contact) const { return at_point(contact, v); }
    void push_first(const Contact& contact, const Vec3& push) { push_corners(model, contact, push, v); }
    static ContactPush& given(ContactPlane& contact) { return contact.impulse; }
};

/// Motion of one kind, asked of each body.
template <class Motion>
concept BodyMotion = requires(const Motion& motion, const Contact& contact) {
    motion.of_first(contact);
};

/// How the first body of a contact moves against the second.
template <BodyMotion Motion>
Vec3 relative(const Motion& motion, const Contact& contact) {
    return motion.of_first(contact) - motion.of_ball(contact.ball, contact.normal);
}
template <BodyMotion Motion>
Vec3 relative(const Motion& motion, const BallContact& contact) {
    return motion.of_ball(contact.first, -contact.normal) - motion.of_ball(contact.ball, contact.normal);
}

/// Pushes the first body of a contact, and the second the other way.
template <BodyMotion Motion>
void push_apart(Motion& motion, const Contact& contact, const Vec3& push) {
    motion.push_first(contact, push);
    motion.push_ball(contact.ball, contact.normal, -push);
}
template <BodyMotion Motion>
void push_apart(Motion& motion, const BallContact& contact, const Vec3& push) {
    motion.push_ball(contact.first, -contact.normal, push);
    motion.push_ball(contact.ball, contact.normal, -push);
}

}  // namespace drape
