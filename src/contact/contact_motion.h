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

/// Displacements of balls within the substep: what contacts measure, and where they push.
struct BallDisplacements {
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
};

/// The same of velocities.
struct BallVelocities {
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
};

/// Calls visit(cloth, particle, share) for each particle of a pair of features; the shares of the second are negative.
template <class Visit>
void for_each_particle_of(const NearPair& pair, Visit visit) {
    const auto& [cloths, first_count, particles] = pair.features;
    for (std::size_t k = 0; k < 4; ++k) {
        const bool of_first = static_cast<int>(k) < first_count;
        visit(cloths[of_first ? 0 : 1], particles[k], of_first ? pair.weights[k] : -pair.weights[k]);
    }
}

/// Displacements within the substep, of cloths and balls.
struct Displacements : BallDisplacements {
    std::span<const ClothInContact> cloths;

    Displacements(std::span<const ClothInContact> all_cloths, std::span<Ball> all_balls)
        : BallDisplacements{all_balls}, cloths(all_cloths) {}

    [[nodiscard]] Points& of_cloth(int number) const { return cloths[static_cast<std::size_t>(number)].state.x; }
    [[nodiscard]] Vec3 of_first(const Contact& contact) const {
        return at_point(contact, of_cloth(contact.cloth)) - contact.start;
    }
    static Vec3 since(const PairContact& contact, const Vec3& now) { return now - contact.start; }
    static ContactPush& given(ContactPlane& contact) { return contact.displacement; }
};

/// The same of velocities.
struct Velocities : BallVelocities {
    std::span<const ClothInContact> cloths;

    Velocities(std::span<const ClothInContact> all_cloths, std::span<Ball> all_balls)
        : BallVelocities{all_balls}, cloths(all_cloths) {}

    [[nodiscard]] Points& of_cloth(int number) const { return cloths[static_cast<std::size_t>(number)].state.v; }
    [[nodiscard]] Vec3 of_first(const Contact& contact) const { return at_point(contact, of_cloth(contact.cloth)); }
    static Vec3 since(const PairContact& /*contact*/, const Vec3& now) { return now; }
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
Vec3 relative(const Motion& motion, const PairContact& contact) {
    Vec3 sum = Vec3::Zero();
    for_each_particle_of(contact.pair, [&](int cloth, int particle, Real share) {
        sum += share * position(motion.of_cloth(cloth), particle);
    });
    return motion.since(contact, sum);
}
template <BodyMotion Motion>
Vec3 relative(const Motion& motion, const BallContact& contact) {
    return motion.of_ball(contact.first, -contact.normal) - motion.of_ball(contact.ball, contact.normal);
}

/// Pushes the first body of a contact, and the second the other way.
template <BodyMotion Motion>
void push_apart(Motion& motion, const Contact& contact, const Vec3& push) {
    const ClothModel& model = motion.cloths[static_cast<std::size_t>(contact.cloth)].model;
    push_corners(model, contact, push, motion.of_cloth(contact.cloth));
    motion.push_ball(contact.ball, contact.normal, -push);
}
template <BodyMotion Motion>
void push_apart(Motion& motion, const PairContact& contact, const Vec3& push) {
    for_each_particle_of(contact.pair, [&](int cloth, int particle, Real share) {
        const ClothModel& model = motion.cloths[static_cast<std::size_t>(cloth)].model;
        motion.of_cloth(cloth).row(particle) += share * model.inverse_mass[particle] * push.transpose();
    });
}
template <BodyMotion Motion>
void push_apart(Motion& motion, const BallContact& contact, const Vec3& push) {
    motion.push_ball(contact.first, -contact.normal, push);
    motion.push_ball(contact.ball, contact.normal, -push);
}

}  // namespace drape
