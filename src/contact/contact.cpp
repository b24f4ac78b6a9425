#include "drape/contact/contact.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact_geometry.h"
#include "drape/contact/closest_point.h"
#include "near_cells.h"

namespace drape {

namespace {

/// Calls visit(cell) for the cells that may have a triangle within `reach` of p.
template <class Visit>
void for_each_near_cell(const Grid& grid, const Points& x, const Vec3& p, Real reach, std::span<const int> cells,
                        Visit visit) {
    const Real* const xs[3] = {x.col(0).data(), x.col(1).data(), x.col(2).data()};
    std::array<bool, 256> near;
    for (std::size_t begin = 0; begin < cells.size(); begin += near.size()) {
        const auto some = cells.subspan(begin, std::min(near.size(), cells.size() - begin));
        kernels::flag_near_cells(grid, xs, p, reach, some, near.data());
        for (std::size_t k = 0; k < some.size(); ++k) {
            if (near[k]) visit(some[k]);
        }
    }
}

}  // namespace

void find_touched_triangles(const Grid& grid, const Points& x, const Ball& ball, Real thickness,
                            std::span<const int> cells, std::vector<int>& triangles) {
    triangles.clear();
    const Real reach = ball.radius + thickness;
    const auto inside = [&](int p) { return (position(x, p) - ball.centre).squaredNorm() <= reach * reach; };
    for_each_near_cell(grid, x, ball.centre, reach, cells, [&](int cell) {
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
    });
}

std::int64_t find_contacts(const Grid& grid, const Points& x, const Ball& ball, int ball_number, Real thickness,
                           std::span<const int> cells, std::vector<Contact>& contacts) {
    Contact contact{.ball = ball_number};
    std::int64_t touching = 0;
    for_each_near_cell(grid, x, ball.centre, ball.radius + thickness, cells, [&](int cell) {
        const std::size_t before = contacts.size();
        for (const int triangle : {2 * cell, 2 * cell + 1}) {
            contact.triangle = triangle;
            contact.corners = grid.triangle_corners(triangle);
            if (locate(x, ball, thickness, contact)) contacts.push_back(contact);
        }
        if (contacts.size() > before) ++touching;
    });
    return touching;
}

void find_node_contacts(const Grid& grid, const Points& x, const Ball& ball, int ball_number, Real thickness,
                        Real longest_push, std::span<const StoppedNode> nodes, std::vector<Contact>& contacts) {
    for (const StoppedNode& node : nodes) {
        Contact contact{.triangle = 2 * node.cell, .ball = ball_number, .of_node = true};
        contact.corners = grid.triangle_corners(contact.triangle);
        contact.barycentric.fill(Real(1) / 3);
        contact.offset = node.sphere.centre - at_point(contact, x);
        contact.radius = node.sphere.radius;
        if (!locate(x, ball, thickness, contact)) continue;
        contact.radius -= std::max(contact.depth - longest_push, Real(0));
        contact.depth = std::min(contact.depth, longest_push);
        contacts.push_back(contact);
    }
}

}  // namespace drape
