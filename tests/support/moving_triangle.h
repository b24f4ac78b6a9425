#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "drape/bounds/swept_ball.h"

namespace drape::test {

using Long3 = Eigen::Matrix<long double, 3, 1>;

/// A ball and a triangle, each moving evenly within a step, as plainly as can be, in long double.
class MovingTriangle {
public:
    MovingTriangle(const SweptBall& ball, const std::array<Vec3, 3>& from, const std::array<Vec3, 3>& to) {
        for (std::size_t k = 0; k < 3; ++k) {
            start_[k] = from[k].cast<long double>() - ball.start.cast<long double>();
            way_[k] = to[k].cast<long double>() - ball.end.cast<long double>() - start_[k];
            fastest_ = std::max(fastest_, way_[k].norm());
        }
    }

    [[nodiscard]] std::array<Long3, 3> at(long double t) const {
        return {start_[0] + t * way_[0], start_[1] + t * way_[1], start_[2] + t * way_[2]};
    }

    /// From the ball's centre.
    [[nodiscard]] long double distance(long double t) const {
        const auto [a, b, c] = at(t);
        const Long3 n = (b - a).cross(c - a);
        const long double sides = std::min({from_side(a, b), from_side(b, c), from_side(c, a)});
        const bool over = n.dot((b - a).cross(Long3(-a))) >= 0 && n.dot((c - b).cross(Long3(-b))) >= 0 &&
                          n.dot((a - c).cross(Long3(-c))) >= 0;
        if (!over || n.squaredNorm() == 0) return sides;
        return std::min(sides, std::abs(a.dot(n.normalized())));
    }

    /// Whether the distance falls to the radius at any time before `end`: no point of the triangle moves faster than
    /// the fastest corner, so that the distance at the middle of a stretch bounds it in all of it.
    [[nodiscard]] bool comes_within(long double radius, long double end, long double begin = 0) const {
        if (!(begin <= end)) return false;
        const long double middle = (begin + end) / 2, near = distance(middle);
        if (near <= radius) return true;
        if (near - fastest_ * (end - begin) / 2 > radius || end - begin < 1e-15L) return false;
        return comes_within(radius, middle, begin) || comes_within(radius, end, middle);
    }

private:
    static long double from_side(const Long3& a, const Long3& b) {
        const Long3 side = b - a;
        const long double square = side.squaredNorm();
        const long double w = square > 0 ? std::clamp(-a.dot(side) / square, 0.0L, 1.0L) : 0.0L;
        return (a + w * side).norm();
    }

    std::array<Long3, 3> start_, way_;
    long double fastest_ = 0;
};

}  // namespace drape::test
