#include "drape/contact/contact_activity.h"

namespace drape {

void ContactActivity::begin(std::span<const ClothInContact> cloths, std::span<const Ball> balls) {
    entries_.clear();
    balls_ = balls;
    first_.clear();
    std::size_t count = 1 + balls.size();
    for (const ClothInContact& cloth : cloths) {
        first_.push_back(static_cast<int>(count));
        count += static_cast<std::size_t>(cloth.state.x.rows());
    }
    // What earlier solves have left there is no later than the present
    if (last_push_.size() < count) last_push_.resize(count);
}

/// 0 for what nothing pushes.
int ContactActivity::number_of_ball(int ball) const {
    const bool is_free = !is_plane(ball) && balls_[static_cast<std::size_t>(ball)].inverse_mass > 0;
    return is_free ? 1 + ball : 0;
}

void ContactActivity::add_particles(const ContactPlane& contact, Entry& entry) const {
    std::size_t k = 0;
    for (const PushedParticle& p : contact.pushed()) {
        if (p.share != 0) entry.pushed[k++] = first_[static_cast<std::size_t>(p.cloth)] + p.particle;
    }
}

void ContactActivity::add(const Contact& contact) {
    Entry& entry = entries_.emplace_back(Entry{.last_solved = now_});
    add_particles(contact, entry);
    entry.pushed[3] = number_of_ball(contact.ball);
}

void ContactActivity::add(const PairContact& contact) {
    add_particles(contact, entries_.emplace_back(Entry{.last_solved = now_}));
}

void ContactActivity::add(const BallContact& contact) {
    entries_.push_back({{number_of_ball(contact.first), number_of_ball(contact.ball)}, now_});
}

}  // namespace drape
