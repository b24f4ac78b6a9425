#include "drape/contact/warm_start.h"

#include <algorithm>
#include <tuple>

#include "contact_motion.h"
#include "drape/integrate/stability.h"

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

/// What changes a speed by more than gravity does in this many steps is no rest: an impact, or the way out of a ball
/// that was put into the cloth.
constexpr Real rest_steps = 100;

bool is_of_surface(const Contact& contact) { return !contact.of_node && !contact.of_impact; }
bool is_of_surface(const PairContact& /*contact*/) { return true; }

template <class AnyContact>
bool rests(const AnyContact& contact, Real h, Real gravity) {
    const Real speed = contact.displacement.normal * contact.inverse_mass / h;
    return is_of_surface(contact) && speed > 0 && speed <= rest_steps * h * gravity;
}

void scale(ContactPush& push, Real factor) {
    push.normal *= factor;
    push.friction *= factor;
}

Vec3 push_along(const ContactPush& push, const Vec3& normal) { return push.normal * normal + push.friction; }

/// Where a contact of before is now, its depth less than zero if it has parted. Its normal stays, for the ball may have
/// come through the cloth since; a solid has moved on as it did.
void follow_contact(const ResponseParameters& parameters, std::span<const ClothInContact> cloths,
                    std::span<const Ball> balls, Contact& contact) {
    contact.point = at_point(contact, cloths[static_cast<std::size_t>(contact.cloth)].state.x);
    contact.of_impact = !is_plane(contact.ball);
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

}  // namespace

template <class AnyContact>
void WarmStart<AnyContact>::take(const ResponseParameters& parameters, Real h, Real gravity,
                                 std::span<const ClothInContact> cloths, std::vector<AnyContact>& contacts) {
    last_.clear();
    const Real h_before = h_ > 0 ? h_ : h, factor = h / h_before;
    const Real share = parameters.kind == ResponseKind::Impulse ? displacement_share(parameters.integrator) : Real(1);
    h_ = h;
    if (!solves_for_pushes(parameters.kind)) return;
    is_explicit_ = has_step_limit(parameters.integrator);
    before_ = is_explicit_ ? Real(0) : share;
    last_.swap(contacts);
    std::erase_if(last_, [&](const AnyContact& contact) { return !rests(contact, h_before, gravity); });
    for (AnyContact& contact : last_) {
        scale(contact.displacement, factor * factor);
        contact.impulse = contact.displacement;
        scale(contact.impulse, 1 / (share * h));
        list_particles(cloths, contact);
    }
}

template <class AnyContact>
void WarmStart<AnyContact>::before_step(std::span<const ClothInContact> cloths, std::span<Ball> balls) const {
    if (is_explicit_) return;
    Velocities velocities(cloths, balls);
    BallDisplacements displacements{balls};
    for (const AnyContact& contact : last_) {
        push_apart(velocities, contact, before_ * push_along(contact.impulse, contact.normal));
        displace_ball(displacements, contact);
    }
}

template <class AnyContact>
void WarmStart<AnyContact>::after_step(std::span<const ClothInContact> cloths, std::span<Ball> balls) const {
    if (before_ == 1) return;
    Velocities velocities(cloths, balls);
    Displacements displacements(cloths, balls);
    for (const AnyContact& contact : last_) {
        push_apart(velocities, contact, (1 - before_) * push_along(contact.impulse, contact.normal));
        if (is_explicit_) push_apart(displacements, contact, push_along(contact.displacement, contact.normal));
    }
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
            found->displacement = before.displacement;
            found->impulse = before.impulse;
            ++found;
        } else {
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
