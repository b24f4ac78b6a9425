#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace drape {

/// Median and quartiles of some numbers.
struct Quartiles {
    double lower = 0, median = 0, upper = 0;
};

/// In place of a number that there is not.
inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// @param values at least one; between two of them it is interpolated linearly
Quartiles quartiles_of(std::vector<double> values);

/// CPU time that this thread has used [s]. What others do on the machine does not count, but for the caches they share.
double thread_cpu_time();

/// CPU time that this thread takes for something [s], in the mean if it is done several times in a row.
template <class Work>
double cpu_time_of(const Work& work, std::int64_t runs = 1) {
    const double before = thread_cpu_time();
    for (std::int64_t run = 0; run < runs; ++run) work();
    return (thread_cpu_time() - before) / static_cast<double>(runs);
}

/// CPU time that all threads of the program have used [s].
double program_cpu_time();

}  // namespace drape
