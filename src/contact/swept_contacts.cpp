#include <algorithm>
#include <tuple>

#include "contact_geometry.h"
#include "drape/contact/contact.h"

// Continuous detection says what the positions at the end of a substep do not show: what has passed a ball within it,
// and on which side of the ball the rest belongs. All else is answered as without it.

namespace drape {
namespace {

/// The normal at which a point met a ball, or at which it began in it.
/// @param from, to the point seen from the centre, at both ends of the substep; the end is within the radius [m]
Vec3 met_at(const Vec3& from, const Vec3& to, Real radius) {
    return first_meeting(from, to, radius).value_or(from).normalized();
}

/// The contact becomes the plane at which the ball was met.
void fix_plane(const Ball& ball, Real thickness, const Vec3& normal, Contact& contact) {
    contact.of_impact = true;
    contact.normal = normal;
    contact.depth = depth_in(ball, thickness, contact);
}

/// Keeps a contact that has come past the ball's middle on its side.
void keep_side(const Points& before, const Ball& ball, Real thickness, Contact& contact) {
    const Vec3 from = at_point(contact, before) - way_of(ball).start;
    const Vec3 normal = met_at(from, contact.point - ball.centre, ball.radius + thickness);
    if (normal.dot(contact.normal) < same_side && !normal.isZero(0)) fix_plane(ball, thickness, normal, contact);
}

/// What of a triangle an impact is on: its particles in ascending order, after -1 for each that has no weight.
std::array<int, 3> feature_of(const TriangleImpact& found) {
    std::array<int, 3> feature = found.corners;
    for (std::size_t k = 0; k < 3; ++k) {
        if (found.impact.barycentric[k] == 0) feature[k] = -1;
    }
    std::ranges::sort(feature);
    return feature;
}

/// Leaves the first impact of each particle, edge and triangle, triangles ascending.
void leave_first_of_each(std::vector<TriangleImpact>& impacts) {
    std::ranges::sort(impacts, {}, [](const TriangleImpact& found) {
        return std::tuple(feature_of(found), found.impact.time, found.triangle);
    });
    const auto same = [](const TriangleImpact& a, const TriangleImpact& b) { return feature_of(a) == feature_of(b); };
    impacts.erase(std::unique(impacts.begin(), impacts.end(), same), impacts.end());
    std::ranges::sort(impacts, {}, &TriangleImpact::triangle);
}

Contact impact_contact(const Points& x, const Ball& ball, int ball_number, Real thickness,
                       const TriangleImpact& found) {
    Contact contact;
    contact.ball = ball_number;
    contact.triangle = found.triangle;
    contact.corners = found.corners;
    contact.barycentric = found.impact.barycentric;
    contact.point = at_point(contact, x);
    fix_plane(ball, thickness, found.impact.normal, contact);
    return contact;
}

/// Whether the point of an impact is behind its plane at the end, by more than a response leaves with its tolerance,
/// and no longer in the ball.
bool has_passed(const Ball& ball, Real thickness, const Contact& contact) {
    return contact.depth > 2 * slop_in(ball) && (contact.point - ball.centre).norm() >= ball.radius + thickness;
}

/// Adds what has passed the ball.
/// @param impacts of which the first of each feature stays
/// @param takes takes(contact): whether what has passed is to be added
template <class Takes>
void add_passing(const Points& x, const Ball& ball, int ball_number, Real thickness,
                 std::vector<TriangleImpact>& impacts, std::vector<Contact>& contacts, Takes takes) {
    leave_first_of_each(impacts);
    for (const TriangleImpact& found : impacts) {
        const Contact contact = impact_contact(x, ball, ball_number, thickness, found);
        if (has_passed(ball, thickness, contact) && takes(contact)) contacts.push_back(contact);
    }
}

/// The inner half of a ball.
SweptBall core_of(SweptBall ball) {
    ball.radius /= 2;
    return ball;
}

std::int64_t count_cells(std::span<const TriangleImpact> impacts) {
    std::int64_t cells = 0;
    int last = -1;
    for (const TriangleImpact& found : impacts) {
        if (found.triangle / 2 != last) ++cells;
        last = found.triangle / 2;
    }
    return cells;
}

}  // namespace

SweptBall way_of(const Ball& ball) { return {ball.centre - ball.moved, ball.centre, ball.radius}; }

std::int64_t find_swept_contacts(const Grid& grid, const Points& before, const Points& x, const Ball& ball,
                                 int ball_number, Real thickness, std::span<const CellRun> cells,
                                 std::vector<TriangleImpact>& impacts, std::vector<Contact>& contacts,
                                 Kernels kernels) {
    const SweptBall way = grown(way_of(ball), thickness);
    impacts.clear();
    find_impacts(grid, before, x, way, cells, impacts);
    const std::int64_t touched = count_cells(impacts);
    const auto first = static_cast<std::ptrdiff_t>(contacts.size());
    find_contacts(grid, x, ball, ball_number, thickness, cells, contacts, kernels);
    for (Contact& contact : std::span(contacts).subspan(static_cast<std::size_t>(first))) {
        keep_side(before, ball, thickness, contact);
    }
    add_passing(x, ball, ball_number, thickness, impacts, contacts, [](const Contact&) { return true; });
    // A triangle may touch the ball first at one point, and be passed at another
    if (touched > 0) {
        impacts.clear();
        find_impacts(grid, before, x, core_of(way), cells, impacts);
        const std::size_t known = contacts.size();
        add_passing(x, ball, ball_number, thickness, impacts, contacts, [&](const Contact& contact) {
            const auto end = contacts.begin() + static_cast<std::ptrdiff_t>(known);
            return std::none_of(contacts.begin() + first, end, [&](const Contact& known_contact) {
                return known_contact.of_impact && known_contact.triangle == contact.triangle;
            });
        });
    }
    std::stable_sort(contacts.begin() + first, contacts.end(), [](const Contact& a, const Contact& b) {
        return std::tuple(a.triangle, a.of_impact) < std::tuple(b.triangle, b.of_impact);
    });
    return touched;
}

}  // namespace drape
