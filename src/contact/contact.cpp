#include "drape/contact/contact.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "cell_verdicts.h"
#include "contact_geometry.h"
#include "drape/contact/closest_point.h"

namespace drape {

namespace {

using kernels::Verdict;

/// Calls visit(cells, verdicts) for the cells in portions, with what their corners say.
template <class Visit>
void for_each_portion(const Grid& grid, const Points& x, const Vec3& p, Real reach, std::span<const int> cells,
                      Visit visit) {
    const Real* const xs[3] = {x.col(0).data(), x.col(1).data(), x.col(2).data()};
    std::array<std::uint8_t, 512> verdicts;
    for (std::size_t begin = 0; begin < cells.size(); begin += verdicts.size()) {
        const auto portion = cells.subspan(begin, std::min(verdicts.size(), cells.size() - begin));
        kernels::judge_cells(grid, xs, p, reach, portion, verdicts.data());
        visit(portion, std::span(verdicts).first(portion.size()));
    }
}

/// Decides on the triangles that a verdict leaves open.
std::uint8_t decided(std::uint8_t verdict, const Grid& grid, const Points& x, const Vec3& p, Real reach, int cell) {
    const auto touches = [&](int triangle) {
        return (closest_point(x, grid.triangle_corners(triangle), p).point - p).squaredNorm() <= reach * reach;
    };
    if (!(verdict & Verdict::first) && touches(2 * cell)) verdict |= Verdict::first;
    if (!(verdict & Verdict::second) && touches(2 * cell + 1)) verdict |= Verdict::second;
    return verdict & Verdict::both;
}

}  // namespace

void find_touched_triangles(const Grid& grid, const Points& x, const Ball& ball, Real thickness,
                            std::span<const int> cells, std::vector<int>& triangles) {
    // Room for all; what is not needed is given back
    triangles.resize(2 * cells.size());
    int* next = triangles.data();
    const Real reach = ball.radius + thickness;
    for_each_portion(grid, x, ball.centre, reach, cells, [&](std::span<const int> some, auto verdicts) {
        for (std::size_t k = 0; k < some.size(); ++k) {
            std::uint8_t verdict = verdicts[k];
            if (verdict & Verdict::open) verdict = decided(verdict, grid, x, ball.centre, reach, some[k]);
            *next = 2 * some[k];
            next += verdict & Verdict::first;
            *next = 2 * some[k] + 1;
            next += verdict >> 1;
        }
    });
    triangles.resize(static_cast<std::size_t>(next - triangles.data()));
}

void find_contacts(const Grid& grid, const Points& x, const Ball& ball, int ball_number, Real thickness,
                   std::span<const int> cells, std::vector<Contact>& contacts) {
    Contact contact{.ball = ball_number};
    for_each_portion(grid, x, ball.centre, ball.radius + thickness, cells,
                     [&](std::span<const int> some, auto verdicts) {
                         for (std::size_t k = 0; k < some.size(); ++k) {
                             if (verdicts[k] == 0) continue;
                             for (const int triangle : {2 * some[k], 2 * some[k] + 1}) {
                                 contact.triangle = triangle;
                                 contact.corners = grid.triangle_corners(triangle);
                                 if (locate(x, ball, thickness, contact)) contacts.push_back(contact);
                             }
                         }
                     });
}

}  // namespace drape
