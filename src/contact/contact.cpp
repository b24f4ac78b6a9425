#include "drape/contact/contact.h"

#include <algorithm>

#include "contact_geometry.h"
#include "grid_features.h"
#include "kernels/ball_contacts.h"

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

/// Adds the contacts that a triangle is to report: those of its own corners, and of its closest point.
/// @return whether it touches
bool add_contacts(const Grid& grid, const Points& x, const Ball& ball, int ball_number, Real thickness, int triangle,
                  std::vector<Contact>& contacts) {
    Contact contact;
    contact.ball = ball_number;
    contact.triangle = triangle;
    contact.corners = grid.triangle_corners(triangle);
    if (!locate(x, ball, thickness, contact)) return false;
    const unsigned owned = owned_corners(grid, triangle, triangle / 2 / grid.cell_columns());
    for (std::size_t k = 0; k < 3; ++k) {
        if ((owned >> k & 1u) == 0) continue;
        Contact of_corner = particle_contact(grid, contact.corners[k]);
        of_corner.ball = ball_number;
        if (locate(x, ball, thickness, of_corner)) contacts.push_back(of_corner);
    }
    if (!reported_elsewhere(grid, triangle, contact.barycentric)) contacts.push_back(contact);
    return true;
}

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
    if (kernels == Kernels::Vector) {
        return kernels::find_contacts(grid, x, ball, ball_number, thickness, cells, contacts);
    }
    std::int64_t touching = 0;
    for_each_cell(grid, cells, [&](int cell) {
        bool touches = false;
        for (const int triangle : {2 * cell, 2 * cell + 1}) {
            touches = add_contacts(grid, x, ball, ball_number, thickness, triangle, contacts) || touches;
        }
        if (touches) ++touching;
    });
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
    BallContact contact;
    const auto test = [&](int first, int second) {
        contact.first = first;
        contact.ball = second;
        if (locate(balls, ground, contact)) contacts.push_back(contact);
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
