#include "drape/contact/impact_zones.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/advance.h"
#include "contact/tuning.h"
#include "drape/contact/closest_point.h"

namespace drape {
namespace {

/// The part of a distance that is not to become smaller at all: as little as rounding lets through.
constexpr Real hardly_nearer = 1 - 256 * std::numeric_limits<Real>::epsilon();

Vec3 displacement_of(const ClothInContact& cloth, int particle) {
    return position(cloth.state.x, particle) - position(cloth.before, particle);
}

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

std::size_t ImpactZones::number_of(int cloth, int particle) const {
    return first_[static_cast<std::size_t>(cloth)] + static_cast<std::size_t>(particle);
}

/// Of its k-th particle; -1: none.
int ImpactZones::zone_of(const NearPair& pair, std::size_t k) const {
    return zone_of_[number_of(pair.features.cloth_of(k), pair.features.particles[k])];
}

/// As its particles are to move now.
FeatureMotion ImpactZones::motion_of(const NearPair& pair) const {
    FeatureMotion motion{.first_count = pair.features.first_count};
    for (std::size_t k = 0; k < 4; ++k) {
        const ClothInContact& cloth = cloth_of(pair.features.cloth_of(k));
        motion.start[k] = position(cloth.before, pair.features.particles[k]);
        motion.displacement[k] = displacement_of(cloth, pair.features.particles[k]);
    }
    return motion;
}

/// As they would have moved.
FeatureMotion ImpactZones::free_motion_of(const NearPair& pair) const {
    FeatureMotion motion = motion_of(pair);
    for (std::size_t k = 0; k < 4; ++k) {
        const int zone = zone_of(pair, k);
        if (zone < 0) continue;
        const std::size_t number = number_of(pair.features.cloth_of(k), pair.features.particles[k]);
        const std::vector<Member>& members = zones_[static_cast<std::size_t>(zone)].members;
        motion.displacement[k] = members[static_cast<std::size_t>(place_in_[number])].displacement;
    }
    return motion;
}

bool ImpactZones::within_one_zone(const NearPair& pair) const {
    const int zone = zone_of(pair, 0);
    for (std::size_t k = 1; k < 4; ++k) {
        if (zone_of(pair, k) != zone) return false;
    }
    return zone >= 0;
}

/// Of those that a pair's particles are in; -1: none.
int ImpactZones::largest_zone_of(const NearPair& pair) const {
    const auto size_of = [&](int zone) { return zone < 0 ? 0 : zones_[static_cast<std::size_t>(zone)].members.size(); };
    int largest = -1;
    for (std::size_t k = 0; k < 4; ++k)
        largest = std::max(largest, zone_of(pair, k), [&](int a, int b) { return size_of(a) < size_of(b); });
    return largest;
}

void ImpactZones::add(int zone, const Member& member) {
    std::vector<Member>& members = zones_[static_cast<std::size_t>(zone)].members;
    const std::size_t number = number_of(member.cloth, member.particle);
    zone_of_[number] = zone;
    place_in_[number] = static_cast<int>(members.size());
    members.push_back(member);
}

/// All particles of a pair, and of the zones that they are in, become one zone.
void ImpactZones::join(const NearPair& pair, Real part) {
    int all = largest_zone_of(pair);
    if (all < 0) {
        all = static_cast<int>(zones_.size());
        zones_.emplace_back();
    }
    Zone& zone = zones_[static_cast<std::size_t>(all)];
    zone.part = std::min(zone.part, part);
    for (std::size_t k = 0; k < 4; ++k) {
        const int number = pair.features.cloth_of(k), particle = pair.features.particles[k];
        const int other = zone_of(pair, k);
        if (other == all) continue;
        if (other < 0) {
            const ClothInContact& cloth = cloth_of(number);
            add(all, {number, particle, displacement_of(cloth, particle), position(cloth.state.v, particle)});
            continue;
        }
        Zone& joined = zones_[static_cast<std::size_t>(other)];
        zone.part = std::min(zone.part, joined.part);
        for (const Member& member : std::exchange(joined.members, {})) add(all, member);
    }
}

/// The mean of what the members of a zone have, by mass. Where there are pinned ones, what the slowest of them has: a
/// pin stays, and one that the hand leads may be held back.
Vec3 ImpactZones::mean(const Zone& zone, Vec3 Member::*value) const {
    Vec3 sum = Vec3::Zero();
    Real mass = 0;
    const Vec3* of_pinned = nullptr;
    for (const Member& member : zone.members) {
        const ClothModel& model = cloth_of(member.cloth).model;
        const Vec3& own = member.*value;
        if (!model.pinned(member.particle)) {
            sum += model.particle_mass * own;
            mass += model.particle_mass;
        } else if (!of_pinned || own.squaredNorm() < of_pinned->squaredNorm()) {
            of_pinned = &own;
        }
    }
    return of_pinned ? *of_pinned : Vec3(sum / mass);
}

void ImpactZones::move_zones() const {
    for (const Zone& zone : zones_) {
        if (zone.members.empty()) continue;
        const Vec3 displacement = mean(zone, &Member::displacement), velocity = mean(zone, &Member::velocity);
        for (const Member& member : zone.members) {
            const ClothInContact& cloth = cloth_of(member.cloth);
            cloth.state.x.row(member.particle) =
                cloth.before.row(member.particle) +
                (displacement + zone.part * (member.displacement - displacement)).transpose();
            cloth.state.v.row(member.particle) = (velocity + zone.part * (member.velocity - velocity)).transpose();
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
    place_in_.resize(first.back());
    zones_.clear();
    for (const NearPair& pair : pairs) {
        if (pair.distance == 0) continue;
        const Real part = safe_part_of(free_motion_of(pair), pair.distance, least_);
        if (part < 1) join(pair, part);
    }
    return !zones_.empty();
}

/// Within a zone only that part of the motion is made in which no pair of it meets, whatever its other particles do.
void ImpactZones::prevent_crossing(std::span<const NearPair> pairs) {
    for (bool meets = true; meets;) {
        move_zones();
        meets = false;
        for (const NearPair& pair : pairs) {
            if (pair.distance == 0 || largest_zone_of(pair) < 0 || within_one_zone(pair)) continue;
            if (safe_part_of(motion_of(pair), pair.distance, least_) == 1) continue;
            join(pair, safe_part_of(free_motion_of(pair), pair.distance, least_));
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
