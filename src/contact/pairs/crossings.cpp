#include "drape/contact/near_pairs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "cell_pairs.h"
#include "drape/contact/closest_point.h"

namespace drape {
namespace {

/// Six times the volume of the tetrahedron: its sign tells on which side of a, b, c the point d is; 0 where that is
/// rounding alone.
Real side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 u = b - a, v = c - a, w = d - a;
    const Real size = std::max({a.cwiseAbs().maxCoeff(), d.cwiseAbs().maxCoeff(), u.norm(), v.norm(), w.norm()});
    const Real rounding = 64 * std::numeric_limits<Real>::epsilon() * size * u.norm() * v.norm();
    const Real six_volumes = u.cross(v).dot(w);
    return std::abs(six_volumes) > rounding ? six_volumes : Real(0);
}

bool crosses(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
    if (!(side(a, b, c, p) * side(a, b, c, q) < 0)) return false;
    const Real ab = side(p, q, a, b), bc = side(p, q, b, c), ca = side(p, q, c, a);
    return (ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0);
}

/// The edges of one cell through the triangles of another.
std::int64_t through_cell(const ClothAt& of_edges, int edge_cell, const ClothAt& of_triangles, int cell) {
    std::int64_t count = 0;
    for (const int triangle : {2 * cell, 2 * cell + 1}) {
        const std::array<int, 3> t = of_triangles.grid.triangle_corners(triangle);
        for_each_edge_of(of_edges.grid, edge_cell, [&](int p, int q) {
            const bool share = std::ranges::count(t, p) + std::ranges::count(t, q) > 0;
            if (of_edges.number == of_triangles.number && share) return;
            const auto at = [&](std::size_t k) { return position(of_triangles.x, t[k]); };
            if (crosses(position(of_edges.x, p), position(of_edges.x, q), at(0), at(1), at(2))) ++count;
        });
    }
    return count;
}

}  // namespace

std::int64_t count_crossings(const BoxedCloth& first, const BoxedCloth& second, std::span<const LeafPair> leaves) {
    std::int64_t count = 0;
    for_each_pair_of_cells(first, second, leaves, [&](int one, int two) {
        count += through_cell(first.cloth, one, second.cloth, two);
        const bool same = first.cloth.number == second.cloth.number && one == two;
        if (!same) count += through_cell(second.cloth, two, first.cloth, one);
    });
    return count;
}

}  // namespace drape
