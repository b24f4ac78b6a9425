#include "drape/contact/closest_point.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace drape {
namespace {

/// The point of a segment closest to p, as the weight of its end; 0 for a segment of no length.
/// @param square of the segment's length
Real weight_within(const Vec3& p, const Vec3& from, const Vec3& direction, Real square) {
    return square > 0 ? std::clamp((p - from).dot(direction) / square, Real(0), Real(1)) : Real(0);
}

ClosestPoint closest_point_on_edges(const Vec3& p, const std::array<Vec3, 3>& corners) {
    ClosestPoint best{corners[0], {1, 0, 0}};
    for (std::size_t from = 0; from < 3; ++from) {
        const std::size_t to = (from + 1) % 3;
        const Vec3 side = corners[to] - corners[from];
        const Real w = weight_within(p, corners[from], side, side.squaredNorm());
        const Vec3 point = corners[from] + w * side;
        if ((point - p).squaredNorm() >= (best.point - p).squaredNorm()) continue;
        best.point = point;
        best.barycentric = {0, 0, 0};
        best.barycentric[from] = 1 - w;
        best.barycentric[to] = w;
    }
    return best;
}

/// For a triangle that is much longer than high. Its height h over its longest side is found by subtracting what the
/// apex has along that side, twice, so that both are at right angles to the last digit however low h is. What is
/// rounded off moves the apex by no more than the last digits of the side, and the distance with it.
ClosestPoint closest_point_on_needle(const Vec3& p, const std::array<Vec3, 3>& corners) {
    std::size_t apex = 0;
    Real longest = 0;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const Real square = (corners[(corner + 2) % 3] - corners[(corner + 1) % 3]).squaredNorm();
        if (square > longest) longest = square, apex = corner;
    }
    const std::size_t from = (apex + 1) % 3, to = (apex + 2) % 3;
    const Vec3 side = corners[to] - corners[from], above = corners[apex] - corners[from];
    const auto along = [&](const Vec3& u) { return longest > 0 ? u.dot(side) / longest : Real(0); };
    const Real first = along(above);
    const Vec3 nearly = above - first * side;
    const Real rest = along(nearly);
    const Vec3 h = nearly - rest * side;

    // The foot of p is inside if all weights are positive
    const Vec3 offset = p - corners[from];
    const Real t = along(offset), square = h.squaredNorm();
    const Real of_apex = square > 0 ? (offset - t * side).dot(h) / square : Real(-1);
    const Real of_to = t - (first + rest) * of_apex, of_from = 1 - of_to - of_apex;
    if (!(of_apex >= 0 && of_to >= 0 && of_from >= 0)) return closest_point_on_edges(p, corners);
    ClosestPoint closest{corners[from] + t * side + of_apex * h, {}};
    closest.barycentric[apex] = of_apex;
    closest.barycentric[from] = of_from;
    closest.barycentric[to] = of_to;
    return closest;
}

/// Where the triangle is less than an eighth as high as long, or so small that products of four lengths have no digits:
/// the regions of edges and inside would cost digits.
bool is_needle(const Vec3& ab, const Vec3& ac, const Vec3& bc) {
    constexpr Real lowest = Real(1) / 64;
    constexpr Real smallest = std::numeric_limits<Real>::min() / std::numeric_limits<Real>::epsilon();
    const Real longest = std::max({ab.squaredNorm(), ac.squaredNorm(), bc.squaredNorm()});
    return !(ab.cross(ac).squaredNorm() > std::max(lowest * longest * longest, smallest));
}

}  // namespace

/// By the region of the plane that p is above: a corner, an edge or the inside; d1..d6 as in Ericson 2004, 5.1.5. The
/// denominators of the edges are their squared lengths.
ClosestPoint closest_point_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const Real d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d1 <= 0 && d2 <= 0) return {a, {1, 0, 0}};
    if (d3 >= 0 && d4 <= d3) return {b, {0, 1, 0}};
    if (d6 >= 0 && d5 <= d6) return {c, {0, 0, 1}};
    if (is_needle(ab, ac, c - b)) return closest_point_on_needle(p, {a, b, c});

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
    const Real sum = va + vb + vc, v = vb / sum, w = vc / sum;
    return {a + v * ab + w * ac, {1 - v - w, v, w}};
}

ClosestOfSegments closest_of_segments(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 u = b - a, v = d - c, w = a - c;
    const Real uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), across = uu * vv - uv * uv;
    ClosestOfSegments best{.offset = w};
    Real least = std::numeric_limits<Real>::infinity();
    const auto take = [&](Real s, Real t) {
        const Vec3 offset = (a + s * u) - (c + t * v);
        const Real square = offset.squaredNorm();
        if (square < least) least = square, best = {s, t, offset};
    };

    // The foot of the lines' common normal, where it is inside of both
    const Real s = across > 0 ? (uv * v.dot(w) - vv * u.dot(w)) / across : Real(0);
    const Real t = s > 0 && s < 1 ? weight_within(a + s * u, c, v, vv) : Real(0);
    const bool inside = t > 0 && t < 1;
    constexpr Real nearly_parallel = Real(5e9) * std::numeric_limits<Real>::epsilon();  // all are, in single precision
    if (inside && across > nearly_parallel * uu * vv) {
        take(s, t);
        return best;
    }
    take(0, weight_within(a, c, v, vv));
    take(1, weight_within(b, c, v, vv));
    take(weight_within(c, a, u, uu), 0);
    take(weight_within(d, a, u, uu), 1);
    // Of lines that are nearly parallel it has few digits: it is taken only where it is nearer than the ends
    if (inside) take(s, t);
    return best;
}

}  // namespace drape
