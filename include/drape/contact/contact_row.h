#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <span>

#include "drape/base/real.h"

namespace drape {

/// What meets in a contact.
enum class RowKind : std::uint8_t {
    Particle,  ///< of a cloth, and a body
    Triangle,  ///< a point in a triangle of a cloth, or on one of its edges, and a body
    Node,      ///< a sphere about a node of the hierarchy that stands for the cloth within, and a ball
    Pair,      ///< two features of cloth: a particle and a triangle, or two edges
    Bodies     ///< two bodies, of which the first is a ball
};

/// A particle that a contact moves.
struct RowParticle {
    int cloth = 0, particle = 0;
    Real weight = 0;  ///< of its motion in that of the contact point; less than zero if it is of the second feature
};

/// What the response gives to a contact, in displacements of the substep or in velocities.
struct RowImpulse {
    Real normal = 0;               ///< along the normal, never less than zero [kg m or N s]
    Vec3 friction = Vec3::Zero();  ///< across the normal [kg m or N s]

    [[nodiscard]] Vec3 about(const Vec3& n) const { return normal * n + friction; }
};

inline constexpr int no_body = -1;

/// One contact: what touches, or may touch within the substep, and what keeps it apart. It is a plane between two
/// sides, which moves with the second of them: the first is out where n (p1 - p2) is at least `distance`. The point p1
/// is the weighted sum of the particles, or the centre of the first body; p2 is the centre of the second body, or zero
/// where there is none. The impulses of a substep are found again in the next by what touches, see `compare`.
struct ContactRow {
    RowKind kind = RowKind::Particle;
    std::uint8_t count = 0;        ///< of the particles
    std::uint8_t first_count = 0;  ///< of these, those of the first feature
    bool lasts = false;            ///< it was there in the substep before
    bool separated = false;  ///< it was there in the substep before, and has not been found in this one; never a pair
    int triangle = 0;        ///< of the first feature's cloth: the feature, or what reports it; in a pair the
                             ///< second feature, or -1 if that is an edge
    int first_body = no_body, body = no_body;
    Vec3 normal = Vec3::Zero();  ///< from the second to the first, length 1
    Real distance = 0;           ///< thickness counted [m]
    Real depth = 0;              ///< distance - n (p1 - p2), where they are now; less than zero: a gap [m]
    std::array<RowParticle, 4> particles{};
    RowImpulse displacement, impulse;  ///< within the substep

    [[nodiscard]] std::span<const RowParticle> moved() const { return std::span(particles).first(count); }
    [[nodiscard]] bool has_impulse() const { return displacement.normal != 0 || impulse.normal != 0; }

    /// The point of the first side, where it is cloth.
    /// @param x of that cloth, n x 3 [m]
    [[nodiscard]] Vec3 point(const Points& x) const {
        Vec3 sum = Vec3::Zero();
        for (const RowParticle& p : moved().first(first_count)) sum += p.weight * x.row(p.particle).transpose();
        return sum;
    }
};

static_assert(sizeof(ContactRow) <= 192);

/// By what touches, in the order in which contacts are found: cloth by cloth and body by body, triangle by triangle,
/// the particles that it reports first; then the pairs, then bodies with bodies.
std::strong_ordering compare(const ContactRow& first, const ContactRow& second);

}  // namespace drape
