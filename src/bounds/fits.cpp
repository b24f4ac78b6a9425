#include <array>
#include <type_traits>

#include "drape/base/assert.h"
#include "drape/bounds/cloth_quadtree.h"
#include "kernels/centroid_tree.h"
#include "kernels/vector_fits.h"

// Which fit runs: plain, or by vector kernels.

namespace drape {

BoundingSphere (*sphere_fit_of(SphereFit kind, Kernels kernels))(const Patch&) {
    const bool plain = kernels == Kernels::Plain;
    switch (kind) {
        case SphereFit::Centroid:
            return plain ? BoundingSphere::fit : kernels::fit_centroid_sphere;
        case SphereFit::BoxCentre:
            return plain ? fit_box_sphere : kernels::fit_box_sphere;
        case SphereFit::Ritter:
            return plain ? fit_ritter_sphere : kernels::fit_ritter_sphere;
        case SphereFit::Epos6:
            return plain ? fit_epos6_sphere : kernels::fit_epos_sphere<3>;
        case SphereFit::Epos14:
            return plain ? fit_epos14_sphere : kernels::fit_epos_sphere<7>;
        case SphereFit::Epos26:
            return plain ? fit_epos26_sphere : kernels::fit_epos_sphere<13>;
        case SphereFit::Welzl:
            return plain ? fit_smallest_sphere : kernels::fit_smallest_sphere;
    }
    DRAPE_ASSERT(false && "every kind has its fit");
    return nullptr;
}

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
