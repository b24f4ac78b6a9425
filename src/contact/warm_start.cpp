#include "drape/contact/warm_start.h"

#include <tuple>

#include "contact_motion.h"
#include "drape/integrate/stability.h"

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

void scale(ContactPush& push, Real factor) {
    push.normal *= factor;
    push.friction *= factor;
}

Vec3 push_along(const ContactPush& push, const Vec3& normal) { return push.normal * normal + push.friction; }

/// Where a contact of before is now, its depth less than zero if it has parted. Its normal stays, for the ball may have
/// come through the cloth since.
void follow_contact(const ResponseParameters& parameters, const Points& x, std::span<const Ball> balls,
                    Contact& contact) {
    contact.point = at_point(contact, x);
    contact.of_impact = contact.ball != the_ground;
    contact.depth = depth_now(parameters, balls, contact);
}

}  // namespace

void WarmStart::take(const ResponseParameters& parameters, Real h, const ClothModel& model,
                     std::vector<Contact>& contacts) {
    last_.clear();
    const Real h_before = h_ > 0 ? h_ : h, factor = h / h_before,
               share = parameters.kind == ResponseKind::Impulse ? displacement_share(parameters.integrator) : Real(1);
    h_ = h;
    if (!solves_for_pushes(parameters.kind)) return;
    is_explicit_ = has_step_limit(parameters.integrator);
    before_ = is_explicit_ ? Real(0) : share;
    for (Contact& contact : contacts) {
        if (!rests(contact, h_before, model.gravity.norm())) continue;
        scale(contact.displacement, factor * factor);
        contact.impulse = contact.displacement;
        scale(contact.impulse, 1 / (share * h));
        last_.push_back(contact);
    }
    contacts.clear();
}

void WarmStart::before_step(const ClothModel& model, std::span<Ball> balls, ClothState& state) const {
    if (is_explicit_) return;
    Velocities velocities{model, state.v, balls};
    Displacements displacements{model, state.x, balls};
    for (const Contact& contact : last_) {
        push_apart(velocities, contact, before_ * push_along(contact.impulse, contact.normal));
        displacements.push_ball(contact.ball, contact.normal, -push_along(contact.displacement, contact.normal));
    }
}

void WarmStart::after_step(const ClothModel& model, std::span<Ball> balls, ClothState& state) const {
    if (before_ == 1) return;
    Velocities velocities{model, state.v, balls};
    Displacements displacements{model, state.x, balls};
    for (const Contact& contact : last_) {
        push_apart(velocities, contact, (1 - before_) * push_along(contact.impulse, contact.normal));
        if (is_explicit_) push_apart(displacements, contact, push_along(contact.displacement, contact.normal));
    }
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
            found->impulse = before.impulse;
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
