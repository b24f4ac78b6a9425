#pragma once

#include <chrono>

namespace drape {

/// Wall time on the steady clock.
class Stopwatch {
public:
    /// Seconds since the construction or the last `lap`; starts again from 0.
    double lap() {
        const auto now = Clock::now();
        const double seconds = std::chrono::duration<double>(now - start_).count();
        start_ = now;
        return seconds;
    }

    /// Seconds since the construction or the last `lap`.
    [[nodiscard]] double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

}  // namespace drape
