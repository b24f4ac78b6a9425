#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "closed_mesh.h"

namespace drape {

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
