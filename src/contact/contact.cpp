#include "drape/contact/contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact_geometry.h"
#include "drape/base/vectorise.h"
#include "drape/contact/closest_point.h"

namespace drape {

namespace {

/// True if a cell's corners tell that both its triangles are farther from p than `reach`. For a point of a triangle
/// with weights w_i, |p - sum w_i v_i|^2 = sum w_i |p - v_i|^2 - sum_{i<j} w_i w_j |v_i - v_j|^2 (Leibniz), which is at
/// least the smallest |p - v_i|^2 less a third of the longest edge squared.
DRAPE_INLINE bool is_far(const Grid& grid, const Points& x, int cell, const Vec3& p, Real reach) {
    const int at = grid.cell_corner(cell);
    const Vec3 a = position(x, at), b = position(x, at + 1), c = position(x, at + grid.nx),
               d = position(x, at + grid.nx + 1);
    const Real nearest = std::min(std::min((a - p).squaredNorm(), (b - p).squaredNorm()),
                                  std::min((c - p).squaredNorm(), (d - p).squaredNorm()));
    const Real sides = std::max(std::max((a - b).squaredNorm(), (a - c).squaredNorm()),
                                std::max((d - b).squaredNorm(), (d - c).squaredNorm()));
    const Real longest = std::max(sides, (b - c).squaredNorm());
    constexpr Real rounding = 32 * std::numeric_limits<Real>::epsilon();
    return nearest * (1 - rounding) - longest * (1 + rounding) / 3 > reach * reach;
}

}  // namespace

void find_touched_triangles(const Grid& grid, const Points& x, const Ball& ball, Real thickness,
                            std::span<const int> cells, std::vector<int>& triangles) {
    triangles.clear();
    const Real reach = ball.radius + thickness;
    const auto inside = [&](int p) { return (position(x, p) - ball.centre).squaredNorm() <= reach * reach; };
    for (const int cell : cells) {
        if (is_far(grid, x, cell, ball.centre, reach)) continue;
        const int a = grid.cell_corner(cell);
        const int corners[4] = {a, a + 1, a + grid.nx, a + grid.nx + 1};

        // A corner in the ball decides for its triangles; only the others need their closest point
        const bool in_a = inside(corners[0]), in_b = inside(corners[1]), in_c = inside(corners[2]),
                   in_d = inside(corners[3]);
        const auto touches = [&](int triangle) {
            return (closest_point(x, grid.triangle_corners(triangle), ball.centre).point - ball.centre).squaredNorm() <=
                   reach * reach;
        };
        if (in_a || in_b || in_c || touches(2 * cell)) triangles.push_back(2 * cell);
        if (in_b || in_c || in_d || touches(2 * cell + 1)) triangles.push_back(2 * cell + 1);
    }
}

void find_contacts(const Grid& grid, const Points& x, const Ball& ball, int ball_number, Real thickness,
                   std::span<const int> cells, std::vector<Contact>& contacts) {
    Contact contact{.ball = ball_number};
    for (const int cell : cells) {
        if (is_far(grid, x, cell, ball.centre, ball.radius + thickness)) continue;
        for (const int triangle : {2 * cell, 2 * cell + 1}) {
            contact.triangle = triangle;
            contact.corners = grid.triangle_corners(triangle);
            if (locate(x, ball, thickness, contact)) contacts.push_back(contact);
        }
    }
}

}  // namespace drape
