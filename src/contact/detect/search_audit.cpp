#include <algorithm>

#include "contact/kernels/near_cells.h"
#include "drape/contact/closest_point.h"
#include "drape/contact/detection.h"

namespace drape {
namespace {

/// Calls visit(distance) for the triangles of some cells, but for those that are clearly farther from a point than a
/// radius.
template <class Visit>
void for_each_distance(const Grid& grid, const Points& x, const CellRange& cells, const Vec3& p, Real radius,
                       Visit visit) {
    kernels::for_each_near_cell(grid, x, p, radius, cells, [&](int cell) {
        for (const int triangle : {2 * cell, 2 * cell + 1}) {
            visit((closest_point(x, grid.triangle_corners(triangle), p).point - p).norm());
        }
    });
}

}  // namespace

std::int64_t count_false_contacts(const Grid& grid, const Points& x, const Ball& ball, Real thickness,
                                  std::span<const StoppedNode> nodes) {
    const Real radius = ball.radius + thickness;
    return std::ranges::count_if(nodes, [&](const StoppedNode& node) {
        bool touches = false;
        for_each_distance(grid, x, node, ball.centre, radius,
                          [&](Real distance) { touches = touches || distance <= radius; });
        const Real radii = radius + node.sphere.radius;
        return !touches && (node.sphere.centre - ball.centre).squaredNorm() < radii * radii;
    });
}

Real deepest_penetration(const Grid& grid, const Points& x, std::span<const Ball> balls, Real thickness) {
    Real deepest = 0;
    for (const Ball& ball : balls) {
        const Real radius = ball.radius + thickness;
        for_each_distance(grid, x, all_cells(grid), ball.centre, radius,
                          [&](Real distance) { deepest = std::max(deepest, radius - distance); });
    }
    return deepest;
}

}  // namespace drape
