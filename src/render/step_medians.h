#pragma once

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
    void keep(const StepReport& report);

    /// A report with the medians in place of its times.
    [[nodiscard]] StepReport with_median_times(const StepReport& report) const;

private:
    std::array<StageTimes, most> kept_{};
    std::size_t kept_in_all_ = 0;
    std::int64_t step_ = 0;  ///< of the last one
};

}  // namespace drape
