#include "ball_contacts.h"

#include "closest_points.h"
#include "contact/contact_geometry.h"
#include "contact/grid_features.h"
#include "near_cells.h"

namespace drape::kernels {
namespace {

/// The contacts of cells with one ball, in the order in which the cells come.
class BallContacts {
public:
    BallContacts(const Grid& grid, const Points& x, const Ball& ball, int ball_number, Real thickness,
                 std::vector<Contact>& contacts)
        : grid_(grid),
          beyond_a_{0, 1, grid.nx, grid.nx + 1},
          x_(x),
          ball_(ball),
          radii_(ball.radius + thickness),
          contacts_(contacts) {
        square_ = radii_ > 0 ? radii_ * radii_ : Real(0);
        blank_.ball = ball_number;
    }

    void add_near_of(const CellBits& bits) {
        for_each_set(grid_, bits, bits.near(), [&](int cell, int a) {
            batch_.add(grid_, x_, cell, a);
            if (batch_.full()) report_all();
        });
    }

    /// Turns the cells that are left into contacts.
    /// @return how many cells touch
    std::int64_t finish() {
        report_all();
        return touching_;
    }

private:
    void report_all() {
        find_closest_points(batch_, ball_.centre);
        for (std::size_t k = 0; k < batch_.count; ++k) {
            const bool first = batch_.closest[0].square[k] < square_, second = batch_.closest[1].square[k] < square_;
            if (first) report(k, 0);
            if (second) report(k, 1);
            touching_ += first || second;
        }
        batch_.count = 0;
    }

    void report(std::size_t k, std::size_t second) {
        const int triangle = 2 * batch_.cell[k] + static_cast<int>(second), a = batch_.corner_a[k];
        const unsigned owned = owned_corners(grid_, triangle, a - batch_.cell[k]);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            if (owned >> corner & 1u) report_corner(k, triangle, corner);
        }
        const CellBatch::Closest& closest = batch_.closest[second];
        const std::array<Real, 3> barycentric{closest.barycentric[0][k], closest.barycentric[1][k],
                                              closest.barycentric[2][k]};
        if (reported_elsewhere(grid_, triangle, barycentric)) return;
        const Vec3 point = at(closest.point, k);
        add(triangle, a, point, point - ball_.centre, closest.square[k]).barycentric = barycentric;
    }

    void report_corner(std::size_t k, int triangle, std::size_t corner) {
        const auto second = static_cast<std::size_t>(triangle % 2);
        const Vec3 point = at(batch_.corners[CellBatch::corners_of[second][corner]], k), offset = point - ball_.centre;
        const Real square = offset.squaredNorm();
        if (!(square < square_)) return;
        Contact& contact = add(triangle, batch_.corner_a[k], point, offset, square);
        contact.of_particle = true;
        contact.barycentric[corner] = 1;
    }

    static Vec3 at(const CellBatch::Vectors& from, std::size_t k) { return {from[0][k], from[1][k], from[2][k]}; }

    Contact& add(int triangle, int a, const Vec3& point, const Vec3& offset, Real square) {
        Contact& contact = contacts_.emplace_back(blank_);
        contact.triangle = triangle;
        const auto& corners = CellBatch::corners_of[static_cast<std::size_t>(triangle % 2)];
        for (std::size_t k = 0; k < 3; ++k) contact.corners[k] = a + beyond_a_[corners[k]];
        contact.point = point;
        measure(x_, radii_, offset, square, contact);
        return contact;
    }

    const Grid& grid_;
    std::array<int, 4> beyond_a_;  ///< by how much the numbers of a cell's corners are beyond that of corner a
    const Points& x_;
    const Ball& ball_;
    Real radii_;   ///< of the ball, thickness counted
    Real square_;  ///< of that
    std::vector<Contact>& contacts_;
    Contact blank_;  ///< copied into each: faster than to make one
    CellBatch batch_;
    std::int64_t touching_ = 0;
};

}  // namespace

std::int64_t find_contacts(const Grid& grid, const Points& x, const Ball& ball, int ball_number, Real thickness,
                           std::span<const CellRun> cells, std::vector<Contact>& contacts) {
    BallContacts found(grid, x, ball, ball_number, thickness, contacts);
    visit_near(grid, x, ball.centre, ball.radius + thickness, cells, [&](std::span<const CellBits> near) {
        for (const CellBits& bits : near) found.add_near_of(bits);
    });
    return found.finish();
}

}  // namespace drape::kernels
