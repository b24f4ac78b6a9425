#pragma once

#include <Eigen/Geometry>
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <span>
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

/// The same, by doubles where their rounding cannot matter: that is in proportion to the sum of the absolute products,
/// also where a sheet is nearly flat.
inline int side_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 u = b - a, v = c - a, w = d - a;
    const double determinant = u.cross(v).dot(w);
    double products = 0;
    for (int k = 0; k < 3; ++k) {
        const int m = (k + 1) % 3, n = (k + 2) % 3;
        products += (std::abs(u[m] * v[n]) + std::abs(u[n] * v[m])) * std::abs(w[k]);
    }
    if (std::abs(determinant) > 4e-15 * products) return determinant > 0 ? 1 : -1;
    return exact_side(a, b, c, d);
}

/// Whether an edge from p to q crosses triangle a, b, c: from one side of it to the other, through its inside. Boxes
/// that do no more than touch have no point inside both.
inline bool crosses(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    if ((p.cwiseMax(q).array() <= low.array()).any() || (p.cwiseMin(q).array() >= high.array()).any()) return false;
    if (side_of(a, b, c, p) * side_of(a, b, c, q) >= 0) return false;
    const int ab = side_of(p, q, a, b), bc = side_of(p, q, b, c), ca = side_of(p, q, c, a);
    return ab != 0 && ab == bc && bc == ca;
}

/// How many edges of one cell cross triangles of another, but for those that they share a particle with.
inline std::int64_t crossings_of_cells(const ClothAt& of_edges, int edge_cell, const ClothAt& of_triangles, int cell) {
    const bool same = of_edges.number == of_triangles.number;
    const auto at = [](const ClothAt& cloth, int p) -> Vec3 { return cloth.x.row(p).transpose(); };
    std::int64_t count = 0;
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
    return count;
}

/// How many edges cross triangles that they share no particle with, in one cloth or between two: exactly, by testing
/// every pair of cells in some leaves whose boxes meet.
/// @param leaves of one cloth, each pair in one order only
inline std::int64_t crossings(const BoxedCloth& first, const BoxedCloth& second, std::span<const LeafPair> leaves) {
    const Grid &grid = first.cloth.grid, &other = second.cloth.grid;
    std::int64_t count = 0;
    const auto visit = [&](int one, int two, bool ordered) {
        if ((ordered && two < one) || !first.boxes.of(one).meets(second.boxes.of(two))) return;
        count += crossings_of_cells(first.cloth, one, second.cloth, two);
        if (!ordered || one != two) count += crossings_of_cells(second.cloth, two, first.cloth, one);
    };
    for (const auto& [cells, others] : leaves) {
        const bool ordered = first.cloth.number == second.cloth.number && cells == others;
        for_each_cell_of(cells, [&](int i, int j) {
            for_each_cell_of(others, [&](int k, int l) { visit(grid.cell(i, j), other.cell(k, l), ordered); });
        });
    }
    return count;
}

/// The same by testing every pair of cells.
inline std::int64_t crossings(const BoxedCloth& first, const BoxedCloth& second) {
    const LeafPair all{all_cells(first.cloth.grid), all_cells(second.cloth.grid)};
    return crossings(first, second, {&all, 1});
}

}  // namespace drape::test
