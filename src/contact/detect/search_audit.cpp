#include "drape/contact/detection.h"

#include <algorithm>

namespace drape {

std::int64_t count_false_contacts(const Grid& grid, const Points& x, const Ball& ball, Real thickness,
                                  std::span<const StoppedNode> nodes) {
    std::vector<CellRun> cells;
    std::vector<int> triangles;
    list_all_cells(grid, cells);
    find_touched_triangles(grid, x, ball, thickness, cells, triangles, Kernels::Vector);
    const auto touches = [&](const StoppedNode& node) {
        const Real radii = ball.radius + thickness + node.sphere.radius;
        return (node.sphere.centre - ball.centre).squaredNorm() < radii * radii;
    };
    const auto is_true = [&](const StoppedNode& node) {
        return std::ranges::any_of(triangles, [&](int triangle) {
            return node.holds(triangle / 2 % grid.cell_columns(), triangle / 2 / grid.cell_columns());
        });
    };
    return std::ranges::count_if(nodes, [&](const StoppedNode& node) { return touches(node) && !is_true(node); });
}

Real deepest_penetration(const Grid& grid, const Points& x, std::span<const Ball> balls, Real thickness) {
    std::vector<CellRun> cells;
    std::vector<ContactRow> rows;
    list_all_cells(grid, cells);
    for (const Ball& ball : balls) {
        find_contacts({grid, x, x}, ball, {.thickness = thickness}, cells, rows, Kernels::Vector);
    }
    Real deepest = 0;
    for (const ContactRow& row : rows) deepest = std::max(deepest, row.depth);
    return deepest;
}

}  // namespace drape
