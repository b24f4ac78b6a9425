#include <algorithm>
#include <type_traits>

#include "drape/bounds/cloth_quadtree.h"
#include "kernels/patch_kernels.h"

// Which fit runs: plain, or by vector kernels.

namespace drape {
namespace {

/// What `Volume::fit` gives, to rounding.
template <BoundingVolume Volume>
Volume fit_by_kernels(const Patch& patch) {
    if constexpr (std::is_same_v<Volume, Aabb>) {
        Aabb box;
        kernels::dop_extents(patch, 3, box.low.data(), box.high.data());
        return box;
    } else if constexpr (std::is_same_v<Volume, Obb>) {
        Obb box = Obb::start(patch);
        kernels::extents_along(patch, box.origin, box.axes, box.low.data(), box.high.data());
        box.grow_by_rounding();
        return box;
    } else {
        constexpr std::size_t slabs = Volume::cuts + 3;
        std::array<Real, slabs> least, most;
        kernels::dop_extents(patch, static_cast<int>(slabs), least.data(), most.data());
        return Volume::from_extents(least, most);
    }
}

/// A few rows of all leaves side by side, then a few more, in the order in which particles are in memory: leaf by leaf,
/// rows of a large cloth drive each other out of the cache. A small cloth stays there.
void fit_leaf_boxes(const Grid& grid, std::span<const QuadtreeNode> nodes, std::span<const int> leaves, const Points& x,
                    std::span<Aabb> boxes) {
    const auto node = [&](int n) -> const QuadtreeNode& { return nodes[static_cast<std::size_t>(n)]; };
    while (!leaves.empty()) {
        const QuadtreeNode& first = node(leaves[0]);
        const auto end = std::ranges::find_if(leaves, [&](int n) { return node(n).j0 != first.j0; });
        const std::span<const int> beside(leaves.begin(), end);
        const int rows_at_once = grid.nx < 256 ? first.j1 - first.j0 + 1 : 4;
        for (int j = first.j0; j <= first.j1; j += rows_at_once) {
            for (const int leaf : beside) {
                const auto [i0, j0, i1, j1] = static_cast<const CellRange&>(node(leaf));
                const Aabb some =
                    fit_by_kernels<Aabb>(patch_of(grid, {i0, j, i1, std::min(j + rows_at_once - 1, j1)}, x));
                Aabb& box = boxes[static_cast<std::size_t>(leaf)];
                if (j == j0) box = some;
                box.include(some);
            }
        }
        leaves = leaves.subspan(beside.size());
    }
}

}  // namespace

template <BoundingVolume Volume>
Fits<Volume> fits_of(const BroadPhaseParameters& parameters) {
    const bool plain = parameters.kernels == Kernels::Plain;
    if constexpr (std::is_same_v<Volume, BoundingSphere>) {
        // Centroid spheres have a way to fit all levels at once
        const bool at_once = !plain && parameters.sphere_fit == SphereFit::Centroid;
        return {.patch = sphere_fit_of(parameters.sphere_fit, parameters.kernels),
                .tree = at_once ? kernels::fit_centroid_tree : nullptr};
    } else if constexpr (std::is_same_v<Volume, Aabb>) {
        if (plain) return {.patch = Aabb::fit};
        return {.patch = fit_by_kernels<Aabb>, .leaves = fit_leaf_boxes};
    } else {
        return {.patch = plain ? Volume::fit : fit_by_kernels<Volume>};
    }
}

void refit_nodes(const BroadPhaseParameters& parameters, const Grid& grid, const Points& x, std::span<NodeView> nodes) {
    if (parameters.volume == VolumeKind::Brute) return;
    with_volume(parameters.volume, [&]<class Volume>(std::type_identity<Volume>) {
        const auto fit = fits_of<Volume>(parameters).patch;
        for (NodeView& node : nodes) node.volume = fit(patch_of(grid, node.cells, x));
    });
}

template Fits<BoundingSphere> fits_of(const BroadPhaseParameters&);
template Fits<Aabb> fits_of(const BroadPhaseParameters&);
template Fits<KDop<6>> fits_of(const BroadPhaseParameters&);
template Fits<KDop<14>> fits_of(const BroadPhaseParameters&);
template Fits<KDop<18>> fits_of(const BroadPhaseParameters&);
template Fits<KDop<26>> fits_of(const BroadPhaseParameters&);
template Fits<Obb> fits_of(const BroadPhaseParameters&);

}  // namespace drape
