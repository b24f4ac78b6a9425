#include "statistics.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "drape/base/assert.h"

namespace drape {
namespace {

double seconds_of(clockid_t clock) {
    std::timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

Quartiles quartiles_of(std::vector<double> values) {
    DRAPE_ASSERT(!values.empty());
    std::sort(values.begin(), values.end());
    const auto at = [&values](double part) {
        const double rank = part * static_cast<double>(values.size() - 1);
        const auto below = static_cast<std::size_t>(rank), above = std::min(below + 1, values.size() - 1);
        return std::lerp(values[below], values[above], rank - std::floor(rank));
    };
    return {at(0.25), at(0.5), at(0.75)};
}

double thread_cpu_time() { return seconds_of(CLOCK_THREAD_CPUTIME_ID); }

double program_cpu_time() { return seconds_of(CLOCK_PROCESS_CPUTIME_ID); }

}  // namespace drape
