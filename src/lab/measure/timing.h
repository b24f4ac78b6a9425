#pragma once

#include <vector>

namespace drape {

/// Median and quartiles of some numbers.
struct Quartiles {
    double lower = 0, median = 0, upper = 0;
};

/// @param values at least one; between two of them it is interpolated linearly
Quartiles quartiles_of(std::vector<double> values);

/// CPU time that this thread has used [s]. What others do on the machine does not count, but for the caches they share.
double thread_cpu_time();

/// CPU time that all threads of the program have used [s].
double program_cpu_time();

}  // namespace drape
