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
        return {.patch = fit_by_kernels<Aabb>, .leaves = kernels::fit_leaf_boxes};
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
