#pragma once

#include <array>
#include <string>
#include <vector>

#include "drape/contact/solid_shape.h"

namespace drape {

/// The corners of a triangle, counter-clockwise seen from outside [m].
using MeshTriangle = std::array<Vec3, 3>;

/// "(x, y, z)", as an error shows a point.
std::string point_text(const Vec3& p);

/// The closed surface that triangles are the pieces of. Corners that are at most a millionth of the mesh's size from
/// each other become one; triangles without area go. Each connected part is turned so that its volume is inside; a part
/// inside another one is a cavity, and a part inside a cavity is solid again.
/// @param file names the mesh in errors
/// @throws InputError if a part is not closed, has sides whose triangles are turned differently, or has no volume, if
/// the surface crosses itself, if there are more than 1000 parts
/// @par Cost as a rule O(triangles^1.5)
TriangleMesh closed_mesh(const std::vector<MeshTriangle>& triangles, const std::string& file);

}  // namespace drape
