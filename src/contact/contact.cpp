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
    const ClothMotion& cloth;
    const Ball& ball;
    int number;
    Real radii;  ///< of the ball, thickness counted
    Real reach;
    std::vector<Contact>& contacts;

    // As they were when the planes are those of the contacts
    const Points& before = reach > 0 ? cloth.before : cloth.x;
    Vec3 moved = reach > 0 ? ball.moved : Vec3(0, 0, 0);
    Vec3 start = ball.centre - moved;

    /// Adds the contacts that a triangle is to report: those of its own corners, and of its closest point.
    /// @return whether it touches
    bool add_triangle(int triangle) {
        const std::array<int, 3> corners = grid.triangle_corners(triangle);
        const ClosestPoint closest = closest_point(before, corners, start);
        if (!is_near(closest.point)) return false;
        const unsigned owned = owned_corners(grid, triangle, triangle / 2 / grid.cell_columns());
        for (std::size_t k = 0; k < 3; ++k) {
            if ((owned >> k & 1u) == 0) continue;
            ClosestPoint corner{position(before, corners[k]), {}};
            corner.barycentric[k] = 1;
            if (is_near(corner.point)) add(contact(triangle, corners, corner, true));
        }
        const Contact own = contact(triangle, corners, closest, false);
        if (!reported_elsewhere(grid, triangle, closest.barycentric)) add(own);
        return own.depth > 0;
    }

private:
    [[nodiscard]] bool is_near(const Vec3& point) const {
        const Real far = radii + reach;
        return (point - start).squaredNorm() < far * far && radii > 0;
    }

    [[nodiscard]] Contact contact(int triangle, const std::array<int, 3>& corners, const ClosestPoint& at,
                                  bool of_particle) const {
        Contact contact;
        contact.ball = number;
        contact.triangle = triangle;
        contact.corners = corners;
        contact.barycentric = at.barycentric;
        contact.of_particle = of_particle;
        const Vec3 offset = at.point - start;
        contact.normal = normal_of(before, corners, offset, offset.norm());
        contact.point = at_point(contact, cloth.x);
        contact.depth = radii - (contact.point - ball.centre).dot(contact.normal);
        return contact;
    }

    /// What ends farther from its plane than the ball may push other cloth to it stays out of the solve.
    void add(const Contact& contact) {
        if (contact.depth > -reach) contacts.push_back(contact);
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

/// From the second ball to the first where they met within the substep; where they did not, at its end.
Vec3 normal_between(const Ball& first, const Ball& second) {
    const Vec3 to = first.centre - second.centre, from = to - first.moved + second.moved;
    const Vec3 normal = first_meeting(from, to, first.radius + second.radius).value_or(to);
    return normal.isZero(0) ? Vec3(0, 1, 0) : Vec3(normal.normalized());
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

std::int64_t find_contacts(const Grid& grid, const ClothMotion& cloth, const Ball& ball, int ball_number,
                           Real thickness, Real reach, std::span<const CellRun> cells, std::vector<Contact>& contacts,
                           Kernels kernels) {
    TriangleContacts found{grid, cloth, ball, ball_number, ball.radius + thickness, reach, contacts};
    std::int64_t touching = 0;
    const auto test = [&](int cell) {
        const bool first = found.add_triangle(2 * cell), second = found.add_triangle(2 * cell + 1);
        touching += first || second;
    };
    if (kernels == Kernels::Plain) {
        for_each_cell(grid, cells, test);
    } else {
        kernels::visit_near(grid, found.before, found.start, found.radii + reach, cells, [&](const auto& some) {
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
        const auto ball = [&](int number) -> const Ball& { return balls[static_cast<std::size_t>(number)]; };
        contact.normal = second == the_ground ? Vec3(0, 1, 0) : normal_between(ball(first), ball(second));
        contact.depth = depth_now(balls, ground, contact);
        if (contact.depth > 0) contacts.push_back(contact);
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
