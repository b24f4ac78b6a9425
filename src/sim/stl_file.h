#pragma once

#include <istream>
#include <string>

#include "drape/contact/solid_shape.h"

namespace drape {

/// Reads a closed mesh from an STL file, text or binary: a file is binary if it has as many bytes as the number of
/// triangles in it asks for. Coordinates are metres. Its triangles share no points: exactly equal ones become one.
/// Normals are left out; a triangle is counter-clockwise seen from outside.
/// @throws InputError as `read_mesh`
/// @par Cost O(triangles log points)
TriangleMesh read_stl(std::istream& in, const std::string& file);

}  // namespace drape
