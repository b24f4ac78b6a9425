#include "drape/contact/warm_start.h"

#include <tuple>

#include "contact_motion.h"

namespace drape {
namespace {

bool solves_for_pushes(ResponseKind kind) { return kind == ResponseKind::Projection || kind == ResponseKind::Impulse; }

/// Contacts are found in this order: by ball, then by triangle with its particles first; on the ground, which comes
/// last, by particle.
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

/// What changes a speed by more than gravity does in this many steps is no rest: an impact, or the way out of a ball
/// that was put into the cloth.
constexpr Real rest_steps = 100;

bool rests(const Contact& contact, Real h, Real gravity) {
    const Real speed = contact.displacement.normal * contact.inverse_mass / h;
    return !contact.of_node && !contact.of_impact && speed > 0 && speed <= rest_steps * h * gravity;
}

/// Where a contact of before is now, its depth less than zero if it has parted. Its normal stays, for the ball may have
/// come through the cloth since.
void follow_contact(const ResponseParameters& parameters, const Points& x, std::span<const Ball> balls,
                    Contact& contact) {
    contact.point = at_point(contact, x);
    contact.of_impact = contact.ball != the_ground;
    contact.depth = depth_now(parameters, balls, contact);
}

}  // namespace

void WarmStart::give(const ResponseParameters& parameters, Real h, const ClothModel& model,
                     std::vector<Contact>& contacts, std::span<Ball> balls, ClothState& state, bool displaces) {
    last_.clear();
    const Real h_before = h_ > 0 ? h_ : h, scale = h / h_before;
    h_ = h;
    if (!solves_for_pushes(parameters.kind)) return;
    Velocities velocities{model, state.v, balls};
    Displacements displacements{model, state.x, balls};
    for (Contact& contact : contacts) {
        if (!rests(contact, h_before, model.gravity.norm())) continue;
        contact.displacement.normal *= scale * scale;
        contact.displacement.friction *= scale * scale;
        const Vec3 push = contact.displacement.normal * contact.normal + contact.displacement.friction;
        push_apart(velocities, contact, push / h);
        if (displaces) push_apart(displacements, contact, push);
        last_.push_back(contact);
    }
    contacts.clear();
}

void WarmStart::carry_over(const ResponseParameters& parameters, const Points& x, std::span<const Ball> balls,
                           std::vector<Contact>& contacts) {
    if (last_.empty()) return;
    merged_.clear();
    auto found = contacts.begin();
    for (Contact& before : last_) {
        const auto order = order_of(before);
        while (found != contacts.end() && order_of(*found) < order) merged_.push_back(*found++);
        if (found != contacts.end() && order_of(*found) == order) {
            found->displacement = before.displacement;
            merged_.push_back(*found++);
        } else {
            follow_contact(parameters, x, balls, before);
            merged_.push_back(before);
        }
    }
    merged_.insert(merged_.end(), found, contacts.end());
    contacts.swap(merged_);
}

}  // namespace drape
