#include "drape/bounds/outlines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "drape/base/assert.h"

namespace drape {
namespace {

/// Edges shorter than this part of the whole are not drawn.
constexpr Real shortest = Real(1e-4);

/// By this part of the whole, times their number, slabs beside the box are moved out: one that only touches an edge of
/// the others, as they do about a flat cloth, would draw that edge again.
constexpr Real hair = Real(1e-6);

Vec3 direction(const Slab& slab) { return Eigen::Vector3i(slab.axis.data()).cast<Real>(); }

/// A line, from p along a direction, and the part of it that is left.
struct Line {
    Vec3 p, along;
    Real from = -std::numeric_limits<Real>::infinity();
    Real to = std::numeric_limits<Real>::infinity();

    void cut(const Slab& slab) {
        const Vec3 axis = direction(slab);
        const Real rise = axis.dot(along), start = axis.dot(p);
        if (rise == 0) {
            if (start < slab.low || start > slab.high) to = from;
            return;
        }
        const Real a = (slab.low - start) / rise, b = (slab.high - start) / rise;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
};

/// Where the planes a . p = da and b . p = db meet. @pre not parallel
Line meeting(const Vec3& a, Real da, const Vec3& b, Real db) {
    const Vec3 along = a.cross(b);
    DRAPE_ASSERT(along.squaredNorm() > 0);
    return {(da * b.cross(along) + db * along.cross(a)) / along.squaredNorm(), along};
}

}  // namespace

void append_box(const BoxShape& box, NodeState state, Outlines& outlines) {
    const auto corner = [&](const Vec3& t) { return Vec3(box.origin + box.axes * t); };
    for (int along = 0; along < 3; ++along) {
        if (!(box.high[along] > box.low[along])) continue;
        const int u = (along + 1) % 3, v = (along + 2) % 3;
        for (int which = 0; which < 4; ++which) {
            Vec3 from = box.low;
            if (which & 1) from[u] = box.high[u];
            if (which & 2) from[v] = box.high[v];
            Vec3 to = from;
            to[along] = box.high[along];
            outlines.edges.push_back({corner(from), corner(to), state});
        }
    }
}

void append_polytope(std::span<const Slab> slabs, NodeState state, Outlines& outlines) {
    constexpr std::size_t most = 13;
    DRAPE_ASSERT(slabs.size() >= 3 && slabs.size() <= most);
    for (std::size_t s = 0; s < 3; ++s) DRAPE_ASSERT(direction(slabs[s]) == Vec3(Vec3::Unit(static_cast<int>(s))));

    // As seen from the middle of the box, the box's half diagonal for unit
    const Vec3 low(slabs[0].low, slabs[1].low, slabs[2].low), high(slabs[0].high, slabs[1].high, slabs[2].high);
    const Vec3 middle = (low + high) / 2;
    const Real size = ((high - low) / 2).norm();
    if (size == 0) return;
    std::array<Slab, most> body;
    for (std::size_t s = 0; s < slabs.size(); ++s) {
        const Real place = direction(slabs[s]).dot(middle), out = s < 3 ? 0 : hair * static_cast<Real>(s);
        body[s] = {slabs[s].axis, (slabs[s].low - place) / size - out, (slabs[s].high - place) / size + out};
    }

    // An edge is what the other slabs leave of the line in which two faces meet
    for (std::size_t s = 0; s < slabs.size(); ++s) {
        for (std::size_t t = s + 1; t < slabs.size(); ++t) {
            for (const Real ds : {body[s].low, body[s].high}) {
                for (const Real dt : {body[t].low, body[t].high}) {
                    Line line = meeting(direction(body[s]), ds, direction(body[t]), dt);
                    for (std::size_t other = 0; other < slabs.size() && line.from < line.to; ++other) {
                        if (other != s && other != t) line.cut(body[other]);
                    }
                    if (!((line.to - line.from) * line.along.norm() > shortest)) continue;
                    outlines.edges.push_back({middle + size * (line.p + line.from * line.along),
                                              middle + size * (line.p + line.to * line.along), state});
                }
            }
        }
    }
}

}  // namespace drape
