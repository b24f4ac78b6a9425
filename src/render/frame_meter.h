#pragma once

#include <ctime>

#include "drape/base/stopwatch.h"

namespace drape {

/// Frames per second and processor use, averaged over about a second.
class FrameMeter {
public:
    /// A frame has been drawn.
    void count() {
        ++frames_;
        const double elapsed = watch_.seconds();
        const bool over = elapsed >= 1;
        if (!over && !first_second_) return;

        // In the first second, what there is so far
        const double processor = static_cast<double>(std::clock() - processor_start_) / CLOCKS_PER_SEC;
        if (elapsed > 0) {
            rate_ = frames_ / elapsed;
            cpu_ = processor / elapsed;
        }
        if (!over) return;
        begin_again();
        first_second_ = false;
    }

    /// The pictures so far came now and then: the average begins again with this one.
    void begin_again() {
        first_second_ = true;
        frames_ = 0;
        processor_start_ = std::clock();
        watch_.lap();
    }

    [[nodiscard]] double rate() const { return rate_; }
    [[nodiscard]] double cpu() const { return cpu_; }

private:
    Stopwatch watch_;
    std::clock_t processor_start_ = std::clock();
    int frames_ = 0;
    bool first_second_ = true;
    double rate_ = 0, cpu_ = 0;
};

}  // namespace drape
