#include "stretch_stage.h"

#include <algorithm>

#include "drape/base/stopwatch.h"

namespace drape {
namespace {

/// Excess beyond a small stretch limit, as a fraction of the rest length, from which a spring counts as overstretched.
/// A ball that moves into soft springs stretches them by nearly this much.
constexpr Real large_excess = Real(0.1);

}  // namespace

void limit_stretch(std::span<Cloth> cloths, StepReport& report) {
    Stopwatch watch;
    for (Cloth& cloth : cloths) {
        const StretchReport left = cloth.energy.limit_stretch(cloth.model, cloth.held, cloth.state);
        if (left.sweeps > 0) cloth.search.positions_changed();
    }
    report.times.step += watch.lap();
}

void measure_stretch(std::span<const Cloth> cloths, double dt, StepReport& report) {
    report.stretch_excess = 0;
    bool over = false;
    for (const Cloth& cloth : cloths) {
        const Real excess = stretch_excess(cloth.model, cloth.state.x);
        report.stretch_excess = std::max(report.stretch_excess, static_cast<double>(excess));
        over = over || excess > std::max(cloth.model.stretch_limit, large_excess);
    }
    report.worst_stretch_excess = std::max(report.worst_stretch_excess, report.stretch_excess);
    if (over) report.overstretched += dt;
}

}  // namespace drape
