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

void MotionBounds::start(std::span<const int> particles, Real margin) {
    first_.clear();
    std::size_t all = 0;
    for (const int count : particles) {
        first_.push_back(all);
        all += static_cast<std::size_t>(count);
    }
    bounds_.assign(all, share * margin / 2);
}

/// What begins in one place has met already.
void MotionBounds::tighten(const NearPair& pair) {
    if (pair.distance == 0) return;
    const auto& [cloths, first_count, particles] = pair.features;
    for (int k = 0; k < 4; ++k) {
        const int cloth = cloths[k < first_count ? 0 : 1], particle = particles[static_cast<std::size_t>(k)];
        Real& bound = bounds_[first_[static_cast<std::size_t>(cloth)] + static_cast<std::size_t>(particle)];
        bound = std::min(bound, share * pair.distance / 2);
    }
}

BoundedMotion MotionBounds::hold_back(int cloth, const ClothModel& model, const Points& before,
                                      ClothState& state) const {
    BoundedMotion lost;
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
        ++lost.particles;
        lost.longest = std::max(lost.longest, length - bound);
        lost.energy += static_cast<double>(model.particle_mass / 2 * (1 - kept * kept) * velocity.squaredNorm());
        lost.momentum += model.particle_mass * (1 - kept) * velocity;
    }
    return lost;
}

}  // namespace drape
