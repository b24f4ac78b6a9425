#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <limits>
#include <vector>

#include "drape/base/assert.h"

namespace drape {

/// Median and quartiles of some numbers.
struct Quartiles {
    double lower = 0, median = 0, upper = 0;
};

/// In place of a number that there is not.
inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// @param values at least one; between two of them it is interpolated linearly
inline Quartiles quartiles_of(std::vector<double> values) {
    DRAPE_ASSERT(!values.empty());
    std::sort(values.begin(), values.end());
    const auto at = [&values](double part) {
        const double rank = part * static_cast<double>(values.size() - 1);
        const auto below = static_cast<std::size_t>(rank), above = std::min(below + 1, values.size() - 1);
        return std::lerp(values[below], values[above], rank - std::floor(rank));
    };
    return {at(0.25), at(0.5), at(0.75)};
}

/// What a clock of the system says [s].
inline double seconds_on(clockid_t clock) {
    std::timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// CPU time that this thread has used [s]. What others do on the machine does not count, but for the caches they share.
inline double thread_cpu_time() { return seconds_on(CLOCK_THREAD_CPUTIME_ID); }

/// CPU time that this thread takes for something [s], in the mean if it is done several times in a row.
template <class Work>
double cpu_time_of(const Work& work, std::int64_t runs = 1) {
    const double before = thread_cpu_time();
    for (std::int64_t run = 0; run < runs; ++run) work();
    return (thread_cpu_time() - before) / static_cast<double>(runs);
}

/// CPU time that all threads of the program have used [s].
inline double program_cpu_time() { return seconds_on(CLOCK_PROCESS_CPUTIME_ID); }

}  // namespace drape
