#include "drape/contact/closest_point.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace drape {
namespace {

/// The point of segment a, b closest to p, as the weight of b; 0 for a segment of no length.
Real weight_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 ab = b - a;
    const Real square = ab.squaredNorm();
    return square > 0 ? std::clamp((p - a).dot(ab) / square, Real(0), Real(1)) : Real(0);
}

/// For a triangle that has next to no area: the closest of the three edges.
ClosestPoint closest_point_on_edges(const Vec3& p, const std::array<Vec3, 3>& corners) {
    ClosestPoint best{corners[0], {1, 0, 0}};
    for (std::size_t from = 0; from < 3; ++from) {
        const std::size_t to = (from + 1) % 3;
        const Real w = weight_on_segment(p, corners[from], corners[to]);
        const Vec3 point = corners[from] + w * (corners[to] - corners[from]);
        if ((point - p).squaredNorm() >= (best.point - p).squaredNorm()) continue;
        best.point = point;
        best.barycentric = {0, 0, 0};
        best.barycentric[from] = 1 - w;
        best.barycentric[to] = w;
    }
    return best;
}

}  // namespace

ClosestPoint closest_point_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    // Regions of the corners a, b, c (Ericson 2004, section 5.1.5; d1..d6 as there)
    const Vec3 ab = b - a, ac = c - a, ap = p - a;
    const Real d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0) return {a, {1, 0, 0}};
    const Vec3 bp = p - b;
    const Real d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3) return {b, {0, 1, 0}};
    const Vec3 cp = p - c;
    const Real d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6) return {c, {0, 0, 1}};

    // Where the sine at corner a has no digit left, the regions are noise
    constexpr Real sliver = std::numeric_limits<Real>::epsilon();
    if (ab.cross(ac).squaredNorm() <= sliver * ab.squaredNorm() * ac.squaredNorm()) {
        return closest_point_on_edges(p, {a, b, c});
    }

    // Regions of the edges; each denominator is the squared length of its edge
    const Real vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) {
        const Real w = d1 / (d1 - d3);
        return {a + w * ab, {1 - w, w, 0}};
    }
    if (vb <= 0 && d2 >= 0 && d6 <= 0) {
        const Real w = d2 / (d2 - d6);
        return {a + w * ac, {1 - w, 0, w}};
    }
    if (va <= 0 && d4 >= d3 && d5 >= d6) {
        const Real w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {b + w * (c - b), {0, 1 - w, w}};
    }

    // Inside
    const Real sum = va + vb + vc;
    const Real v = vb / sum, w = vc / sum;
    return {a + v * ab + w * ac, {1 - v - w, v, w}};
}

}  // namespace drape
