#include "step_medians.h"

#include <algorithm>

namespace drape {

namespace {

constexpr double StageTimes::*stages[] = {&StageTimes::step,   &StageTimes::build, &StageTimes::traverse,
                                          &StageTimes::narrow, &StageTimes::pairs, &StageTimes::respond};

}  // namespace

void StepMedians::keep(const StepReport& report) {
    if (report.step < step_) kept_in_all_ = 0;
    if (report.step != step_) kept_[kept_in_all_++ % most] = report.times;
    step_ = report.step;
}

StepReport StepMedians::with_median_times(const StepReport& report) const {
    StepReport steady = report;
    const std::size_t count = std::min(kept_in_all_, most);
    if (count == 0) return steady;
    for (double StageTimes::*const stage : stages) {
        std::array<double, most> times{};
        for (std::size_t k = 0; k < count; ++k) times[k] = kept_[k].*stage;
        auto* const middle = times.data() + count / 2;
        std::nth_element(times.data(), middle, times.data() + count);
        steady.times.*stage = *middle;
    }
    return steady;
}

}  // namespace drape
