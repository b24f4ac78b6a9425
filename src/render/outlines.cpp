#include "outlines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>

#include "drape/base/assert.h"

namespace drape {
namespace {

/// Edges shorter than this fraction of the whole are not drawn.
constexpr Real shortest = Real(1e-4);

/// By this fraction of the whole, times their number, slabs beside the box are moved out: one that only touches an edge
/// of the others, as they do about a flat cloth, would draw that edge again.
constexpr Real hair = Real(1e-6);

/// The points p with low <= axis . p <= high.
struct Slab {
    std::array<int, 3> axis;
    Real low, high;
};

Vec3 direction(const Slab& slab) { return Eigen::Vector3i(slab.axis.data()).cast<Real>(); }

/// A line, from p along a direction, and the stretch of it that is left.
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

/// The edges of what slabs have in common, of which the first three are along the axes of space and so enclose it.
void append_polytope(std::span<const Slab> slabs, NodeState state, Outlines& outlines) {
    // As seen from the middle of the box, the box's half diagonal for unit
    const Vec3 low(slabs[0].low, slabs[1].low, slabs[2].low), high(slabs[0].high, slabs[1].high, slabs[2].high);
    const Vec3 middle = (low + high) / 2;
    const Real size = ((high - low) / 2).norm();
    if (size == 0) return;
    std::array<Slab, 13> body;
    for (std::size_t s = 0; s < slabs.size(); ++s) {
        const Real centre = direction(slabs[s]).dot(middle), out = s < 3 ? 0 : hair * static_cast<Real>(s);
        body[s] = {slabs[s].axis, (slabs[s].low - centre) / size - out, (slabs[s].high - centre) / size + out};
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

void append(const BoundingSphere& sphere, NodeState state, Outlines& outlines) {
    outlines.spheres.push_back({sphere.centre, sphere.radius, state});
}

void append(const Obb& box, NodeState state, Outlines& outlines) {
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

void append(const Aabb& box, NodeState state, Outlines& outlines) {
    append(Obb{Vec3::Zero(), BoxAxes::Identity(), box.low, box.high}, state, outlines);
}

template <int K>
void append(const KDop<K>& dop, NodeState state, Outlines& outlines) {
    std::array<Slab, K / 2> slabs;
    for (std::size_t k = 0; k < slabs.size(); ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        slabs[k].axis = dop_axes[static_cast<std::size_t>(dop_numbers<K>[k])];
        slabs[k].low = k < 3 ? dop.box.low[axis] : dop.low[k - 3];
        slabs[k].high = k < 3 ? dop.box.high[axis] : dop.high[k - 3];
    }
    append_polytope(slabs, state, outlines);
}

}  // namespace

void append_outline(const AnyVolume& volume, NodeState state, Outlines& outlines) {
    std::visit([&](const auto& body) { append(body, state, outlines); }, volume);
}

void append_nodes(std::span<const NodeView> nodes, Real slack, const TouchedCells& touched, Outlines& outlines) {
    const std::size_t first_sphere = outlines.spheres.size();
    for (const NodeView& node : nodes) append_outline(node.volume, touched.state_of(node), outlines);
    for (std::size_t k = first_sphere; k < outlines.spheres.size(); ++k) {
        outlines.spheres[k].radius += slack;
    }
}

}  // namespace drape
