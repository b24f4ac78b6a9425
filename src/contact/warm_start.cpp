#include "drape/contact/warm_start.h"

#include <algorithm>
#include <tuple>

#include "contact_motion.h"
#include "resting.h"

namespace drape {
namespace {

bool solves_for_pushes(ResponseKind kind) { return kind == ResponseKind::Projection || kind == ResponseKind::Impulse; }

/// Contacts are found in this order: by ball, then by solid, in each by triangle with its particles first; on the
/// ground, which comes last, by particle.
std::tuple<unsigned, int, int> order_of(const Contact& contact) {
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

bool is_of_surface(const Contact& contact) { return !contact.of_node && !contact.separated; }
bool is_of_surface(const PairContact& /*contact*/) { return true; }

/// Whether it pushes a free ball too. Such a contact is kept with a push of zero, to be told that it lasts.
bool moves_both(const ContactPlane& contact) { return min_inverse_mass(contact) < contact.inverse_mass; }

void scale(ContactPush& push, Real factor) {
    push.normal *= factor;
    push.friction *= factor;
}

Vec3 push_along(const ContactPush& push, const Vec3& normal) { return push.normal * normal + push.friction; }

/// Where a contact of before is now, its depth less than zero if it has parted. Its normal stays, for the ball may have
/// come through the cloth since; a solid has moved on as it did. It is kept for this substep alone.
void follow_contact(const ResponseParameters& parameters, std::span<const ClothInContact> cloths,
                    std::span<const Ball> balls, Contact& contact) {
    contact.point = at_point(contact, cloths[static_cast<std::size_t>(contact.cloth)].state.x);
    contact.separated = true;
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

}  // namespace

template <class AnyContact>
void WarmStart<AnyContact>::take(const ResponseParameters& parameters, Real h, Real gravity,
                                 std::span<const ClothInContact> cloths, std::vector<AnyContact>& contacts) {
    last_.clear();
    const Real h_before = h_ > 0 ? h_ : h, factor = h / h_before, share = parameters.displacement_share;
    h_ = h;
    const bool ground_is_gone = !parameters.ground.solid || parameters.ground.height < ground_height_;
    ground_height_ = parameters.ground.height;
    has_pushes_ = solves_for_pushes(parameters.kind);
    if (!has_pushes_) {
        if (parameters.kind == ResponseKind::Hybrid && !ground_is_gone) keep_without_pushes(contacts);
        return;
    }
    last_.swap(contacts);
    const auto may_be_given = [&](const AnyContact& contact, Real impulse) {
        return may_rest(contact, impulse, h_before, gravity);
    };
    const auto rests = [&](const AnyContact& contact) {
        return may_be_given(contact, contact.displacement.normal / (share * h_before));
    };
    std::erase_if(last_, [&](const AnyContact& contact) {
        if (!is_of_surface(contact) || contact.displacement.normal == 0) return true;
        if (ground_is_gone && is_on_ground(contact)) return true;
        return !rests(contact) && !moves_both(contact);
    });
    for (AnyContact& contact : last_) {
        const bool rested = rests(contact), stopped_gently = may_be_given(contact, contact.impulse.normal);
        scale(contact.displacement, rested ? factor * factor : Real(0));
        scale(contact.impulse, rested && stopped_gently ? share * factor : Real(0));
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

/// Flat, because GCC would call a function for each sum of three numbers.
template <class AnyContact>
__attribute__((flatten)) void WarmStart<AnyContact>::give(std::span<const ClothInContact> cloths,
                                                          std::span<Ball> balls) const {
    Velocities velocities(cloths, balls);
    Displacements displacements(cloths, balls);
    for (const AnyContact& contact : pushes()) {
        push_apart(velocities, contact, push_along(contact.impulse, contact.normal));
        push_apart(displacements, contact, push_along(contact.displacement, contact.normal));
    }
}

template <class AnyContact>
double WarmStart<AnyContact>::work(std::span<const ClothInContact> cloths, int cloth) const {
    const ClothInContact& of = cloths[static_cast<std::size_t>(cloth)];
    Real work = 0;
    for (const AnyContact& contact : pushes()) {
        const Vec3 force = push_along(contact.impulse, contact.normal) / h_;
        for (const ContactParticle& p : contact.pushed()) {
            if (p.cloth != cloth || p.share == 0) continue;
            work += p.weight * force.dot(position(of.state.x, p.particle) - position(of.before, p.particle));
        }
    }
    return static_cast<double>(work);
}

template <class AnyContact>
void WarmStart<AnyContact>::carry_over(const ResponseParameters& parameters, std::span<const ClothInContact> cloths,
                                       std::span<const Ball> balls, std::vector<AnyContact>& contacts) {
    separated_.clear();
    gaps_.clear();
    auto found = contacts.begin();
    for (AnyContact& before : last_) {
        const auto order = order_of(before);
        while (found != contacts.end() && order_of(*found) < order) ++found;
        if (found != contacts.end() && order_of(*found) == order) {
            found->displacement = before.displacement;
            found->impulse = before.impulse;
            found->lasts = true;
            ++found;
        } else if (before.displacement.normal > 0) {
            follow_contact(parameters, cloths, balls, before);
            separated_.push_back(before);
            gaps_.push_back(found - contacts.begin());
        }
    }
    insert(contacts);
}

/// Those that have parted, from the last to the first: what is behind one moves by as many as there are up to it.
template <class AnyContact>
void WarmStart<AnyContact>::insert(std::vector<AnyContact>& contacts) const {
    auto end = static_cast<std::ptrdiff_t>(contacts.size());
    contacts.resize(contacts.size() + separated_.size());
    for (std::size_t k = separated_.size(); k-- > 0; end = gaps_[k]) {
        const auto begin = contacts.begin(), place = begin + gaps_[k] + static_cast<std::ptrdiff_t>(k);
        std::move_backward(begin + gaps_[k], begin + end, place + 1 + end - gaps_[k]);
        *place = separated_[k];
    }
}

template class WarmStart<Contact>;
template class WarmStart<PairContact>;

}  // namespace drape
