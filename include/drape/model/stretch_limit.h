#pragma once

#include "drape/model/cloth_model.h"

namespace drape {

/// How far beyond its limit a structural spring may stay stretched [of its rest length], and the most sweeps that are
/// made to get there.
constexpr Real stretch_tolerance = Real(1e-3);
constexpr int max_stretch_sweeps = 96;

/// What sweeps over the structural springs have come to.
struct StretchReport {
    Real excess = 0;  ///< largest stretch of a spring beyond the limit, of its rest length; 0: none
    int sweeps = 0;
};

/// The largest relative elongation |d|/L0 - 1 over the structural springs.
[[nodiscard]] Real largest_stretch(const ClothModel& model, const Points& x);

/// By how much the most stretched structural spring exceeds the model's limit, of its rest length; 0: none does, or
/// there is no limit.
/// @par Cost one pass over two springs a particle; nothing without a limit
[[nodiscard]] Real stretch_excess(const ClothModel& model, const Points& x);

/// Shortens structural springs that are stretched beyond the model's limit, L > (1 + limit) L0, in sweeps over all of
/// them in a fixed order (Gauss-Seidel), until the largest excess is within the tolerance, or the sweeps are used up.
/// Each such spring
/// - draws its ends together to the limit, each by its share of the inverse masses: the centre of mass stays
///   @cite provot1995;
/// - gives them the impulse, in the same shares, that stops them from moving apart, and none if they do not: momentum
///   stays, and kinetic energy is only taken @cite bridson2002.
///
/// (A change of the velocity by displacement / h, which Provot's scheme comes to, is the same for what a step has
/// stretched, but throws the cloth about where contact, a hand or a change of the limit has.)
/// Pinned particles never move: a distance between them that is too long stays in the report.
/// @param held particle that is led from outside: it is as one that is pinned, but gives way like a free one in the
/// second half of the sweeps; below 0: none
/// @pre the state is finite
/// @par Cost that of `stretch_excess` while nothing is overstretched; else O(n) a sweep. Allocates nothing
StretchReport limit_stretch(const ClothModel& model, int held, ClothState& state);

}  // namespace drape
