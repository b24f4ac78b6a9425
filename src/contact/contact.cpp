#include "drape/contact/contact.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "cell_verdicts.h"
#include "contact_geometry.h"
#include "drape/base/assert.h"
#include "drape/contact/closest_point.h"

namespace drape {

namespace {

using kernels::Verdicts;

/// Calls visit(verdicts) for the cells of which one may touch.
template <class Visit>
void for_each_verdict(const Grid& grid, const Points& x, const Vec3& p, Real reach, std::span<const CellRun> cells,
                      Visit visit) {
    const Real* const xs[3] = {x.col(0).data(), x.col(1).data(), x.col(2).data()};
    std::array<Verdicts, 4096> verdicts;  // a run of a grid is no longer
    for (std::size_t begin = 0, end = 0; begin < cells.size(); begin = end) {
        for (std::size_t room = verdicts.size(); end < cells.size(); ++end) {
            const auto count = static_cast<std::size_t>(cells[end].count);
            if (count > room) break;
            room -= count;
        }
        DRAPE_ASSERT(end > begin);
        const int found = kernels::judge_cells(grid, xs, p, reach, cells.subspan(begin, end - begin), verdicts.data());
        std::for_each_n(verdicts.begin(), found, visit);
    }
}

/// Decides on the triangles that the corners leave open.
void decide(const Grid& grid, const Points& x, const Vec3& p, Real reach, Verdicts& verdicts) {
    const auto touches = [&](int triangle) {
        return (closest_point(x, grid.triangle_corners(triangle), p).point - p).squaredNorm() <= reach * reach;
    };
    for (std::uint32_t open = verdicts.open; open != 0; open &= open - 1) {
        const int k = std::countr_zero(open), cell = verdicts.cell + k;
        const std::uint32_t bit = 1u << k;
        if (!(verdicts.first & bit) && touches(2 * cell)) verdicts.first |= bit;
        if (!(verdicts.second & bit) && touches(2 * cell + 1)) verdicts.second |= bit;
    }
}

}  // namespace

void find_touched_triangles(const Grid& grid, const Points& x, const Ball& ball, Real thickness,
                            std::span<const CellRun> cells, std::vector<int>& triangles) {
    triangles.clear();
    const Real reach = ball.radius + thickness;
    for_each_verdict(grid, x, ball.centre, reach, cells, [&](Verdicts verdicts) {
        decide(grid, x, ball.centre, reach, verdicts);
        const std::size_t before = triangles.size();
        triangles.resize(before + 2 * static_cast<std::size_t>(verdicts.count));
        int* next = triangles.data() + before;
        if ((verdicts.first & verdicts.second) == (1u << verdicts.count) - 1) {
            for (int k = 0; k < 2 * verdicts.count; ++k) next[k] = 2 * verdicts.cell + k;
            return;
        }
        for (int k = 0; k < verdicts.count; ++k) {
            *next = 2 * (verdicts.cell + k);
            next += verdicts.first >> k & 1u;
            *next = 2 * (verdicts.cell + k) + 1;
            next += verdicts.second >> k & 1u;
        }
        triangles.resize(static_cast<std::size_t>(next - triangles.data()));
    });
}

std::int64_t find_contacts(const Grid& grid, const Points& x, const Ball& ball, int ball_number, Real thickness,
                           std::span<const CellRun> cells, std::vector<Contact>& contacts) {
    Contact contact{.ball = ball_number};
    std::int64_t touching = 0;
    for_each_verdict(grid, x, ball.centre, ball.radius + thickness, cells, [&](const Verdicts& verdicts) {
        for (std::uint32_t near = verdicts.first | verdicts.second | verdicts.open; near != 0; near &= near - 1) {
            const int cell = verdicts.cell + std::countr_zero(near);
            const std::size_t before = contacts.size();
            for (const int triangle : {2 * cell, 2 * cell + 1}) {
                contact.triangle = triangle;
                contact.corners = grid.triangle_corners(triangle);
                if (locate(x, ball, thickness, contact)) contacts.push_back(contact);
            }
            if (contacts.size() > before) ++touching;
        }
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
