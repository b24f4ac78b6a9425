#pragma once

#include <algorithm>
#include <array>
#include <numeric>
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

/// Three points of a mesh, by index.
using Corners = std::array<int, 3>;

inline const Vec3& point(const TriangleMesh& mesh, int p) { return mesh.points[static_cast<std::size_t>(p)]; }

/// Sets of numbers that are united step by step.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0); }

    /// The smallest number in the same set.
    int first_of(int number) {
        const auto parent = [&](int of) -> int& { return parents_[static_cast<std::size_t>(of)]; };
        while (parent(number) != number) number = parent(number) = parent(parent(number));
        return number;
    }

    void unite(int one, int other) {
        const auto [low, high] = std::minmax({first_of(one), first_of(other)});
        parents_[static_cast<std::size_t>(high)] = low;
    }

private:
    std::vector<int> parents_;
};

/// The triangles with corners in common: those within `reach` of each other, or of others that are, become one [m].
/// Triangles of fewer than three points go.
/// @par Cost O(n log n)
TriangleMesh weld(const std::vector<MeshTriangle>& triangles, Real reach);

/// Takes away triangles whose corners are in line: the middle one becomes a corner of the triangle across the longest
/// side, which is cut there.
/// @return false if there are triangles for which that does not help
bool remove_needles(TriangleMesh& mesh);

}  // namespace drape
