#pragma once

#include <span>

#include "drape/bounds/broad_phase.h"

namespace drape {

/// A proof that a cloth touches no ball, carried from one build into the steps after it. The root's volume contains
/// every particle of the positions that the tree was built from; grown by d, it contains them wherever they go within
/// d: while no ball overlaps the grown root, nothing can touch, whatever moved cloth and balls in between.
class Separation {
public:
    Separation() = default;

    /// Makes room, so that `renew` does not allocate.
    explicit Separation(const Grid& grid, Kernels kernels) : kernels_(kernels), kept_(grid.particles(), 3) {}

    /// Keeps the positions of the build that was just made, unless a ball may touch them: the proof has failed then.
    /// @param balls as the cloth's `thickness` [m] grows them
    /// @par Cost O(balls), and O(particles) where nothing touches
    void renew(const BroadPhase& tree, const Points& x, std::span<const Ball> balls, Real thickness);

    /// True only if no triangle of the cloth at `x` can touch a ball. @pre no build since `renew` or `forget`
    /// @par Cost O(particles), one pass; nothing where the last proof failed
    [[nodiscard]] bool holds(const BroadPhase& tree, const Points& x, std::span<const Ball> balls,
                             Real thickness) const;

    /// To be called when the tree was built from other positions, or is another.
    void forget() { kept_is_apart_ = false; }

private:
    Kernels kernels_ = Kernels::Vector;
    bool kept_is_apart_ = false;
    Points kept_;  ///< what the tree was built from
};

}  // namespace drape
