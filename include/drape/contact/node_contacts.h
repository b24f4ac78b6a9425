#pragma once

#include <span>
#include <vector>

#include "drape/contact/contact.h"

namespace drape {

/// How fast a node's sphere may push: as fast as a cloth settles, and slower than it tears [m/s].
inline constexpr Real node_push_speed = 1;

/// The contacts of nodes at which a search has ended, as their spheres, with one ball, appended. @cite hubbard1996
/// Most of a sphere is empty. Pushed out of it at once, the one triangle that feels it would tear at its neighbours:
/// what is deeper than a push may be is taken off the sphere's radius.
/// @param longest_push that one response may make of a contact [m]
void find_node_contacts(const Grid& grid, const Points& x, const Ball& ball, int ball_number, Real thickness,
                        Real longest_push, std::span<const StoppedNode> nodes, std::vector<Contact>& contacts);

}  // namespace drape
