#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "drape/bounds/broad_phase.h"
#include "drape/contact/near_pairs.h"
#include "drape/model/ball.h"
#include "drape/model/cloth_model.h"
#include "drape/model/ground.h"

namespace drape {

/// The number of a contact's ball where the cloth, or a ball, touches the ground.
inline constexpr int the_ground = -1;

/// The number of a contact's ball where the cloth, or a ball, touches the first solid; those of further solids follow.
inline constexpr int first_solid = std::numeric_limits<int>::min();

/// Whether a contact's second body is a plane for this substep: the ground, or the surface of a solid next to it.
[[nodiscard]] constexpr bool is_plane(int ball) { return ball < 0; }
[[nodiscard]] constexpr bool is_solid(int ball) { return ball < the_ground; }

/// What the response gives to one contact, in displacements of the substep or in velocities.
struct ContactPush {
    Real target = 0;               ///< least motion along the normal [m or m/s]
    Real normal = 0;               ///< given along the normal, never less than zero [kg m or N s]
    Vec3 friction = Vec3::Zero();  ///< given across the normal [kg m or N s]
};

/// A particle that a contact pushes.
struct ContactParticle {
    int cloth = 0, particle = 0;
    Real weight = 0;  ///< of its motion in that of the contact point; less than zero if it is of the second feature
    Real share = 0;   ///< of a push, that it moves by: weight times inverse mass [1/kg]
};

/// What all contacts have in common.
struct ContactPlane {
    Vec3 normal = Vec3::Zero();  ///< from the second body to the first, length 1
    Real depth = 0;              ///< by which they overlap, thickness counted; less than zero: a gap [m]

    // Filled by the response
    Real friction_coefficient = 0;
    bool active = false;    ///< in the solve under way
    Real inverse_mass = 0;  ///< that a push along the normal meets, of both bodies; 0 if none moves [1/kg]
    Real mass = 0;          ///< 1 / inverse_mass, or 0 [kg]
    Real sliding_mass = 0;  ///< the same for a push across the normal [kg]
    bool lasts = false;     ///< it was there in the substep before; kept by the warm start
    int particle_count = 0;
    std::array<ContactParticle, 4> particles{};  ///< the first `particle_count`
    Vec3 start = Vec3::Zero();  ///< the first point, or its offset from the second, at the start of the substep [m]
    Real remaining = 0;         ///< of the substep, after the impact [s]
    Real approach = 0;          ///< speed at which they meet, less than zero where they part [m/s]
    ContactPush displacement;   ///< within the substep
    ContactPush impulse;

    [[nodiscard]] std::span<const ContactParticle> pushed() const {
        return std::span(particles).first(static_cast<std::size_t>(particle_count));
    }
};

/// The surface of a solid next to a contact.
struct SolidPlane {
    Real height = 0;               ///< of the surface along the contact's normal [m]
    Vec3 moved = Vec3::Zero();     ///< within the substep [m]
    Vec3 velocity = Vec3::Zero();  ///< [m/s]
};

/// A contact whose second body is a ball, the ground, or a solid.
struct BodyContact : ContactPlane {
    int ball = 0;      ///< or `the_ground`, or `first_solid` and more
    SolidPlane plane;  ///< where the second body is a solid
};

/// A point of the cloth that may come nearer to a ball, a solid or the ground within the substep than the cloth's
/// thickness: a particle, or the point of an edge or of a triangle that is closest. Where they are fast, the plane
/// between them is that of the start of the substep, when they were on the right sides of each other, and goes on with
/// the body: so nothing passes. Or a node of the hierarchy that stands for the cloth within it: a sphere that is fixed
/// to the middle of a triangle in the node's middle, and felt there.
struct Contact : BodyContact {
    int cloth = 0;                      ///< filled by the response
    int triangle = 0;                   ///< that the point belongs to
    std::array<int, 3> corners{};       ///< its particles
    std::array<Real, 3> barycentric{};  ///< of the point
    Vec3 point = Vec3::Zero();          ///< [m]
    bool of_particle = false;           ///< the point is a corner
    bool separated = false;             ///< it was found in the substep before, and not in this one
    bool of_node = false;               ///< only then there is a sphere:
    Vec3 offset = Vec3::Zero();         ///< from `point` to its centre [m]
    Real radius = 0;                    ///< that counts towards the depth [m]
};

/// Two balls that touch, or a ball on the ground or on a solid.
struct BallContact : BodyContact {
    int first = 0;  ///< the first body, a ball
};

/// Two features of cloths that may come nearer to each other within the substep than the cloths' thickness. The plane
/// between them is that of the start of the substep, when they were on the right sides of each other.
struct PairContact : ContactPlane {
    NearPair pair;
};

/// The touched triangles, exactly: those whose distance to the ball's centre is at most radius + thickness.
/// @param x n x 3 [m]
/// @param cells candidate cells
/// @param triangles receives the triangle numbers, in the order of `cells`; cleared first
void find_touched_triangles(const Grid& grid, const Points& x, const Ball& ball, Real thickness,
                            std::span<const CellRun> cells, std::vector<int>& triangles, Kernels kernels);

/// Where cloth is, and was at the start of the substep.
struct ClothMotion {
    const Points &before, &x;  ///< n x 3 [m]
};

/// The reach of a search: by how much a body and cloth have come nearer to each other within a substep, at most; 0
/// where that is too little for one to be on the wrong side of the other.
/// @param room half of it is too little: a ball's radius, or the thickness beside a solid [m]
[[nodiscard]] inline Real reach_of(Real nearer, Real room) { return 2 * nearer > room ? nearer : Real(0); }

/// The contacts of the candidate cells with one ball, appended: each particle, each edge and each triangle at most
/// once. A particle counts if it may come into the grown ball; a triangle, or an edge, if its closest point to the
/// centre may. With a reach, the planes are those of the start of the substep: what passes through has come past its
/// plane, and is found like all else. Without one they are those of the end: cloth lies more calmly on these.
/// @param ball_number is stored with each contact
/// @param reach by how much ball and cloth may have come nearer to each other within the substep [m]
/// @param kernels plain: each cell is tested; vector: cells that their corners show to be too far are left out first
/// @return how many of the cells touch at the end, or have come past the plane of the start
std::int64_t find_contacts(const Grid& grid, const ClothMotion& cloth, const Ball& ball, int ball_number,
                           Real thickness, Real reach, std::span<const CellRun> cells, std::vector<Contact>& contacts,
                           Kernels kernels);

/// The contacts with the ground, appended: particles alone, for whatever is between them is above the lowest.
void find_ground_contacts(const Grid& grid, const Points& x, Real height, Real thickness,
                          std::vector<Contact>& contacts);

/// The same among the corners of candidate cells, in the same order.
/// @param particles scratch
void find_ground_contacts(const Grid& grid, const Points& x, Real height, Real thickness,
                          std::span<const CellRun> cells, std::vector<CellRun>& particles,
                          std::vector<Contact>& contacts);

/// The contacts of the balls with each other, and with the ground where it is solid; cleared first. Balls that have
/// passed each other within the substep, or have come past their middles, touch in the plane in which they have met.
/// @par Cost O(balls^2)
void find_ball_contacts(std::span<const Ball> balls, const Ground& ground, std::vector<BallContact>& contacts);

/// How fast a node's sphere may push: as fast as a cloth settles, and slower than it tears [m/s].
inline constexpr Real node_push_speed = 1;

/// The contacts of nodes at which a search has ended, as their spheres, with one ball, appended. @cite hubbard1996
/// Most of a sphere is empty. Pushed out of it at once, the one triangle that feels it would tear at its neighbours:
/// what is deeper than a push may be is taken off the sphere's radius.
/// @param longest_push that one response may make of a contact [m]
void find_node_contacts(const Grid& grid, const Points& x, const Ball& ball, int ball_number, Real thickness,
                        Real longest_push, std::span<const StoppedNode> nodes, std::vector<Contact>& contacts);

}  // namespace drape
