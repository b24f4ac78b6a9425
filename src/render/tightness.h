#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "drape/base/stopwatch.h"
#include "drape/bounds/node_view.h"
#include "drape/bounds/sphere_fits.h"
#include "node_states.h"

namespace drape {

/// How much larger a node's volume is than it must be: the radius of its sphere (of the sphere about it, for another
/// volume), with the hierarchy's slack, over that of the smallest sphere about its particles.
/// @param x n x 3 [m]
inline double tightness(const NodeView& node, Real slack, const Grid& grid, const Points& x) {
    const auto radius_of = [](const auto& volume) { return volume.sphere().radius; };
    const Real least = fit_smallest_sphere(patch_of(grid, node.cells, x)).radius;
    const Real radius = std::visit(radius_of, node.volume) + slack;
    return least > 0 ? static_cast<double>(radius / least) : std::numeric_limits<double>::infinity();
}

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
    std::span<const LevelFit> look(const FrameView& view, int levels) {
        const BroadPhaseParameters parameters = broad_phase_of(*view.settings);
        const bool same = parameters_ == parameters && fits_.size() == static_cast<std::size_t>(levels);
        ++frames_;
        const bool waits = frames_ < frames_between && !view.paused;
        if (same && (waits || view.report->step == step_)) return fits_;
        parameters_ = parameters;
        step_ = view.report->step;
        frames_ = 0;
        fits_.clear();
        for (int level = 0; level < levels; ++level) fits_.push_back(fit_of(view, level));
        return fits_;
    }

private:
    static constexpr int frames_between = 30;

    // The time is the least of some
    LevelFit fit_of(const FrameView& view, int level) {
        constexpr int repetitions = 3;
        LevelFit fit;
        double count = 0;
        for (const ClothView& cloth : view.cloths) {
            nodes_of_level(*cloth.hierarchy, level, nodes_);
            for (const NodeView& node : nodes_) {
                fit.tightness += tightness(node, cloth.hierarchy->slack(), cloth.model.grid, cloth.x);
                ++count;
            }
            double least = std::numeric_limits<double>::infinity();
            for (int r = 0; r < repetitions; ++r) {
                const Stopwatch watch;
                refit_nodes(*parameters_, cloth.model.grid, cloth.x, nodes_);
                least = std::min(least, watch.seconds());
            }
            fit.seconds += least;
        }
        if (count > 0) fit.tightness /= count;
        return fit;
    }

    std::vector<LevelFit> fits_;
    std::vector<NodeView> nodes_;
    std::optional<BroadPhaseParameters> parameters_;  ///< of the last look
    std::int64_t step_ = -1;
    int frames_ = 0;
};

}  // namespace drape
