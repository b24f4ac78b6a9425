#include "drape/contact/detection.h"

#include <algorithm>

namespace drape {

SearchAudit::SearchAudit(const Grid& grid, Kernels kernels) : grid_(grid), kernels_(kernels) {
    list_all_cells(grid, cells_);
    triangles_.reserve(static_cast<std::size_t>(grid.triangles()));
    rows_.reserve(static_cast<std::size_t>(grid.triangles()));
}

std::int64_t SearchAudit::false_contacts(const Points& x, const Ball& ball, Real thickness,
                                         std::span<const StoppedNode> nodes) {
    find_touched_triangles(grid_, x, ball, thickness, cells_, triangles_, kernels_);
    const auto touches = [&](const StoppedNode& node) {
        const Real radii = ball.radius + thickness + node.sphere.radius;
        return (node.sphere.centre - ball.centre).squaredNorm() < radii * radii;
    };
    const auto is_true = [&](const StoppedNode& node) {
        return std::ranges::any_of(triangles_, [&](int triangle) {
            return node.holds(triangle / 2 % grid_.cell_columns(), triangle / 2 / grid_.cell_columns());
        });
    };
    return std::ranges::count_if(nodes, [&](const StoppedNode& node) { return touches(node) && !is_true(node); });
}

Real SearchAudit::penetration(const Points& x, std::span<const Ball> balls, Real thickness) {
    rows_.clear();
    for (const Ball& ball : balls) {
        find_contacts({grid_, x, x}, ball, {.thickness = thickness}, cells_, rows_, kernels_);
    }
    Real deepest = 0;
    for (const ContactRow& row : rows_) deepest = std::max(deepest, row.depth);
    return deepest;
}

}  // namespace drape
