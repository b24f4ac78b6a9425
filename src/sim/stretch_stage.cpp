#include "stretch_stage.h"

#include <algorithm>

#include "drape/base/stopwatch.h"

namespace drape {

void limit_stretch(std::span<Cloth> cloths, StepReport& report) {
    Stopwatch watch;
    for (Cloth& cloth : cloths) {
        const StretchReport left = cloth.energy.limit_stretch(cloth.model, cloth.held, cloth.state);
        if (left.sweeps > 0) cloth.search.positions_changed();
        report.stretch_excess = std::max(report.stretch_excess, static_cast<double>(left.excess));
    }
    report.times.step += watch.lap();
}

}  // namespace drape
