#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "drape/sim/step_report.h"

namespace drape {

/// The time of each stage as the median over the last steps of which a picture was made: a single pause of the machine
/// does not show.
class StepMedians {
public:
    static constexpr std::size_t most = 31;  ///< half a second of pictures

    /// Keeps the times of a picture's step, once; a run that has begun again begins here again.
    void keep(const StepReport& report) {
        if (report.step < step_) kept_in_all_ = 0;
        if (report.step != step_) kept_[kept_in_all_++ % most] = report.times;
        step_ = report.step;
    }

    /// A report with the medians in place of its times.
    [[nodiscard]] StepReport with_median_times(const StepReport& report) const {
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

private:
    static constexpr double StageTimes::*stages[] = {&StageTimes::step,   &StageTimes::build, &StageTimes::traverse,
                                                     &StageTimes::narrow, &StageTimes::pairs, &StageTimes::respond};

    std::array<StageTimes, most> kept_{};
    std::size_t kept_in_all_ = 0;
    std::int64_t step_ = 0;  ///< of the last one
};

}  // namespace drape
