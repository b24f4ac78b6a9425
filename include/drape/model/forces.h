#pragma once

#include "drape/model/cloth_model.h"

namespace drape {

/// The force on every particle: gravity, springs, air drag and wind.
/// Each spring is evaluated once, as a stencil over rows of contiguous coordinates; a spring of zero length gives no
/// force.
/// @param x n x 3 [m]
/// @param v n x 3 [m/s]
/// @param f n x 3 [N], overwritten; forces on pinned particles are computed and are the caller's to ignore
/// @pre the three have the model's number of rows
/// @par Cost O(n), no allocation
void compute_forces(const ClothModel& model, const Points& x, const Points& v, Points& f);

/// a = f / m, and zero for pinned particles.
/// @param f n x 3 [N] on entry, [m/s^2] on return
void forces_to_accelerations(const ClothModel& model, Points& f);

}  // namespace drape
