#include "tightness.h"

#include <algorithm>
#include <limits>

#include "drape/base/stopwatch.h"
#include "drape/bounds/node_view.h"
#include "drape/bounds/sphere_fits.h"

namespace drape {

double tightness(const NodeView& node, Real slack, const Grid& grid, const Points& x) {
    const auto radius_of = [](const auto& volume) { return volume.sphere().radius; };
    const Real least = fit_smallest_sphere(patch_of(grid, node.cells, x)).radius;
    const Real radius = std::visit(radius_of, node.volume) + slack;
    return least > 0 ? static_cast<double>(radius / least) : std::numeric_limits<double>::infinity();
}

std::span<const LevelFit> LevelFits::look(const FrameView& view, int levels) {
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

// The time is the least of some
LevelFit LevelFits::fit_of(const FrameView& view, int level) {
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

}  // namespace drape
