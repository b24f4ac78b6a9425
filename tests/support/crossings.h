#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <vector>

#include "drape/contact/near_pairs.h"

namespace drape::test {

using ExactVec = std::array<mpq_class, 3>;

inline ExactVec exact(const Vec3& p) { return {mpq_class(p[0]), mpq_class(p[1]), mpq_class(p[2])}; }

/// On which side of the plane through a, b, c the point d is, by rational numbers: 1, -1, or 0 on it.
inline int exact_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const ExactVec p = exact(a), q = exact(b), r = exact(c), s = exact(d);
    std::array<ExactVec, 3> m;
    for (std::size_t k = 0; k < 3; ++k) m[0][k] = q[k] - p[k], m[1][k] = r[k] - p[k], m[2][k] = s[k] - p[k];
    const mpq_class determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                                  m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                                  m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    return sgn(determinant);
}

/// The same, by doubles where their rounding cannot matter.
inline int side_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 u = b - a, v = c - a, w = d - a;
    const double determinant = u.cross(v).dot(w);
    const double size = u.cwiseAbs().sum() * v.cwiseAbs().sum() * w.cwiseAbs().sum();
    if (std::abs(determinant) > 1e-14 * size) return determinant > 0 ? 1 : -1;
    return exact_side(a, b, c, d);
}

/// Whether an edge from p to q crosses triangle a, b, c: from one side of it to the other, through its inside.
inline bool crosses(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
    if (side_of(a, b, c, p) * side_of(a, b, c, q) >= 0) return false;
    const int ab = side_of(p, q, a, b), bc = side_of(p, q, b, c), ca = side_of(p, q, c, a);
    return ab != 0 && ab == bc && bc == ca;
}

/// How many edges cross triangles that they share no particle with, in one cloth or between two: exactly, by testing
/// every pair of cells whose boxes meet.
inline std::int64_t crossings(const BoxedCloth& first, const BoxedCloth& second) {
    const Grid &grid = first.cloth.grid, &other = second.cloth.grid;
    const bool same = first.cloth.number == second.cloth.number;
    std::int64_t count = 0;
    const auto at = [](const ClothAt& cloth, int p) -> Vec3 { return cloth.x.row(p).transpose(); };
    const auto test = [&](const ClothAt& of_edges, int edge_cell, const ClothAt& of_triangles, int cell) {
        for (const int edge_triangle : {2 * edge_cell, 2 * edge_cell + 1}) {
            const auto e = of_edges.grid.triangle_corners(edge_triangle);
            for (std::size_t k = 0; k < 3; ++k) {
                const int p = e[k], q = e[(k + 1) % 3];
                for (const int triangle : {2 * cell, 2 * cell + 1}) {
                    const auto t = of_triangles.grid.triangle_corners(triangle);
                    if (same && (std::ranges::count(t, p) > 0 || std::ranges::count(t, q) > 0)) continue;
                    if (crosses(at(of_edges, p), at(of_edges, q), at(of_triangles, t[0]), at(of_triangles, t[1]),
                                at(of_triangles, t[2]))) {
                        ++count;
                    }
                }
            }
        }
    };
    for (int one = 0; one < grid.cells(); ++one) {
        for (int two = same ? one : 0; two < other.cells(); ++two) {
            if (!first.boxes[one].comes_within(second.boxes[two], 0)) continue;
            test(first.cloth, one, second.cloth, two);
            if (!same || one != two) test(second.cloth, two, first.cloth, one);
        }
    }
    return count;
}

}  // namespace drape::test
