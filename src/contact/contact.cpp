#include "drape/contact/contact.h"

#include "contact_geometry.h"
#include "kernels/near_cells.h"

namespace drape {
namespace {

/// Calls visit(cell) for each cell of the runs.
template <class Visit>
void for_each_cell(const Grid& grid, std::span<const CellRun> cells, Visit visit) {
    for (const CellRun& run : cells) {
        const int first = run.row * grid.cell_columns() + run.column;
        for (int cell = first; cell < first + run.count; ++cell) visit(cell);
    }
}

}  // namespace

void find_touched_triangles(const Grid& grid, const Points& x, const Ball& ball, Real thickness,
                            std::span<const CellRun> cells, std::vector<int>& triangles, Kernels kernels) {
    triangles.clear();
    const Real radius = ball.radius + thickness;
    if (kernels == Kernels::Vector) return kernels::find_touched(grid, x, ball.centre, radius, cells, triangles);
    for_each_cell(grid, cells, [&](int cell) {
        for (const int triangle : {2 * cell, 2 * cell + 1}) {
            const ClosestPoint closest = closest_point(x, grid.triangle_corners(triangle), ball.centre);
            if ((closest.point - ball.centre).squaredNorm() <= radius * radius) triangles.push_back(triangle);
        }
    });
}

std::int64_t find_contacts(const Grid& grid, const Points& x, const Ball& ball, int ball_number, Real thickness,
                           std::span<const CellRun> cells, std::vector<Contact>& contacts, Kernels kernels) {
    Contact contact{.ball = ball_number};
    std::int64_t touching = 0;
    const auto test = [&](int cell) {
        const std::size_t before = contacts.size();
        for (const int triangle : {2 * cell, 2 * cell + 1}) {
            contact.triangle = triangle;
            contact.corners = grid.triangle_corners(triangle);
            if (locate(x, ball, thickness, contact)) contacts.push_back(contact);
        }
        if (contacts.size() > before) ++touching;
    };
    if (kernels == Kernels::Plain)
        for_each_cell(grid, cells, test);
    else
        kernels::for_each_near_cell(grid, x, ball.centre, ball.radius + thickness, cells, test);
    return touching;
}

}  // namespace drape
