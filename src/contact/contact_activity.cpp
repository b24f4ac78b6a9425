#include "drape/contact/contact_activity.h"

#include <algorithm>

#include "contact_geometry.h"

namespace drape {

void ContactActivity::begin(std::span<const ClothInContact> cloths, std::span<const Ball> balls) {
    entries_.clear();
    balls_ = balls;
    first_.clear();
    std::size_t bodies = 1 + balls.size();
    for (const ClothInContact& cloth : cloths) {
        first_.push_back(static_cast<int>(bodies));
        bodies += static_cast<std::size_t>(cloth.state.x.rows());
    }
    // What earlier solves have left is older than anything to come
    if (pushed_.size() < bodies) pushed_.resize(bodies);
}

/// 0 for what nothing pushes.
int ContactActivity::number_of_ball(int ball) const {
    const bool is_free = !is_plane(ball) && balls_[static_cast<std::size_t>(ball)].inverse_mass > 0;
    return is_free ? 1 + ball : 0;
}

void ContactActivity::add_particles(const ContactPlane& contact, Entry& entry) const {
    std::size_t k = 0;
    for (const PushedParticle& p : contact.pushed()) {
        entry.bodies[k++] = first_[static_cast<std::size_t>(p.cloth)] + p.particle;
    }
}

void ContactActivity::add(const Contact& contact) {
    Entry& entry = entries_.emplace_back(Entry{.solved = now_});
    add_particles(contact, entry);
    entry.bodies[3] = number_of_ball(contact.ball);
}

void ContactActivity::add(const PairContact& contact) {
    add_particles(contact, entries_.emplace_back(Entry{.solved = now_}));
}

void ContactActivity::add(const BallContact& contact) {
    entries_.push_back({{number_of_ball(contact.first), number_of_ball(contact.ball)}, now_});
}

}  // namespace drape
