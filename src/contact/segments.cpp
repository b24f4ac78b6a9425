#include "drape/contact/closest_point.h"

#include <algorithm>
#include <limits>

namespace drape {
namespace {

/// The weight of q on a segment's line, of the point closest to p.
Real weight_within(const Vec3& p, const Vec3& from, const Vec3& direction, Real square) {
    return square > 0 ? std::clamp((p - from).dot(direction) / square, Real(0), Real(1)) : Real(0);
}

}  // namespace

ClosestOfSegments closest_of_segments(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 u = b - a, v = d - c;
    const Real uu = u.squaredNorm(), vv = v.squaredNorm();
    ClosestOfSegments best{.offset = a - c};
    Real least = std::numeric_limits<Real>::infinity();
    const auto take = [&](Real s, Real t) {
        const Vec3 offset = (a + s * u) - (c + t * v);
        const Real square = offset.squaredNorm();
        if (square < least) least = square, best = {s, t, offset};
    };

    // Each end, and where both are inside, the foot of the lines' common normal
    take(0, weight_within(a, c, v, vv));
    take(1, weight_within(b, c, v, vv));
    take(weight_within(c, a, u, uu), 0);
    take(weight_within(d, a, u, uu), 1);
    const Real uv = u.dot(v), across = uu * vv - uv * uv;
    // Of lines that are nearly parallel this has few digits: what it finds is taken only where it is nearer
    if (!(across > 0)) return best;
    const Vec3 w = a - c;
    const Real s = (uv * v.dot(w) - vv * u.dot(w)) / across;
    if (!(s > 0 && s < 1)) return best;
    const Real t = weight_within(a + s * u, c, v, vv);
    if (t > 0 && t < 1) take(s, t);
    return best;
}

}  // namespace drape
