#include <algorithm>

#include "contact_geometry.h"
#include "drape/bounds/aabb.h"
#include "drape/contact/impact.h"

namespace drape {
namespace {

/// The box about both ends of the step of two particles, one above the other in the grid.
Aabb swept_column(const Grid& grid, const Points& from, const Points& to, int particle) {
    const Vec3 first = position(from, particle);
    Aabb box{first, first};
    for (const int below : {particle, particle + grid.nx}) {
        box.include(position(from, below));
        box.include(position(to, below));
    }
    return box;
}

void impacts_of_cell(const Grid& grid, const Points& from, const Points& to, const SweptBall& ball, int cell,
                     std::vector<TriangleImpact>& impacts) {
    for (const int triangle : {2 * cell, 2 * cell + 1}) {
        const std::array<int, 3> corners = grid.triangle_corners(triangle);
        const auto [a, b, c] = corners;
        const auto impact = first_impact(ball, {position(from, a), position(from, b), position(from, c)},
                                         {position(to, a), position(to, b), position(to, c)});
        if (impact) impacts.push_back({triangle, corners, *impact});
    }
}

}  // namespace

void find_impacts(const Grid& grid, const Points& from, const Points& to, const SweptBall& ball,
                  std::span<const CellRun> cells, std::vector<TriangleImpact>& impacts) {
    for (const CellRun& run : cells) {
        const int first = grid.particle(run.column, run.row);
        Aabb left = swept_column(grid, from, to, first);
        for (int k = 0; k < run.count; ++k) {
            const Aabb right = swept_column(grid, from, to, first + k + 1);
            Aabb box = left;
            box.include(right);
            left = right;
            if (!box.overlaps(ball)) continue;
            impacts_of_cell(grid, from, to, ball, run.row * grid.cell_columns() + run.column + k, impacts);
        }
    }
}

}  // namespace drape
