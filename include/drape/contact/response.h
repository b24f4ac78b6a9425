#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "drape/base/enum_names.h"
#include "drape/contact/contact.h"

namespace drape {

/// How contacts are answered.
enum class ResponseKind { Projection };

template <>
inline constexpr auto enum_names<ResponseKind> = all_names<ResponseKind>("projection");

struct ResponseParameters {
    ResponseKind kind = ResponseKind::Projection;
    Real friction = Real(0.3);     ///< Coulomb coefficient
    Real restitution = 0;          ///< of the normal speed
    Real thickness = Real(0.002);  ///< [m]
};

/// What a response leaves and what it has done.
struct ResponseReport {
    Real depth = 0;        ///< the largest that is left [m]
    double ball_work = 0;  ///< by the balls' motion on the cloth: impulses times their velocities [J]
};

/// By how much a contact is pushed out: what of its depth is not left, for a resting contact to last [m].
/// @param radius of its ball [m]
Real push_of(const Contact& contact, Real radius);

/// Corrects positions and velocities so that the contacts' triangles stay out of the balls and do not enter them.
/// Gauss-Seidel over the contacts in their order: each closest point is found again before it is used. Impulses act on
/// a triangle's corners by their weights @cite bridson2002 and add up from sweep to sweep @cite catto2005.
/// @param contacts as found at `state.x`; their points are updated
/// @param h the substep [s]; normal speeds that gravity alone brings within it do not bounce
/// @par Cost O(contacts), allocates nothing
ResponseReport resolve_contacts(const ClothModel& model, const ResponseParameters& parameters,
                                std::span<const Ball> balls, Real h, std::vector<Contact>& contacts, ClothState& state);

}  // namespace drape
