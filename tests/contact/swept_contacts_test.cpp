// What has passed a ball within a substep, though the point that touched it first has not.

#include <gtest/gtest.h>

#include <vector>

#include "drape/contact/contact.h"

namespace drape {
namespace {

constexpr Real cloth_thickness = Real(0.1);
const Grid swinging_cell{.nx = 2, .ny = 2};

Points rows_of(const std::vector<Vec3>& rows) {
    Points x(static_cast<Eigen::Index>(rows.size()), 3);
    for (std::size_t k = 0; k < rows.size(); ++k) x.row(static_cast<Eigen::Index>(k)) = rows[k].transpose();
    return x;
}

/// The contacts of one cell whose first corner touches a resting ball of radius 1, thickness counted, and is then drawn
/// aside, while the rest of its triangle comes down through the ball's middle.
/// @param end of that corner, seen from the centre
std::vector<Contact> contacts_of_swinging_cell(const Vec3& end) {
    const Ball ball{.radius = 1 - cloth_thickness};
    const Points before = rows_of({{0, 0, Real(0.99999)}, {5, -5, 3}, {5, 5, 3}, {10, 0, 3}});
    const Points x = rows_of({end, {5, -5, -10}, {5, 5, -10}, {10, 0, -10}});
    std::vector<CellRun> cells{{.row = 0, .column = 0, .count = 1}};
    std::vector<TriangleImpact> impacts;
    std::vector<Contact> contacts;
    find_swept_contacts(swinging_cell, before, x, ball, 0, cloth_thickness, cells, impacts, contacts, Kernels::Plain);
    return contacts;
}

void expect_far_behind(const std::vector<Contact>& contacts) {
    ASSERT_FALSE(contacts.empty());
    for (const Contact& contact : contacts) {
        if (contact.depth < 1) continue;
        EXPECT_TRUE(contact.of_impact);
        EXPECT_GT(contact.normal.z(), 0.5) << "it came from above";
        return;
    }
    ADD_FAILURE() << "no contact is as deep as the ball is large";
}

TEST(SweptContacts, HaveWhatPassesElsewhereThanWhereItTouchedFirst) {
    expect_far_behind(contacts_of_swinging_cell({-3, 0, Real(1.5)}));
}

/// As a response leaves it: what was to be pushed out has been.
TEST(SweptContacts, HaveItTooWhereTheFirstPointIsHardlyInside) {
    expect_far_behind(contacts_of_swinging_cell({-3, 0, Real(0.99998)}));
}

}  // namespace
}  // namespace drape
