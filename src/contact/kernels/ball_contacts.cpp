#include "ball_contacts.h"

#include "closest_points.h"
#include "contact/contact_geometry.h"
#include "contact/grid_features.h"
#include "near_cells.h"

namespace drape::kernels {
namespace {

/// The contacts of triangles with one ball, in the order in which the triangles come.
class BallContacts {
public:
    BallContacts(const Grid& grid, const Points& x, const Ball& ball, int ball_number, Real thickness,
                 std::vector<Contact>& contacts)
        : grid_(grid), x_(x), ball_(ball), ball_number_(ball_number), thickness_(thickness), contacts_(contacts) {
        const Real radii = ball.radius + thickness;
        square_ = radii > 0 ? radii * radii : Real(0);
    }

    void add_near_of(const CellBits& bits) {
        for (std::uint32_t near = bits.near(); near != 0; near &= near - 1) {
            const int k = std::countr_zero(near), cell = bits.cell + k;
            if ((bits.first | bits.first_open) >> k & 1u) add(2 * cell);
            if ((bits.second | bits.second_open) >> k & 1u) add(2 * cell + 1);
        }
    }

    /// Turns the triangles that are left into contacts.
    /// @return how many cells touch
    std::int64_t finish() {
        report_all();
        return touching_;
    }

private:
    void add(int triangle) {
        batch_.add(grid_, x_, triangle);
        if (batch_.full()) report_all();
    }

    void report_all() {
        find_closest_points(batch_, ball_.centre);
        for (std::size_t k = 0; k < batch_.count; ++k) {
            if (batch_.square[k] < square_) report(k);
        }
        batch_.count = 0;
    }

    void report(std::size_t k) {
        const int triangle = batch_.triangle[k];
        touching_ += triangle / 2 != last_cell_;
        last_cell_ = triangle / 2;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            if (reports_corner(grid_, triangle, corner)) report_corner(k, corner);
        }
        const std::array<Real, 3> barycentric{batch_.barycentric[0][k], batch_.barycentric[1][k],
                                              batch_.barycentric[2][k]};
        if (reported_elsewhere(grid_, triangle, barycentric)) return;
        Contact& contact = start_contact(triangle);
        contact.barycentric = barycentric;
        contact.point = {batch_.point[0][k], batch_.point[1][k], batch_.point[2][k]};
        touch(x_, ball_, thickness_, contact);
    }

    void report_corner(std::size_t k, std::size_t corner) {
        const TriangleBatch::Vectors& at = batch_.corners[corner];
        if (!((Vec3(at[0][k], at[1][k], at[2][k]) - ball_.centre).squaredNorm() < square_)) return;
        Contact& contact = start_contact(batch_.triangle[k]);
        contact.of_particle = true;
        contact.barycentric[corner] = 1;
        locate(x_, ball_, thickness_, contact);
    }

    Contact& start_contact(int triangle) {
        Contact& contact = contacts_.emplace_back();
        contact.ball = ball_number_;
        contact.triangle = triangle;
        contact.corners = grid_.triangle_corners(triangle);
        return contact;
    }

    const Grid& grid_;
    const Points& x_;
    const Ball& ball_;
    int ball_number_;
    Real thickness_;
    Real square_;  ///< of the grown ball's radius
    std::vector<Contact>& contacts_;
    TriangleBatch batch_;
    int last_cell_ = -1;
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
