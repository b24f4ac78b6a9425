#include "drape/bounds/node_view.h"
#include "hierarchy_run.h"

namespace drape {
namespace {

Real size_of(const BoundingSphere& sphere) { return sphere.radius; }
Real size_of(const Aabb& box) { return (box.high - box.low).mean() / 2; }
Real size_of(const Obb& box) { return (box.high - box.low).mean() / 2; }

template <int K>
Real size_of(const KDop<K>& dop) {
    Real widths = (dop.box.high - dop.box.low).sum();
    for (std::size_t k = 0; k < KDop<K>::cuts; ++k) {
        widths += (dop.high[k] - dop.low[k]) / dop_length(dop_numbers<K>[k + 3]);
    }
    return widths / K;
}

Real size_of(const NodeView& node) {
    return std::visit([](const auto& volume) { return size_of(volume); }, node.volume);
}

}  // namespace

Tightness& Tightness::operator+=(const Tightness& other) {
    sum += other.sum;
    nodes += other.nodes;
    return *this;
}

std::vector<Tightness> tightness_of(const BroadPhase& hierarchy, const Grid& grid, const Points& x) {
    std::vector<Tightness> levels;
    for (int level = 0; level < hierarchy.levels(); ++level) {
        std::vector<NodeView> nodes;
        hierarchy.nodes_at(level, nodes);
        std::erase_if(nodes, [level](const NodeView& node) { return node.cells.level != level; });
        std::vector<NodeView> smallest = nodes;
        const auto kind = static_cast<VolumeKind>(nodes.front().volume.index());
        refit_nodes({.volume = kind, .sphere_fit = SphereFit::Welzl}, grid, x, smallest);
        Tightness& tightness = levels.emplace_back();
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            const Real least = size_of(smallest[n]);
            if (!(least > 0)) continue;
            const Real ratio = (size_of(nodes[n]) + hierarchy.slack()) / least;
            tightness += {static_cast<double>(ratio), 1};
        }
    }
    return levels;
}

Tightness over_levels(const std::vector<Tightness>& levels) {
    Tightness all;
    for (const Tightness& level : levels) all += level;
    return all;
}

}  // namespace drape
