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
    const auto& [cloths, first_count, particles] = pair.features;
    const int cloth = cloths[static_cast<int>(k) < first_count ? 0 : 1];
    return first_[static_cast<std::size_t>(cloth)] + static_cast<std::size_t>(particles[k]);
}

/// What begins in one place has met already.
void MotionBounds::tighten(const NearPair& pair) {
    if (pair.distance == 0) return;
    const auto is_second = [&](std::size_t k) { return static_cast<int>(k) < pair.features.first_count ? 0u : 1u; };
    std::array<Real, 2> reach{};
    for (std::size_t k = 0; k < 4; ++k) {
        reach[is_second(k)] = std::max(reach[is_second(k)], reaches_[number_of(pair, k)]);
    }
    for (std::size_t k = 0; k < 4; ++k) {
        Real& bound = bounds_[number_of(pair, k)];
        bound = std::min(bound, share * pair.distance * reach[is_second(k)] / (reach[0] + reach[1]));
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
