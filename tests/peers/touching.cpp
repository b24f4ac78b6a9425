#include "touching.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/contact/closest_point.h"

namespace drape::peers {
namespace {

Vec3 offset(const Points& x, const std::array<int, 3>& corners, const Vec3& p) {
    const auto at = [&x](int particle) -> Vec3 { return x.row(particle).transpose(); };
    return closest_point_on_triangle(p, at(corners[0]), at(corners[1]), at(corners[2])).point - p;
}

}  // namespace

void keep_touched(const Grid& grid, const Points& x, const Ball& ball, std::vector<int>& triangles) {
    const Vec3& p = ball.centre;
    const Real square = ball.radius * ball.radius;
    const Real *const xs = x.col(0).data(), *const ys = x.col(1).data(), *const zs = x.col(2).data();
    std::erase_if(triangles, [&](int triangle) {
        const auto corners = grid.triangle_corners(triangle);
        for (const int c : corners) {
            const Real dx = xs[c] - p[0], dy = ys[c] - p[1], dz = zs[c] - p[2];
            if (dx * dx + dy * dy + dz * dz <= square) return false;
        }
        return offset(x, corners, p).squaredNorm() > square;
    });
}

int count_ties(const Grid& grid, const Points& x, const Ball& ball, std::span<const int> expected,
               std::span<const int> found) {
    std::vector<int> different;
    std::ranges::set_symmetric_difference(expected, found, std::back_inserter(different));
    const Real rounding = 16 * std::numeric_limits<Real>::epsilon() * (ball.centre.cwiseAbs().sum() + ball.radius);
    for (const int triangle : different) {
        const Real gap = offset(x, grid.triangle_corners(triangle), ball.centre).norm() - ball.radius;
        if (std::abs(gap) <= rounding) continue;
        throw RunError("triangle " + std::to_string(triangle) + ", " + real_text(static_cast<double>(gap), 3) +
                       " m off the ball's surface, is in one of the sets only (found " + std::to_string(found.size()) +
                       " triangles, brute force " + std::to_string(expected.size()) + ")");
    }
    return static_cast<int>(different.size());
}

}  // namespace drape::peers
