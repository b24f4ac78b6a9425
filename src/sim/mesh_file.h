#pragma once

#include <istream>
#include <string>

#include "drape/contact/solid_shape.h"

namespace drape {

/// The format in which a mesh is read, by the name of its file: ".stl", or else ".obj".
std::string mesh_extension(const std::string& file);

/// Reads a closed mesh from a file. OBJ: its lines `v x y z` [m] and `f a b c ...`, of faces that are convex and may
/// name textures and normals too, which are left out like any other line. STL, text or binary: see `read_stl`.
/// @throws InputError as `file:line: ... allowed ...`, of binary files as `file: byte N: ...`: what is no number, what
/// is out of range, a mesh that is too large, not closed, not consistently oriented, or inside out
TriangleMesh read_mesh(const std::string& file);

/// The same from a stream; `file` names it in errors, and its format.
TriangleMesh read_mesh(std::istream& in, const std::string& file);

}  // namespace drape
