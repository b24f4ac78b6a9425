#pragma once

#include "drape/contact/tile_motion.h"

namespace drape::kernels {

// As the functions of the same names with `Kernels::Vector`, and with the bits of the plain ones.

void sum_tiles(const Tiles& tiles, const Points& before, const Points& now, std::span<TileSums> sums);
bool find_reaches(const ParticleMotion& motion, Real least, Real factor, ReachSpans<const Real> allowed,
                  ReachSpans<Real> reaches, ReachSpans<Real> strayed);
bool are_within(const ParticleMotion& motion, Real margin, std::span<const Real> local_reaches);

}  // namespace drape::kernels
