#pragma once

#include <algorithm>
#include <ctime>

#include "drape/base/stopwatch.h"

namespace drape::peers {

/// How long a piece of work took on a machine that is shared: wall time, or the processor time of this program if that
/// is less, because the processor was lent to others meanwhile.
class WorkWatch {
public:
    [[nodiscard]] double seconds() const {
        const double wall = wall_.seconds();
        return std::min(wall, processor_seconds() - start_);
    }

private:
    static double processor_seconds() {
        timespec now{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
        return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
    }

    // In this order: the wall time is not to hold the call for the processor time
    double start_ = processor_seconds();
    Stopwatch wall_;
};

}  // namespace drape::peers
