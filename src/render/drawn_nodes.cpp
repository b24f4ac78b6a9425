#include "drawn_nodes.h"

#include <Eigen/Geometry>
#include <algorithm>
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
    Vec3 axis;
    Real low, high;
};

/// A line, from p along a direction, and the stretch of it that is left.
struct Line {
    Vec3 p, along;
    Real from = -std::numeric_limits<Real>::infinity();
    Real to = std::numeric_limits<Real>::infinity();

    void cut(const Slab& slab) {
        const Real rise = slab.axis.dot(along), start = slab.axis.dot(p);
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
        const Real centre = slabs[s].axis.dot(middle), out = s < 3 ? 0 : hair * static_cast<Real>(s);
        body[s] = {slabs[s].axis, (slabs[s].low - centre) / size - out, (slabs[s].high - centre) / size + out};
    }

    // An edge is what the other slabs leave of the line in which two faces meet
    for (std::size_t s = 0; s < slabs.size(); ++s) {
        for (std::size_t t = s + 1; t < slabs.size(); ++t) {
            for (const Real ds : {body[s].low, body[s].high}) {
                for (const Real dt : {body[t].low, body[t].high}) {
                    Line line = meeting(body[s].axis, ds, body[t].axis, dt);
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
        slabs[k].axis = Eigen::Vector3i(dop_axes[static_cast<std::size_t>(dop_numbers<K>[k])].data()).cast<Real>();
        slabs[k].low = k < 3 ? dop.box.low[axis] : dop.low[k - 3];
        slabs[k].high = k < 3 ? dop.box.high[axis] : dop.high[k - 3];
    }
    append_polytope(slabs, state, outlines);
}

}  // namespace

void append_outline(const AnyVolume& volume, Real slack, NodeState state, Outlines& outlines) {
    const auto append_body = [&](const auto& body) {
        if constexpr (std::is_same_v<std::decay_t<decltype(body)>, BoundingSphere>) {
            const auto radius = static_cast<float>(body.radius + slack);
            outlines.spheres.push_back({body.centre.template cast<float>(), radius, state});
        } else {
            append(body, state, outlines);
        }
    };
    std::visit(append_body, volume);
}

TouchedCells::TouchedCells(const Grid& grid, std::span<const ContactRow> contacts, bool tested,
                           std::span<const int> more)
    : columns_(grid.cell_columns()), tested_(tested), cells_(more.begin(), more.end()) {
    for (const ContactRow& contact : contacts) cells_.push_back(contact.triangle / 2);
    std::sort(cells_.begin(), cells_.end());
    cells_.erase(std::unique(cells_.begin(), cells_.end()), cells_.end());
}

bool TouchedCells::any_in(const CellRange& cells) const {
    for (int j = cells.j0; j < cells.j1; ++j) {
        const auto first = std::lower_bound(cells_.begin(), cells_.end(), j * columns_ + cells.i0);
        if (first != cells_.end() && *first < j * columns_ + cells.i1) return true;
    }
    return false;
}

NodeState TouchedCells::state_of(const NodeView& node) const {
    if (node.visit == NodeVisit::Unvisited) return NodeState::Unvisited;
    if (node.visit == NodeVisit::Pruned) return NodeState::Pruned;
    if (any_in(node.cells)) return NodeState::Touching;
    if (!tested_) return NodeState::Untested;
    return node.visit == NodeVisit::Entered ? NodeState::FalseInner : NodeState::FalseLeaf;
}

ShownLevel shown_level(const FrameView& view) {
    ShownLevel shown;
    for (const ClothView& cloth : view.cloths) shown.levels = std::max(shown.levels, cloth.hierarchy->levels());
    shown.level = std::clamp(view.settings->view.level, 0, std::max(shown.levels - 1, 0));
    shown.all = view.settings->view.level >= shown.levels;
    return shown;
}

void nodes_of_level(const BroadPhase& hierarchy, int level, std::vector<NodeView>& nodes) {
    hierarchy.nodes_at(level, nodes);
    std::erase_if(nodes, [level](const NodeView& node) { return node.cells.level != level; });
}

std::vector<NodeView> shown_nodes(const FrameView& view, const BroadPhase& hierarchy) {
    std::vector<NodeView> nodes, of_level;
    const ShownLevel shown = shown_level(view);
    if (!shown.all) hierarchy.nodes_at(shown.level, nodes);
    for (int level = 0; shown.all && level < hierarchy.levels(); ++level) {
        nodes_of_level(hierarchy, level, of_level);
        nodes.insert(nodes.end(), of_level.begin(), of_level.end());
    }
    return nodes;
}

void LevelCounts::add(std::span<const NodeView> added, const TouchedCells& touched) {
    nodes += static_cast<int>(added.size());
    for (const NodeView& node : added) {
        const NodeState state = touched.state_of(node);
        visited += node.visit != NodeVisit::Unvisited;
        pruned += node.visit == NodeVisit::Pruned;
        false_positives += state == NodeState::FalseInner || state == NodeState::FalseLeaf;
        touching += state == NodeState::Touching;
    }
}

}  // namespace drape
