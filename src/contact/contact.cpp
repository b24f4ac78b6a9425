#include "drape/contact/contact.h"

#include <algorithm>

#include "contact_geometry.h"
#include "grid_features.h"
#include "kernels/near_cells.h"
#include "kernels/touched_triangles.h"

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

/// The contact point at a particle, without a place yet.
Contact particle_contact(const Grid& grid, int particle) {
    Contact contact;
    contact.triangle = owner_of(grid, particle);
    contact.corners = grid.triangle_corners(contact.triangle);
    contact.of_particle = true;
    for (std::size_t k = 0; k < 3; ++k) contact.barycentric[k] = contact.corners[k] == particle ? Real(1) : Real(0);
    return contact;
}

/// Makes the contacts of triangles with one ball.
struct TriangleContacts {
    const Grid& grid;
    const Points& x;
    const Ball& ball;
    int number;
    Real radii;  ///< of the ball, thickness counted
    std::vector<Contact>& contacts;

    /// Adds the contacts that a triangle is to report: those of its own corners, and of its closest point.
    /// @return whether it touches
    bool add_triangle(int triangle) {
        const std::array<int, 3> corners = grid.triangle_corners(triangle);
        const ClosestPoint closest = closest_point(x, corners, ball.centre);
        if (!touches(closest.point)) return false;
        const unsigned owned = owned_corners(grid, triangle, triangle / 2 / grid.cell_columns());
        for (std::size_t k = 0; k < 3; ++k) {
            if ((owned >> k & 1u) == 0) continue;
            ClosestPoint corner{position(x, corners[k]), {}};
            corner.barycentric[k] = 1;
            if (touches(corner.point)) add(triangle, corners, corner, true);
        }
        if (!reported_elsewhere(grid, triangle, closest.barycentric)) add(triangle, corners, closest, false);
        return true;
    }

private:
    [[nodiscard]] bool touches(const Vec3& point) const {
        return (point - ball.centre).squaredNorm() < radii * radii && radii > 0;
    }

    void add(int triangle, const std::array<int, 3>& corners, const ClosestPoint& at, bool of_particle) {
        Contact& contact = contacts.emplace_back();
        contact.ball = number;
        contact.triangle = triangle;
        contact.corners = corners;
        contact.barycentric = at.barycentric;
        contact.point = at.point;
        contact.of_particle = of_particle;
        const Vec3 offset = at.point - ball.centre;
        measure(x, radii, offset, offset.squaredNorm(), contact);
    }
};

/// Of the particles from `first` up to `end`.
void add_ground_contacts(const Grid& grid, const Points& x, Real height, Real thickness, int first, int end,
                         std::vector<Contact>& contacts) {
    const Real limit = height + thickness;
    for (int p = first; p < end; ++p) {
        if (!(x(p, 1) < limit)) continue;
        Contact contact = particle_contact(grid, p);
        contact.ball = the_ground;
        locate_above(x, height, thickness, contact);
        contacts.push_back(contact);
    }
}

/// Turns a contact of two balls into that of their meeting, if they have met and the end of the substep does not show
/// it.
bool meet_within_substep(std::span<const Ball> balls, BallContact& contact) {
    const Ball &first = balls[static_cast<std::size_t>(contact.first)],
               &second = balls[static_cast<std::size_t>(contact.ball)];
    const Vec3 to = first.centre - second.centre, from = to - first.moved + second.moved;
    const auto met = first_meeting(from, to, first.radius + second.radius);
    if (!met || met->isZero(0) || (contact.depth > 0 && met->normalized().dot(contact.normal) >= same_side))
        return false;
    contact.normal = met->normalized();
    contact.of_impact = true;
    return true;
}

}  // namespace

void find_touched_triangles(const Grid& grid, const Points& x, const Ball& ball, Real thickness,
                            std::span<const CellRun> cells, std::vector<int>& triangles, Kernels kernels) {
    const Real radius = ball.radius + thickness;
    if (kernels == Kernels::Vector) return kernels::find_touched(grid, x, ball.centre, radius, cells, triangles);
    triangles.clear();
    for_each_cell(grid, cells, [&](int cell) {
        for (const int triangle : {2 * cell, 2 * cell + 1}) {
            const ClosestPoint closest = closest_point(x, grid.triangle_corners(triangle), ball.centre);
            if ((closest.point - ball.centre).squaredNorm() <= radius * radius) triangles.push_back(triangle);
        }
    });
}

std::int64_t find_contacts(const Grid& grid, const Points& x, const Ball& ball, int ball_number, Real thickness,
                           std::span<const CellRun> cells, std::vector<Contact>& contacts, Kernels kernels) {
    TriangleContacts found{grid, x, ball, ball_number, ball.radius + thickness, contacts};
    std::int64_t touching = 0;
    const auto test = [&](int cell) {
        const bool first = found.add_triangle(2 * cell), second = found.add_triangle(2 * cell + 1);
        touching += first || second;
    };
    if (kernels == Kernels::Plain) {
        for_each_cell(grid, cells, test);
    } else {
        kernels::visit_near(grid, x, ball.centre, found.radii, cells, [&](const auto& some) {
            for (const kernels::CellBits& bits : some) {
                kernels::for_each_set(bits, bits.near(), test);
            }
        });
    }
    return touching;
}

void find_ground_contacts(const Grid& grid, const Points& x, Real height, Real thickness,
                          std::vector<Contact>& contacts) {
    add_ground_contacts(grid, x, height, thickness, 0, grid.particles(), contacts);
}

void find_ground_contacts(const Grid& grid, const Points& x, Real height, Real thickness,
                          std::span<const CellRun> cells, std::vector<CellRun>& particles,
                          std::vector<Contact>& contacts) {
    list_corners(cells, particles);
    int done = 0;
    for (const CellRun& run : particles) {
        const int first = grid.particle(run.column, run.row), end = first + run.count;
        add_ground_contacts(grid, x, height, thickness, std::max(first, done), end, contacts);
        done = std::max(done, end);
    }
}

void find_ball_contacts(std::span<const Ball> balls, const Ground& ground, std::vector<BallContact>& contacts) {
    contacts.clear();
    const auto test = [&](int first, int second) {
        BallContact contact;
        contact.first = first;
        contact.ball = second;
        bool touches = locate(balls, ground, contact);
        if (second != the_ground && meet_within_substep(balls, contact)) touches = locate(balls, ground, contact);
        if (touches) contacts.push_back(contact);
    };
    const int count = static_cast<int>(balls.size());
    const auto is_free = [&](int b) { return balls[static_cast<std::size_t>(b)].inverse_mass > 0; };
    for (int first = 0; first < count; ++first) {
        if (ground.solid && is_free(first)) test(first, the_ground);
        for (int second = first + 1; second < count; ++second) {
            if (is_free(first) || is_free(second)) test(first, second);
        }
    }
}

}  // namespace drape
