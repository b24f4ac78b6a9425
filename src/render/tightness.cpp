#include "tightness.h"

#include <limits>

#include "drape/bounds/sphere_fits.h"

namespace drape {

double tightness(const NodeView& node, Real slack, const Grid& grid, const Points& x) {
    const auto radius_of = [](const auto& volume) { return volume.sphere().radius; };
    const Real least = fit_smallest_sphere(patch_of(grid, node.cells, x)).radius;
    const Real radius = std::visit(radius_of, node.volume) + slack;
    return least > 0 ? static_cast<double>(radius / least) : std::numeric_limits<double>::infinity();
}

std::span<const double> LevelTightness::look(const FrameView& view, int levels) {
    const BroadPhaseParameters parameters = broad_phase_of(*view.settings);
    const bool same = parameters_ == parameters && means_.size() == static_cast<std::size_t>(levels);
    ++frames_;
    const bool waits = frames_ < frames_between && !view.paused;
    if (same && (waits || view.report->step == step_)) return means_;
    parameters_ = parameters;
    step_ = view.report->step;
    frames_ = 0;
    means_.assign(static_cast<std::size_t>(levels), 0);
    for (std::size_t level = 0; level < means_.size(); ++level) {
        double sum = 0, count = 0;
        for (const ClothView& cloth : view.cloths) {
            nodes_of_level(*cloth.hierarchy, static_cast<int>(level), nodes_);
            for (const NodeView& node : nodes_) {
                sum += tightness(node, cloth.hierarchy->slack(), cloth.model.grid, cloth.x);
                ++count;
            }
        }
        means_[level] = count > 0 ? sum / count : 0;
    }
    return means_;
}

}  // namespace drape
