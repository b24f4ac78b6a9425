#pragma once

#include <istream>
#include <string>

#include "drape/contact/solid_shape.h"

namespace drape {

/// The format in which a mesh is read, by the name of its file: ".stl", or else ".obj".
std::string mesh_extension(const std::string& file);

/// Reads a mesh from an OBJ or STL file [m] by the library Assimp, and makes a closed one of it: see `closed_mesh`.
/// Of OBJ only points and faces reach the library, so that a file names no other files. Coordinates have single
/// precision.
/// @throws InputError as `file:line: ... allowed ...` of what is no number in an OBJ file, else with the file's name:
/// what the library refuses, what is out of range, too large, or not a closed mesh
TriangleMesh read_mesh(const std::string& file);

/// The same from a stream; `file` names it in errors, and its format.
TriangleMesh read_mesh(std::istream& in, const std::string& file);

}  // namespace drape
