#include <type_traits>

#include "drape/bounds/cloth_quadtree.h"
#include "kernels/centroid_tree.h"
#include "kernels/vector_fits.h"

namespace drape {

template <BoundingVolume Volume>
Fits<Volume> fits_of(const BroadPhaseParameters& parameters) {
    const bool plain = parameters.kernels == Kernels::Plain;
    if constexpr (std::is_same_v<Volume, BoundingSphere>) {
        // Centroid spheres have a way to fit all levels at once
        const bool at_once = !plain && parameters.sphere_fit == SphereFit::Centroid;
        return {.patch = sphere_fit_of(parameters.sphere_fit, parameters.kernels),
                .tree = at_once ? kernels::fit_centroid_tree : nullptr};
    } else {
        return {.patch = plain ? Volume::fit : kernels::fit<Volume>};
    }
}

template Fits<BoundingSphere> fits_of(const BroadPhaseParameters&);
template Fits<Aabb> fits_of(const BroadPhaseParameters&);
template Fits<KDop<6>> fits_of(const BroadPhaseParameters&);
template Fits<KDop<14>> fits_of(const BroadPhaseParameters&);
template Fits<KDop<18>> fits_of(const BroadPhaseParameters&);
template Fits<KDop<26>> fits_of(const BroadPhaseParameters&);
template Fits<Obb> fits_of(const BroadPhaseParameters&);

}  // namespace drape
