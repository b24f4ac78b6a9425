#include "drape/contact/motion_bounds.h"

#include <algorithm>

namespace drape {

BoundedMotion& BoundedMotion::operator+=(const BoundedMotion& other) {
    particles += other.particles;
    longest = std::max(longest, other.longest);
    energy += other.energy;
    momentum += other.momentum;
    return *this;
}

void MotionBounds::start(std::span<const int> particles, std::span<const Real> reaches) {
    first_.clear();
    std::size_t all = 0;
    for (const int count : particles) {
        first_.push_back(all);
        all += static_cast<std::size_t>(count);
    }
    reaches_ = reaches;
    bounds_.resize(all);
    std::ranges::transform(reaches, bounds_.begin(), [](Real reach) { return share * reach; });
}

/// Of the k-th particle of a pair, among all.
std::size_t MotionBounds::number_of(const NearPair& pair, std::size_t k) const {
    return first_[static_cast<std::size_t>(pair.features.cloth_of(k))] +
           static_cast<std::size_t>(pair.features.particles[k]);
}

/// A pair at distance 0 has no bound: it has met already.
void MotionBounds::tighten(const NearPair& pair) {
    if (pair.distance == 0) return;
    std::array<Real, 2> reach{};
    for (std::size_t k = 0; k < 4; ++k) {
        Real& of_feature = reach[pair.features.feature_of(k)];
        of_feature = std::max(of_feature, reaches_[number_of(pair, k)]);
    }
    for (std::size_t k = 0; k < 4; ++k) {
        Real& bound = bounds_[number_of(pair, k)];
        bound = std::min(bound, share * pair.distance * reach[pair.features.feature_of(k)] / (reach[0] + reach[1]));
    }
}

BoundedMotion MotionBounds::hold_back(int cloth, const ClothModel& model, const Points& before,
                                      ClothState& state) const {
    BoundedMotion held;
    const std::size_t first = first_[static_cast<std::size_t>(cloth)];
    for (int p = 0; p < model.grid.particles(); ++p) {
        const Real bound = bounds_[first + static_cast<std::size_t>(p)];
        const Vec3 way = (state.x.row(p) - before.row(p)).transpose();
        const Real length = way.norm();
        if (!(length > bound)) continue;
        const Real kept = bound / length;
        const Vec3 velocity = state.v.row(p).transpose();
        state.x.row(p) = before.row(p) + kept * way.transpose();
        state.v.row(p) = kept * velocity.transpose();
        ++held.particles;
        held.longest = std::max(held.longest, length - bound);
        held.energy += static_cast<double>(model.particle_mass / 2 * (1 - kept * kept) * velocity.squaredNorm());
        held.momentum += model.particle_mass * (1 - kept) * velocity;
    }
    return held;
}

}  // namespace drape
