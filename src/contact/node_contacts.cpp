#include "drape/contact/contact.h"

#include <algorithm>

#include "contact_geometry.h"

namespace drape {

void find_node_contacts(const Grid& grid, const Points& x, const Ball& ball, int ball_number, Real thickness,
                        Real longest_push, std::span<const StoppedNode> nodes, std::vector<Contact>& contacts) {
    for (const StoppedNode& node : nodes) {
        Contact contact;
        contact.triangle = 2 * node.cell;
        contact.ball = ball_number;
        contact.of_node = true;
        contact.corners = grid.triangle_corners(contact.triangle);
        contact.barycentric.fill(Real(1) / 3);
        contact.offset = node.sphere.centre - at_point(contact, x);
        contact.radius = node.sphere.radius;
        contact.point = at_point(contact, x);
        const Vec3 offset = node.sphere.centre - ball.centre;
        contact.normal = normal_of(x, contact.corners, offset, offset.norm());
        contact.depth = depth_in(ball, thickness, contact);
        if (!(contact.depth > 0)) continue;
        contact.radius -= std::max(contact.depth - longest_push, Real(0));
        contact.depth = std::min(contact.depth, longest_push);
        contacts.push_back(contact);
    }
}

}  // namespace drape
