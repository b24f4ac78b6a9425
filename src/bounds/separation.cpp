#include "drape/bounds/separation.h"

#include <algorithm>

#include "drape/bounds/leaf_copies.h"

namespace drape {
namespace {

bool none_overlaps(const BroadPhase& tree, std::span<const Ball> balls, Real thickness, Real displacement) {
    return std::ranges::none_of(balls,
                                [&](const Ball& ball) { return tree.may_touch(grown(ball, thickness), displacement); });
}

}  // namespace

void Separation::renew(const BroadPhase& tree, const Points& x, std::span<const Ball> balls, Real thickness) {
    kept_is_apart_ = none_overlaps(tree, balls, thickness, 0);
    if (kept_is_apart_) kept_ = x;
}

bool Separation::holds(const BroadPhase& tree, const Points& x, std::span<const Ball> balls, Real thickness) const {
    return kept_is_apart_ && none_overlaps(tree, balls, thickness, largest_displacement(x, kept_, kernels_));
}

}  // namespace drape
