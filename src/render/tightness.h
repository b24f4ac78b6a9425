#pragma once

#include <optional>
#include <span>
#include <vector>

#include "node_states.h"

namespace drape {

/// How much larger a node's volume is than it must be: the radius of its sphere (of the sphere about it, for another
/// volume), with the hierarchy's slack, over that of the smallest sphere about its particles.
/// @param x n x 3 [m]
double tightness(const NodeView& node, Real slack, const Grid& grid, const Points& x);

/// How well and how fast the nodes of a level are fitted.
struct LevelFit {
    double tightness = 0;  ///< mean of the nodes, over all cloths
    double seconds = 0;    ///< that it takes to fit them all, each to its own particles
};

/// The fits of all levels; looked at again now and then while the cloth moves, and at once where it has stopped, or for
/// another hierarchy.
class LevelFits {
public:
    /// @return one for each level, valid until the next call
    /// @par Cost O(particles) a level, about fifteen passes, in one of `frames_between` frames
    std::span<const LevelFit> look(const FrameView& view, int levels);

private:
    static constexpr int frames_between = 30;

    LevelFit fit_of(const FrameView& view, int level);

    std::vector<LevelFit> fits_;
    std::vector<NodeView> nodes_;
    std::optional<BroadPhaseParameters> parameters_;  ///< of the last look
    std::int64_t step_ = -1;
    int frames_ = 0;
};

}  // namespace drape
