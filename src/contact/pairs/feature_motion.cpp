#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/advance.h"
#include "contact/tuning.h"
#include "drape/contact/closest_point.h"
#include "drape/contact/impact_zones.h"

namespace drape {
namespace {

/// The same of a distance that is not to become smaller at all: as little as rounding lets through.
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

}  // namespace drape
