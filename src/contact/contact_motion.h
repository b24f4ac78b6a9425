#pragma once

#include <Eigen/Geometry>

#include "contact_geometry.h"
#include "drape/contact/response.h"
#include "tuning.h"

namespace drape {

/// Adds a particle to those that a contact pushes.
inline void add_particle(std::span<const ClothInContact> cloths, int cloth, int particle, Real weight,
                         ContactPlane& contact) {
    if (weight == 0) return;
    const Real inverse_mass = cloths[static_cast<std::size_t>(cloth)].model.inverse_mass[particle];
    contact.particles[static_cast<std::size_t>(contact.particle_count++)] = {cloth, particle, weight,
                                                                             weight * inverse_mass};
}

/// What a push at the contact point meets: 1/m = sum w_k^2 / m_k over its corners. Zero if nothing can move, and where
/// the point hangs on pinned corners so nearly that a push would throw the free one far.
inline Real inverse_mass_of_particles(const ContactPlane& contact) {
    Real sum = 0, largest = 0;
    for (const ContactParticle& p : contact.pushed()) {
        sum += p.weight * p.share;
        largest = std::max(largest, p.share / p.weight);
    }
    return sum < min_mobility * largest ? Real(0) : sum;
}

/// The particles that a contact pushes.
inline void list_particles(std::span<const ClothInContact> cloths, Contact& contact) {
    contact.particle_count = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        add_particle(cloths, contact.cloth, contact.corners[k], contact.barycentric[k], contact);
    }
    // The push is sized by the mass of the ball alone then, and would throw the free corner far
    if (inverse_mass_of_particles(contact) == 0) {
        std::ranges::for_each(contact.particles, [](ContactParticle& p) { p.share = 0; });
    }
}
inline void list_particles(std::span<const ClothInContact> cloths, PairContact& contact) {
    const FeaturePair& features = contact.pair.features;
    contact.particle_count = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        add_particle(cloths, features.cloth_of(k), features.particles[k], contact.pair.signed_weight(k), contact);
    }
}

/// What a contact has of the motion of its particles.
/// @param of_cloth of_cloth(number) is n x 3, a row a particle
template <class OfCloth>
Vec3 weighted_sum(const ContactPlane& contact, OfCloth of_cloth) {
    Vec3 sum = Vec3::Zero();
    for (const ContactParticle& p : contact.pushed()) {
        sum += p.weight * position(of_cloth(p.cloth), p.particle);
    }
    return sum;
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
    static const Vec3& of_plane(const SolidPlane& plane) { return plane.moved; }
    void push_ball(int number, const Vec3& normal, const Vec3& push) {
        if (is_plane(number)) return;
        Ball& ball = balls[static_cast<std::size_t>(number)];
        if (ball.inverse_mass == 0) return;
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
    static const Vec3& of_plane(const SolidPlane& plane) { return plane.velocity; }
    void push_ball(int number, const Vec3& normal, const Vec3& push) {
        if (is_plane(number)) return;
        Ball& ball = balls[static_cast<std::size_t>(number)];
        if (ball.inverse_mass == 0) return;
        ball.velocity += ball.inverse_mass * push;
        ball.spin += ball.inverse_inertia() * arm(ball, normal).cross(push);
    }
};

/// Displacements within the substep, of cloths and balls.
struct Displacements : BallDisplacements {
    std::span<const ClothInContact> cloths;

    Displacements(std::span<const ClothInContact> all_cloths, std::span<Ball> all_balls)
        : BallDisplacements{all_balls}, cloths(all_cloths) {}

    [[nodiscard]] Points& of_cloth(int number) const { return cloths[static_cast<std::size_t>(number)].state.x; }
    static Vec3 start(const ContactPlane& contact) { return contact.start; }
    static Vec3 since_start(const ContactPlane& contact, const Vec3& now) { return now - contact.start; }
    static ContactPush& accumulated(ContactPlane& contact) { return contact.displacement; }
    static const ContactPush& accumulated(const ContactPlane& contact) { return contact.displacement; }
};

/// The same of velocities.
struct Velocities : BallVelocities {
    std::span<const ClothInContact> cloths;

    Velocities(std::span<const ClothInContact> all_cloths, std::span<Ball> all_balls)
        : BallVelocities{all_balls}, cloths(all_cloths) {}

    [[nodiscard]] Points& of_cloth(int number) const { return cloths[static_cast<std::size_t>(number)].state.v; }
    static Vec3 start(const ContactPlane& /*contact*/) { return Vec3::Zero(); }
    static Vec3 since_start(const ContactPlane& /*contact*/, const Vec3& now) { return now; }
    static ContactPush& accumulated(ContactPlane& contact) { return contact.impulse; }
    static const ContactPush& accumulated(const ContactPlane& contact) { return contact.impulse; }
};

/// Motion of one kind, asked of each body.
template <class Motion>
concept BodyMotion = requires(const Motion& motion) {
    motion.of_cloth(0);
};

template <BodyMotion Motion>
Vec3 of_particles(const Motion& motion, const ContactPlane& contact) {
    const auto of_cloth = [&](int cloth) -> const Points& { return motion.of_cloth(cloth); };
    return motion.since_start(contact, weighted_sum(contact, of_cloth));
}

/// How the first body of a contact moves against the second.
template <BodyMotion Motion>
Vec3 relative(const Motion& motion, const Contact& contact) {
    if (is_solid(contact.ball)) return of_particles(motion, contact) - motion.of_plane(contact.plane);
    return of_particles(motion, contact) - motion.of_ball(contact.ball, contact.normal);
}
template <BodyMotion Motion>
Vec3 relative(const Motion& motion, const PairContact& contact) {
    return of_particles(motion, contact);
}
template <BodyMotion Motion>
Vec3 relative(const Motion& motion, const BallContact& contact) {
    if (is_solid(contact.ball)) {
        return motion.of_ball(contact.first, -contact.normal) - motion.of_plane(contact.plane);
    }
    return motion.of_ball(contact.first, -contact.normal) - motion.of_ball(contact.ball, contact.normal);
}

/// Moves, or speeds up, the particles of a contact by their shares of a push.
template <BodyMotion Motion>
void push_particles(Motion& motion, const ContactPlane& contact, const Vec3& push) {
    for (const ContactParticle& p : contact.pushed()) {
        motion.of_cloth(p.cloth).row(p.particle) += p.share * push.transpose();
    }
}

/// Pushes the first body of a contact, and the second the other way.
template <BodyMotion Motion>
void push_apart(Motion& motion, const Contact& contact, const Vec3& push) {
    push_particles(motion, contact, push);
    motion.push_ball(contact.ball, contact.normal, -push);
}
template <BodyMotion Motion>
void push_apart(Motion& motion, const PairContact& contact, const Vec3& push) {
    push_particles(motion, contact, push);
}
template <BodyMotion Motion>
void push_apart(Motion& motion, const BallContact& contact, const Vec3& push) {
    motion.push_ball(contact.first, -contact.normal, push);
    motion.push_ball(contact.ball, contact.normal, -push);
}

}  // namespace drape
