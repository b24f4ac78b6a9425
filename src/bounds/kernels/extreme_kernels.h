#pragma once

#include <array>
#include <cstddef>

#include "drape/bounds/bounding_volume.h"

/// Loops that find particles, vectorised as those of `patch_kernels.h` and with the same bits on every processor.
namespace drape::kernels {

/// The index of a particle in the arrays of a patch. Of several that are equally far out, the first counts.
using ParticleIndex = std::ptrdiff_t;

/// The particle that is farthest from a point.
ParticleIndex farthest_particle(const Patch& patch, const Vec3& from);

struct Extremes {
    ParticleIndex low, high;
};

/// The particles at both ends along a direction.
Extremes extreme_particles(const Patch& patch, const std::array<int, 3>& direction);

}  // namespace drape::kernels
