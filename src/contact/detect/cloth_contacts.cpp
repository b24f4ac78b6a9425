#include <Eigen/Geometry>

#include "contact/grid_features.h"
#include "contact/kernels/near_cells.h"
#include "make_row.h"

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

/// From the centre of a ball to a point at some distance; along the triangle's own normal where that is the centre.
Vec3 normal_of(const Points& x, const std::array<int, 3>& corners, const Vec3& offset) {
    const Real distance = offset.norm();
    if (distance > 0) return offset / distance;
    const auto [a, b, c] = corners;
    const Vec3 across = (position(x, b) - position(x, a)).cross(position(x, c) - position(x, a));
    return across.squaredNorm() > 0 ? Vec3(across.normalized()) : Vec3(0, 1, 0);
}

/// Makes the contacts of triangles with one ball.
struct BallContacts {
    const MovingCloth& cloth;
    const Ball& ball;
    const SearchedBody& body;
    std::vector<ContactRow>& rows;

    // As they were when the planes are those of the contacts
    const Points& before = body.reach > 0 ? cloth.before : cloth.x;
    Vec3 start = body.reach > 0 ? Vec3(ball.centre - ball.moved) : ball.centre;
    Real radii = ball.radius + body.thickness, far = radii + body.reach;

    /// Adds the contacts that a triangle is to report: those of its own corners, and of its closest point.
    /// @return whether it touches
    bool add_triangle(int triangle) {
        const Grid& grid = cloth.grid;
        const std::array<int, 3> corners = grid.triangle_corners(triangle);
        const ClosestPoint closest = closest_point(before, corners, start);
        if (!is_near(closest.point)) return false;
        const unsigned owned = owned_corners(grid, triangle, triangle / 2 / grid.cell_columns());
        for (const std::size_t k : corners_ascending) {
            const Vec3 corner = position(before, corners[k]);
            if ((owned >> k & 1u) == 0 || !is_near(corner)) continue;
            add(with_plane(particle_row(cloth, corners[k], triangle, body.number), corners, corner));
        }
        const ContactRow own = with_plane(triangle_row(cloth, triangle, corners, closest.barycentric, body.number),
                                          corners, closest.point);
        if (!reported_elsewhere(grid, triangle, closest.barycentric)) add(own);
        return own.depth > 0;
    }

private:
    [[nodiscard]] bool is_near(const Vec3& point) const {
        return (point - start).squaredNorm() < far * far && radii > 0;
    }

    [[nodiscard]] ContactRow with_plane(ContactRow row, const std::array<int, 3>& corners, const Vec3& at) const {
        row.normal = normal_of(before, corners, at - start);
        row.distance = radii;
        row.depth = radii - (row.point(cloth.x) - ball.centre).dot(row.normal);
        return row;
    }

    /// What ends farther from its plane than the ball may push other cloth to it stays out of the solve.
    void add(const ContactRow& row) {
        if (row.depth > -body.reach) rows.push_back(row);
    }
};

}  // namespace

void find_touched_triangles(const Grid& grid, const Points& x, const Ball& ball, Real thickness,
                            std::span<const CellRun> cells, std::vector<int>& triangles, Kernels kernels) {
    const Real radius = ball.radius + thickness;
    const auto touches = [&](int triangle) {
        const ClosestPoint closest = closest_point(x, grid.triangle_corners(triangle), ball.centre);
        return (closest.point - ball.centre).squaredNorm() <= radius * radius;
    };
    triangles.clear();
    if (kernels == Kernels::Plain) {
        for_each_cell(grid, cells, [&](int cell) {
            for (const int triangle : {2 * cell, 2 * cell + 1}) {
                if (touches(triangle)) triangles.push_back(triangle);
            }
        });
        return;
    }
    // Most are decided by a corner
    kernels::visit_near(grid, x, ball.centre, radius, cells, [&](const auto& some) {
        for (const kernels::CellBits& bits : some) {
            kernels::for_each_set(bits, bits.near(), [&](int cell) {
                const std::uint32_t bit = std::uint32_t{1} << (cell - bits.cell);
                if (bits.first & bit || (bits.first_open & bit && touches(2 * cell))) triangles.push_back(2 * cell);
                if (bits.second & bit || (bits.second_open & bit && touches(2 * cell + 1))) {
                    triangles.push_back(2 * cell + 1);
                }
            });
        }
    });
}

std::int64_t find_contacts(const MovingCloth& cloth, const Ball& ball, const SearchedBody& body,
                           std::span<const CellRun> cells, std::vector<ContactRow>& rows, Kernels kernels) {
    BallContacts found{cloth, ball, body, rows};
    std::int64_t touching = 0;
    const auto test = [&](int cell) {
        const bool first = found.add_triangle(2 * cell), second = found.add_triangle(2 * cell + 1);
        touching += first || second;
    };
    if (kernels == Kernels::Plain) {
        for_each_cell(cloth.grid, cells, test);
    } else {
        kernels::visit_near(cloth.grid, found.before, found.start, found.far, cells, [&](const auto& some) {
            for (const kernels::CellBits& bits : some) {
                kernels::for_each_set(bits, bits.near(), test);
            }
        });
    }
    return touching;
}

void find_ground_contacts(const MovingCloth& cloth, Real height, const SearchedBody& body,
                          std::span<const CellRun> cells, std::vector<ContactRow>& rows) {
    const Grid& grid = cloth.grid;
    const Real limit = height + body.thickness;
    const auto add = [&](int particle) {
        if (!(cloth.x(particle, 1) < limit)) return;
        ContactRow row = particle_row(cloth, particle, owner_of(grid, particle), body.number);
        row.normal = Vec3(0, 1, 0);
        row.distance = body.thickness;
        row.depth = limit - cloth.x(particle, 1);
        rows.push_back(row);
    };
    for (const CellRun& run : cells) {
        for (int column = run.column; column < run.column + run.count; ++column) {
            for_each_particle_of(grid, column, run.row, add);
        }
    }
}

void find_node_contacts(const MovingCloth& cloth, const Ball& ball, const SearchedBody& body, Real longest_push,
                        std::span<const StoppedNode> nodes, std::vector<ContactRow>& rows) {
    for (const StoppedNode& node : nodes) {
        constexpr Real third = Real(1) / 3;
        const std::array<int, 3> corners = cloth.grid.triangle_corners(2 * node.cell);
        ContactRow row = triangle_row(cloth, 2 * node.cell, corners, {third, third, third}, body.number);
        row.kind = RowKind::Node;
        row.normal = normal_of(cloth.x, corners, node.sphere.centre - ball.centre);
        const Real radii = ball.radius + body.thickness + node.sphere.radius;
        const Real depth = radii - (node.sphere.centre - ball.centre).dot(row.normal);
        if (!(depth > 0)) continue;
        row.depth = std::min(depth, longest_push);
        row.distance = row.depth + (row.point(cloth.x) - ball.centre).dot(row.normal);
        rows.push_back(row);
    }
}

}  // namespace drape
