#include "drape/contact/impact_zones.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "contact/advance.h"
#include "contact/tuning.h"
#include "drape/contact/closest_point.h"

namespace drape {
namespace {

/// The part of a distance that is not to become smaller at all: as little as rounding lets through.
constexpr Real hardly_nearer = 1 - 256 * std::numeric_limits<Real>::epsilon();

}  // namespace

Real FeatureMotion::distance_after(Real part) const {
    std::array<Vec3, 4> x;
    for (std::size_t k = 0; k < 4; ++k) x[k] = start[k] + part * displacement[k];
    if (first_count == 2) return closest_of_segments(x[0], x[1], x[2], x[3]).offset.norm();
    return (x[0] - closest_point_on_triangle(x[0], x[1], x[2], x[3]).point).norm();
}

Real FeatureMotion::max_approach() const {
    Real square = 0;
    const auto count = static_cast<std::size_t>(first_count);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = count; j < 4; ++j)
            square = std::max(square, (displacement[i] - displacement[j]).squaredNorm());
    }
    return std::sqrt(square);
}

Real safe_part_of(const FeatureMotion& motion, Real distance, Real least) {
    const Real of_distance = distance > least ? std::max(nearest_part, least / distance) : hardly_nearer;
    const Real nearest = std::min(of_distance, hardly_nearer) * distance;
    const Real meeting = nearest + std::min(margin_part * distance, (distance - nearest) / 2);
    const Real approach = motion.max_approach();
    if (approach <= distance - meeting) return 1;
    const auto measure = [&](Real part) -> Advance {
        const Real left = part > 0 ? motion.distance_after(part) : distance;
        return {left, part + (left - nearest) / approach};
    };
    return first_time(measure, meeting).value_or(1);
}

/// Of its k-th particle; -1: none.
int ImpactZones::zone_of(const NearPair& pair, std::size_t k) const {
    return zone_of_[number_of({pair.features.cloth_of(k), pair.features.particles[k]})];
}

/// @param freely as its particles would have moved, not as they are to move now
FeatureMotion ImpactZones::motion_of(const NearPair& pair, bool freely) const {
    FeatureMotion motion{.first_count = pair.features.first_count};
    for (std::size_t k = 0; k < 4; ++k) {
        const int cloth = pair.features.cloth_of(k), particle = pair.features.particles[k];
        const Points& end = freely ? free_state_of(cloth).x : cloth_of(cloth).state.x;
        motion.start[k] = position(cloth_of(cloth).before, particle);
        motion.displacement[k] = position(end, particle) - motion.start[k];
    }
    return motion;
}

/// Whether all of its particles are in one zone, or none is in any.
bool ImpactZones::keeps_together(const NearPair& pair) const {
    const int zone = zone_of(pair, 0);
    return zone_of(pair, 1) == zone && zone_of(pair, 2) == zone && zone_of(pair, 3) == zone;
}

/// All particles of a pair, and of the zones that they are in, become one zone: the largest of these.
void ImpactZones::join(const NearPair& pair, Real part) {
    const auto size_of = [&](int zone) { return zone < 0 ? 0 : zones_[static_cast<std::size_t>(zone)].members.size(); };
    int all = -1;
    for (std::size_t k = 0; k < 4; ++k) {
        if (size_of(zone_of(pair, k)) > size_of(all)) all = zone_of(pair, k);
    }
    if (all < 0) {
        all = static_cast<int>(zones_.size());
        zones_.emplace_back();
    }
    Zone& zone = zones_[static_cast<std::size_t>(all)];
    zone.part = std::min(zone.part, part);
    const auto take = [&](const Member& member) {
        zone_of_[number_of(member)] = all;
        zone.members.push_back(member);
    };
    for (std::size_t k = 0; k < 4; ++k) {
        const int other = zone_of(pair, k);
        if (other == all) continue;
        if (other < 0) {
            take({pair.features.cloth_of(k), pair.features.particles[k]});
            continue;
        }
        const Zone joined = std::exchange(zones_[static_cast<std::size_t>(other)], {});
        zone.part = std::min(zone.part, joined.part);
        for (const Member& member : joined.members) take(member);
    }
}

/// The mean of own(member), by mass. Where there are pinned ones, what the slowest of them has: a pin stays, and one
/// that the hand leads may be held back.
template <class Own>
Vec3 ImpactZones::mean(const Zone& zone, Own own) const {
    Vec3 sum = Vec3::Zero();
    Real mass = 0;
    std::optional<Vec3> of_pinned;
    for (const Member& member : zone.members) {
        const ClothModel& model = cloth_of(member.cloth).model;
        const Vec3 value = own(member);
        if (!model.pinned(member.particle)) {
            sum += model.particle_mass * value;
            mass += model.particle_mass;
        } else if (!of_pinned || value.squaredNorm() < of_pinned->squaredNorm()) {
            of_pinned = value;
        }
    }
    return of_pinned ? *of_pinned : Vec3(sum / mass);
}

void ImpactZones::move_zones() const {
    const auto displacement_of = [&](const Member& m) -> Vec3 {
        return position(free_state_of(m.cloth).x, m.particle) - position(cloth_of(m.cloth).before, m.particle);
    };
    const auto velocity_of = [&](const Member& m) { return position(free_state_of(m.cloth).v, m.particle); };
    for (const Zone& zone : zones_) {
        if (zone.members.empty()) continue;
        const Vec3 displacement = mean(zone, displacement_of), velocity = mean(zone, velocity_of);
        for (const Member& member : zone.members) {
            const ClothInContact& cloth = cloth_of(member.cloth);
            const Vec3 own = displacement_of(member), own_velocity = velocity_of(member);
            cloth.state.x.row(member.particle) =
                cloth.before.row(member.particle) + (displacement + zone.part * (own - displacement)).transpose();
            cloth.state.v.row(member.particle) = (velocity + zone.part * (own_velocity - velocity)).transpose();
        }
    }
}

/// A pair without any distance has met already.
bool ImpactZones::find(std::span<const NearPair> pairs, std::span<const ClothInContact> cloths,
                       std::span<const std::size_t> first, Real least) {
    least_ = least;
    cloths_ = cloths;
    first_ = first;
    zone_of_.assign(first.back(), -1);
    zones_.clear();
    for (const NearPair& pair : pairs) {
        if (pair.distance == 0) continue;
        const Real part = safe_part_of(motion_of(pair, false), pair.distance, least_);
        if (part < 1) join(pair, part);
    }
    if (zones_.empty()) return false;
    free_.resize(cloths.size());
    for (std::size_t c = 0; c < cloths.size(); ++c) free_[c] = cloths[c].state;
    return true;
}

/// Within a zone only that part of the motion is made in which no pair of it meets, whatever its other particles do.
void ImpactZones::prevent_crossing(std::span<const NearPair> pairs) {
    for (bool meets = true; meets;) {
        move_zones();
        meets = false;
        for (const NearPair& pair : pairs) {
            if (pair.distance == 0 || keeps_together(pair)) continue;
            if (safe_part_of(motion_of(pair, false), pair.distance, least_) == 1) continue;
            join(pair, safe_part_of(motion_of(pair, true), pair.distance, least_));
            meets = true;
        }
    }
}

std::int64_t ImpactZones::particles() const {
    std::int64_t count = 0;
    for (const Zone& zone : zones_) count += static_cast<std::int64_t>(zone.members.size());
    return count;
}

}  // namespace drape
