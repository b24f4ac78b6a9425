#include "drape/contact/feature_motion.h"

#include <algorithm>
#include <cmath>

#include "drape/contact/closest_point.h"
#include "drape/contact/segments.h"

namespace drape {
namespace {

/// Of the distance at the start: less than this is a meeting, and nothing comes nearer than that.
constexpr Real meeting = Real(0.2), nearest = Real(0.1);

/// Features that still creep along each other after so many rounds are stopped where they are.
constexpr int most_advances = 400;

}  // namespace

Real FeatureMotion::distance_after(Real part) const {
    std::array<Vec3, 4> x;
    for (std::size_t k = 0; k < 4; ++k) x[k] = start[k] + part * way[k];
    if (first_count == 2) return closest_of_segments(x[0], x[1], x[2], x[3]).offset.norm();
    return (x[0] - closest_point_on_triangle(x[0], x[1], x[2], x[3]).point).norm();
}

Real FeatureMotion::longest_approach() const {
    Real square = 0;
    const auto count = static_cast<std::size_t>(first_count);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = count; j < 4; ++j) square = std::max(square, (way[i] - way[j]).squaredNorm());
    }
    return std::sqrt(square);
}

Real safe_part_of(const FeatureMotion& motion, Real distance) {
    const Real approach = motion.longest_approach();
    Real part = 0, left = distance;
    for (int round = 0; round < most_advances; ++round) {
        if ((1 - part) * approach <= left - meeting * distance) return 1;
        part += (left - nearest * distance) / approach;
        if (part >= 1) part = 1;
        left = motion.distance_after(part);
        if (left < meeting * distance) return part;
        if (part == 1) return 1;
    }
    return part;
}

}  // namespace drape
