#include "drape/contact/warm_start.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "contact_motion.h"
#include "drape/integrate/stability.h"
#include "resting.h"

namespace drape {
namespace {

bool solves_for_pushes(ResponseKind kind) { return kind == ResponseKind::Projection || kind == ResponseKind::Impulse; }

/// Contacts are found in this order: by ball, then by solid, in each by triangle with its particles first; on the
/// ground, which comes last, by particle.
std::tuple<unsigned, int, int> order_of(const Contact& contact) {
    if (contact.of_impact) return {static_cast<unsigned>(contact.ball), contact.triangle, 4};
    if (!contact.of_particle) return {static_cast<unsigned>(contact.ball), contact.triangle, 3};
    int corner = 0;
    while (contact.barycentric[static_cast<std::size_t>(corner)] == 0) ++corner;
    if (contact.ball == the_ground) {
        return {static_cast<unsigned>(contact.ball), contact.corners[static_cast<std::size_t>(corner)], 0};
    }
    return {static_cast<unsigned>(contact.ball), contact.triangle, corner};
}

const FeaturePair& order_of(const PairContact& contact) { return contact.pair.features; }

bool is_on_ground(const Contact& contact) { return contact.ball == the_ground; }
bool is_on_ground(const PairContact& /*contact*/) { return false; }

bool is_of_surface(const Contact& contact) { return !contact.of_node && !contact.of_impact; }
bool is_of_surface(const PairContact& /*contact*/) { return true; }

/// Whether it pushes a free ball too. Such a contact is kept with a push of zero, to be told that it lasts.
bool moves_both(const ContactPlane& contact) { return least_inverse_mass(contact) < contact.inverse_mass; }

/// Whether pushes may be forces of the step. Not of a method that takes its forces from the start of the step alone;
/// nor, where a force displaces by all of what its velocity would, beside those of pairs, which go on as displacements:
/// cloth that is pushed by both kinds is less calm. Nor of BDF2: what a force displaces by is another there after each
/// restart, and in substeps of 0.1 ms cloth quivers by that.
bool takes_forces(const ResponseParameters& parameters) {
    if (displacement_share(parameters.integrator) < 1) return true;
    return !has_step_limit(parameters.integrator) && parameters.integrator != IntegratorKind::Bdf2 && !parameters.pairs;
}

/// While a free ball touches the cloth: in the long substeps of a method without a step limit cloth that carries a ball
/// is calmer by displacements, which keep its contacts.
bool takes_forces_under_balls(IntegratorKind integrator) {
    return has_step_limit(integrator) || integrator == IntegratorKind::DormandPrince;
}

/// Whether the pushes that go on are those that stopped velocities, and not those that displaced; they are forces of
/// the step then.
bool takes_impulses(const ResponseParameters& parameters, const std::vector<Contact>& contacts) {
    return solves_for_pushes(parameters.kind) && takes_forces(parameters) &&
           (takes_forces_under_balls(parameters.integrator) || std::ranges::none_of(contacts, moves_both));
}

/// Of two cloths, both move.
bool takes_impulses(const ResponseParameters& /*parameters*/, const std::vector<PairContact>& /*contacts*/) {
    return false;
}

void scale(ContactPush& push, Real factor) {
    push.normal *= factor;
    push.friction *= factor;
}

/// What a force displaces by, if it gives the contact's impulse.
/// @param h the part of the substep that its velocity would displace for [s]
void displace_by_impulse(Real h, ContactPlane& contact) {
    contact.displacement = contact.impulse;
    scale(contact.displacement, h);
}

Vec3 push_along(const ContactPush& push, const Vec3& normal) { return push.normal * normal + push.friction; }

/// Where a contact of before is now, its depth less than zero if it has parted. Its normal stays, for the ball may have
/// come through the cloth since; a solid has moved on as it did. As an impact it is there for this substep alone: a
/// solid ends where the plane of a contact goes on.
void follow_contact(const ResponseParameters& parameters, std::span<const ClothInContact> cloths,
                    std::span<const Ball> balls, Contact& contact) {
    contact.point = at_point(contact, cloths[static_cast<std::size_t>(contact.cloth)].state.x);
    contact.of_impact = contact.ball != the_ground;
    contact.motion = {};
    if (is_solid(contact.ball)) contact.plane.height += contact.normal.dot(contact.plane.moved);
    contact.depth = depth_now(parameters, balls, contact);
}

/// The plane of a pair is that of this substep's start.
void follow_contact(const ResponseParameters& /*parameters*/, std::span<const ClothInContact> cloths,
                    std::span<const Ball> /*balls*/, PairContact& contact) {
    const auto at = [&](int number) -> ClothAt {
        const ClothInContact& cloth = cloths[static_cast<std::size_t>(number)];
        return {number, cloth.model.grid, cloth.before};
    };
    const auto [first, second] = contact.pair.features.cloths;
    locate(at(first), at(second), contact.pair);
    contact.normal = contact.pair.normal;
}

/// To an implicit method a push on a ball displaces it too: it has moved before the step.
void displace_ball(BallDisplacements& balls, const Contact& contact) {
    balls.push_ball(contact.ball, contact.normal, -push_along(contact.displacement, contact.normal));
}
void displace_ball(BallDisplacements& /*balls*/, const PairContact& /*contact*/) {}
void speed_up_ball(BallVelocities& balls, const Contact& contact) {
    balls.push_ball(contact.ball, contact.normal, -push_along(contact.impulse, contact.normal));
}
void speed_up_ball(BallVelocities& /*balls*/, const PairContact& /*contact*/) {}

/// By how many substeps of its motion the push of a contact goes ahead of it: within two to four, cloth that rocks on a
/// ball comes to rest.
constexpr Real lead = 3;

/// How much of the last substep is in a contact's motion: of all of it, the contact goes back and forth with the push.
constexpr Real newest_part = Real(0.5);

/// Of all three barycentric coordinates.
std::array<Real, 3> motion_of(const Contact& contact) {
    return {contact.motion[0], contact.motion[1], -contact.motion[0] - contact.motion[1]};
}

/// The push acts where the contact is going to be, within its triangle. What is zero but for rounding is zero: a
/// contact on an edge stays there.
void go_ahead(Real substeps, Contact& contact) {
    constexpr Real rounding = 16 * std::numeric_limits<Real>::epsilon();
    const auto motion = motion_of(contact);
    for (std::size_t k = 0; k < 3; ++k) {
        if (contact.barycentric[k] + substeps * motion[k] < -rounding) substeps = -contact.barycentric[k] / motion[k];
    }
    contact.ahead = substeps;
    for (std::size_t k = 0; k < 3; ++k) {
        const Real moved = contact.barycentric[k] + substeps * motion[k];
        contact.barycentric[k] = std::abs(moved) <= rounding ? Real(0) : moved;
    }
}
void go_ahead(Real /*substeps*/, PairContact& /*contact*/) {}

/// What the same contact has moved by since the substep before. A free ball rolls with its contacts: nothing goes
/// ahead.
void measure_motion(const Contact& before, std::span<const Ball> balls, Contact& contact) {
    if (!is_plane(contact.ball) && balls[static_cast<std::size_t>(contact.ball)].inverse_mass > 0) return;
    for (std::size_t k = 0; k < 2; ++k) {
        const Real moved = contact.barycentric[k] - (before.barycentric[k] - before.ahead * before.motion[k]);
        contact.motion[k] = before.motion[k] + newest_part * (moved - before.motion[k]);
    }
}
void measure_motion(const PairContact& /*before*/, std::span<const Ball> /*balls*/, PairContact& /*contact*/) {}

}  // namespace

template <class AnyContact>
void WarmStart<AnyContact>::take(const ResponseParameters& parameters, Real h, Real gravity,
                                 std::span<const ClothInContact> cloths, std::vector<AnyContact>& contacts) {
    last_.clear();
    const Real h_before = h_ > 0 ? h_ : h, factor = h / h_before;
    const Real force_share = displacement_share(parameters.integrator);
    const bool were_of_velocities = of_velocities_;
    of_velocities_ = takes_impulses(parameters, contacts);
    const Real share = of_velocities_ ? force_share : Real(1);
    h_ = h;
    const bool ground_is_gone = !parameters.ground.solid || parameters.ground.height < ground_height_;
    ground_height_ = parameters.ground.height;
    has_pushes_ = solves_for_pushes(parameters.kind);
    if (!has_pushes_) {
        if (parameters.kind == ResponseKind::Hybrid && !ground_is_gone) keep_without_pushes(contacts);
        return;
    }
    is_explicit_ = has_step_limit(parameters.integrator);
    const bool goes_ahead = of_velocities_ || (!is_explicit_ && force_share == 1);
    last_.swap(contacts);
    if (of_velocities_ || were_of_velocities) {
        for (AnyContact& contact : last_) displace_by_impulse(force_share * h_before, contact);
    }
    const auto rests = [&](const AnyContact& contact) {
        return may_rest(contact, contact.displacement.normal / (share * h_before), h_before, gravity);
    };
    std::erase_if(last_, [&](const AnyContact& contact) {
        if (!is_of_surface(contact) || contact.displacement.normal == 0) return true;
        if (ground_is_gone && is_on_ground(contact)) return true;
        return !rests(contact) && !moves_both(contact);
    });
    for (AnyContact& contact : last_) {
        if (!rests(contact)) scale(contact.displacement, 0);
        scale(contact.displacement, factor * factor);
        contact.impulse = contact.displacement;
        scale(contact.impulse, 1 / (share * h));
        if (goes_ahead) go_ahead(lead * factor, contact);
        list_particles(cloths, contact);
    }
}

/// Keeps which contacts have pushed, without their pushes.
template <class AnyContact>
void WarmStart<AnyContact>::keep_without_pushes(std::vector<AnyContact>& contacts) {
    last_.swap(contacts);
    std::erase_if(last_, [](const AnyContact& c) { return !is_of_surface(c) || c.impulse.normal == 0; });
    for (AnyContact& contact : last_) contact.displacement = contact.impulse = {};
}

template <class AnyContact>
const Real* WarmStart<AnyContact>::within_step(const ClothModel& model) {
    if (!of_velocities_ || last_.empty()) return nullptr;
    const Eigen::Index n = model.grid.particles();
    forces_.assign(static_cast<std::size_t>(3 * n), 0);
    Eigen::Map<Points> forces(forces_.data(), n, 3);
    for (const AnyContact& contact : last_) {
        const Vec3 force = push_along(contact.impulse, contact.normal) / h_;
        for (const PushedParticle& p : contact.pushed()) {
            if (p.share != 0) forces.row(p.particle) += p.weight * force.transpose();
        }
    }
    return forces_.data();
}

template <class AnyContact>
void WarmStart<AnyContact>::push_balls(std::span<Ball> balls) const {
    if (!of_velocities_) return;
    BallDisplacements displacements{balls};
    BallVelocities velocities{balls};
    for (const AnyContact& contact : last_) {
        displace_ball(displacements, contact);
        speed_up_ball(velocities, contact);
    }
}

template <class AnyContact>
void WarmStart<AnyContact>::before_step(std::span<const ClothInContact> cloths, std::span<Ball> balls) const {
    if (is_explicit_) return;
    Velocities velocities(cloths, balls);
    BallDisplacements displacements{balls};
    for (const AnyContact& contact : beside_step()) {
        push_apart(velocities, contact, push_along(contact.impulse, contact.normal));
        displace_ball(displacements, contact);
    }
}

/// Flat, because GCC would call a function for each sum of three numbers.
template <class AnyContact>
__attribute__((flatten)) void WarmStart<AnyContact>::after_step(std::span<const ClothInContact> cloths,
                                                                std::span<Ball> balls) const {
    if (!is_explicit_) return;
    Velocities velocities(cloths, balls);
    Displacements displacements(cloths, balls);
    for (const AnyContact& contact : beside_step()) {
        push_apart(velocities, contact, push_along(contact.impulse, contact.normal));
        push_apart(displacements, contact, push_along(contact.displacement, contact.normal));
    }
}

template <class AnyContact>
double WarmStart<AnyContact>::work_beside_step(std::span<const ClothInContact> cloths, int cloth) const {
    const ClothInContact& of = cloths[static_cast<std::size_t>(cloth)];
    Real work = 0;
    for (const AnyContact& contact : beside_step()) {
        const Vec3 force = push_along(contact.impulse, contact.normal) / h_;
        for (const PushedParticle& p : contact.pushed()) {
            if (p.cloth != cloth || p.share == 0) continue;
            work += p.weight * force.dot(position(of.state.x, p.particle) - position(of.before, p.particle));
        }
    }
    return static_cast<double>(work);
}

template <class AnyContact>
void WarmStart<AnyContact>::carry_over(const ResponseParameters& parameters, std::span<const ClothInContact> cloths,
                                       std::span<const Ball> balls, std::vector<AnyContact>& contacts) {
    parted_.clear();
    gaps_.clear();
    auto found = contacts.begin();
    for (AnyContact& before : last_) {
        const auto order = order_of(before);
        while (found != contacts.end() && order_of(*found) < order) ++found;
        if (found != contacts.end() && order_of(*found) == order) {
            if (!of_velocities_) found->displacement = before.displacement;  // else nothing is to be taken back
            found->impulse = before.impulse;
            found->lasts = true;
            measure_motion(before, balls, *found);
            ++found;
        } else if (before.displacement.normal > 0) {
            follow_contact(parameters, cloths, balls, before);
            parted_.push_back(before);
            gaps_.push_back(found - contacts.begin());
        }
    }
    insert(contacts);
}

/// Those that have parted, from the last to the first: what is behind one moves by as many as there are up to it.
template <class AnyContact>
void WarmStart<AnyContact>::insert(std::vector<AnyContact>& contacts) const {
    auto end = static_cast<std::ptrdiff_t>(contacts.size());
    contacts.resize(contacts.size() + parted_.size());
    for (std::size_t k = parted_.size(); k-- > 0; end = gaps_[k]) {
        const auto begin = contacts.begin(), place = begin + gaps_[k] + static_cast<std::ptrdiff_t>(k);
        std::move_backward(begin + gaps_[k], begin + end, place + 1 + end - gaps_[k]);
        *place = parted_[k];
    }
}

template class WarmStart<Contact>;
template class WarmStart<PairContact>;

}  // namespace drape
