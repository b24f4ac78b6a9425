#pragma once

#include "drape/contact/near_pairs.h"

namespace drape {

/// Whether the distance of two features is no more than rounding, and the direction between them says nothing.
[[nodiscard]] bool is_rounding(const ClothAt& first, const ClothAt& second, const NearPair& pair);

/// The direction in which two features that touch at distance 0 are to part, from the second to the first: across the
/// triangle, or across both edges. The first goes to the side on which the cloth about it is. Where that is on neither,
/// because surfaces lie in each other, a rule decides that holds all over them: the cloth of the lower number, or of
/// one cloth the lower particle, has the other in front of it.
/// @pre located, but for its normal
/// @return length 1
[[nodiscard]] Vec3 separation_direction(const ClothAt& first, const ClothAt& second, const NearPair& pair);

}  // namespace drape
