#include "hierarchy_run.h"

#include "drape/bounds/cloth_quadtree.h"

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

template <class Volume>
bool add(const BroadPhase& hierarchy, const Grid& grid, const Points& x, std::vector<Tightness>& levels) {
    const auto* tree = dynamic_cast<const ClothQuadtree<Volume>*>(&hierarchy);
    if (tree == nullptr) return false;
    const auto smallest = fits_of<Volume>({.sphere_fit = SphereFit::Welzl});
    levels.resize(std::max(levels.size(), static_cast<std::size_t>(tree->levels())));
    for (std::size_t n = 0; n < tree->nodes().size(); ++n) {
        const QuadtreeNode& node = tree->nodes()[n];
        const Real least = size_of(smallest.patch(patch_of(grid, node, x)));
        if (!(least > 0)) continue;
        const Real ratio = (size_of(tree->volumes()[n]) + tree->slack()) / least;
        levels[static_cast<std::size_t>(node.level)] += {static_cast<double>(ratio), 1};
    }
    return true;
}

template <class... Volumes>
void add_of_any(const BroadPhase& hierarchy, const Grid& grid, const Points& x, std::vector<Tightness>& levels) {
    (add<Volumes>(hierarchy, grid, x, levels) || ...);
}

}  // namespace

Tightness& Tightness::operator+=(const Tightness& other) {
    sum += other.sum;
    nodes += other.nodes;
    return *this;
}

void add_tightness(const BroadPhase& hierarchy, const Grid& grid, const Points& x, std::vector<Tightness>& levels) {
    add_of_any<BoundingSphere, Aabb, KDop<6>, KDop<14>, KDop<18>, KDop<26>, Obb>(hierarchy, grid, x, levels);
}

Tightness over_levels(const std::vector<Tightness>& levels) {
    Tightness all;
    for (const Tightness& level : levels) all += level;
    return all;
}

}  // namespace drape
