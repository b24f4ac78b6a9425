#pragma once

#include <ctime>

#include "drape/base/stopwatch.h"

namespace drape {

/// Frames per second and processor use, averaged over about a second.
class FrameMeter {
public:
    /// A frame has been drawn.
    void count();

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
