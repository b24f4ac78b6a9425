#pragma once

#include <memory>
#include <span>

#include "drape/base/copied.h"
#include "drape/base/enum_names.h"
#include "drape/contact/body.h"
#include "drape/contact/contact_row.h"
#include "drape/model/cloth_model.h"

namespace drape {

/// How contacts are answered; src/contact/solve has a file for each but the last, which joins two.
enum class ResponseKind {
    Projection,  ///< positions are put back onto the surface, then velocities stopped
    Penalty,     ///< a spring and a damper push out what has entered
    Impulse,     ///< an impact changes velocities, and positions by that over the rest of the step; then projection
    Hybrid       ///< impulses on impact, penalties at rest
};

/// Whether some contacts of this response, or all, are answered by penalties.
bool has_penalties(ResponseKind kind);

struct ResponseParameters {
    ResponseKind kind = ResponseKind::Projection;
    Real friction = Real(0.3);          ///< Coulomb coefficient between cloths
    Real pair_thickness = Real(0.002);  ///< at which cloth keeps away from cloth [m]
    Real stiffness = 1000;              ///< of the penalty's springs, one a contact [N/m]
    Real displacement_factor = 1;       ///< of the method that makes the substeps, see the function of this name
};

/// What a response leaves and what it has done.
struct ResponseReport {
    Real depth = 0;     ///< the largest that is left in bodies [m]
    Real residual = 0;  ///< the largest change of any contact's displacement in the last sweep [m]
    int sweeps = 0;     ///< over the contacts, of both solves
};

/// A cloth in contact.
struct ClothInContact {
    const ClothModel& model;
    const Points& before;  ///< positions at the start of the substep, n x 3 [m]
    ClothState& state;
    int held = -1;  ///< particle in the hand, which contacts push as a free one; -1: none

    /// That an impulse meets [1/kg].
    [[nodiscard]] Real inverse_mass(int particle) const {
        return particle == held ? 1 / model.particle_mass : model.inverse_mass[particle];
    }
};

/// What solids, and the balls that nothing pushes, have given a cloth in the response, through these contacts [J].
double work_of_kinematic_bodies(std::span<const ContactRow> rows, std::span<const Body> bodies);

/// Of the bodies that contacts push [J].
double kinetic_energy(std::span<const Body> bodies);

/// Whether a contact is that of a motor and a body that stops it.
inline bool stops_motor(const ContactRow& row, std::span<const Body> bodies) {
    return row.kind == RowKind::Bodies &&
           stops_motor(bodies[static_cast<std::size_t>(row.first_body)], bodies[static_cast<std::size_t>(row.body)]);
}

/// How far a contact is pushed out: its depth, less what is left so that a resting contact lasts [m].
Real correction_of(const ContactRow& row, std::span<const Body> bodies);

/// Updates the depths of contacts to where all is now.
/// @return the largest in a body [m]
Real update_depths(std::span<const ClothInContact> cloths, std::span<const Body> bodies, std::span<ContactRow> rows);

/// The longest stable step [s] of the penalty at a loose particle of mass m, a spring k with damping ratio zeta: w
/// times the root of m / k. Where a damper sees the velocity before its push, w = 2 (sqrt(1 + zeta^2) - zeta); where it
/// sees the mean of before and after, zeta w^3 + w^2 = 4. Springs of the cloth make it shorter.
/// @param inverse_mass of the particle [1/kg]
/// @param displacement_factor of the method, see the function of this name: below 1 a damper sees the mean
Real penalty_step_limit(Real stiffness, Real restitution, Real inverse_mass, Real displacement_factor = 1);

/// Answers contacts, and owns what that needs; a copy makes its own.
class ContactSolver {
public:
    /// Room for as many contacts without allocating, but for no more than a hundred thousand: a scene with more of them
    /// at a time makes more room once.
    void reserve(std::size_t contacts);

    /// Corrects positions and velocities so that cloth and balls stay out of each other and of all bodies.
    /// Contacts are solved one after the other, again and again, each for both normal and friction, until none changes
    /// by more than a stated tolerance (projected Gauss-Seidel). Impulses act on a triangle's corners by their weights
    /// @cite bridson2002 and add up from sweep to sweep @cite catto2005; that of friction is bounded by the friction
    /// coefficient times the normal one. Friction stops displacements, not velocities alone: else a resting cloth
    /// creeps by what gravity moves it within a step.
    /// @param h the substep [s]; normal speeds that gravity alone brings within it do not bounce
    /// @param cloths all that are in contact, the number of each its index
    /// @param bodies those with an inverse mass are pushed back
    /// @par Cost O(contacts) a sweep; allocates nothing once there have been as many contacts before
    ResponseReport resolve(const ResponseParameters& parameters, Real h, std::span<const ClothInContact> cloths,
                           std::span<Body> bodies, std::span<ContactRow> rows);

    struct Scratch;

private:
    Scratch& scratch();

    ScratchOnCopy<std::shared_ptr<Scratch>> scratch_;  ///< made when it is first needed
};

}  // namespace drape
