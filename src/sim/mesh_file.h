#pragma once

#include <istream>
#include <string>

#include "drape/contact/solid_shape.h"

namespace drape {

/// Reads a closed mesh from an OBJ file: its lines `v x y z` [m] and `f a b c ...`, of faces that are convex and may
/// name textures and normals too, which are left out like any other line.
/// @throws InputError as `file:line: ... allowed ...`: what is no number, what is out of range, a mesh that is too
/// large, not closed, not consistently oriented, or inside out
TriangleMesh read_mesh(const std::string& file);

/// The same from a stream; `file` names it in errors.
TriangleMesh read_mesh(std::istream& in, const std::string& file);

}  // namespace drape
