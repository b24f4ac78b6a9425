#include "stretch_stage.h"

#include <algorithm>

#include "drape/base/stopwatch.h"

namespace drape {
namespace {

/// Of its rest length, by how much more than its limit a spring is far beyond a small one: soft springs are stretched
/// so far by a ball that is led into them.
constexpr Real far = Real(0.1);

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
        over = over || excess > std::max(cloth.model.stretch_limit, far);
    }
    report.worst_stretch_excess = std::max(report.worst_stretch_excess, report.stretch_excess);
    if (over) report.overstretched += dt;
}

}  // namespace drape
