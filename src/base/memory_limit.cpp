#include "drape/base/memory_limit.h"

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

#include "drape/base/numbers.h"

namespace drape {

MemoryLimit memory_limit() {
    MemoryLimit least{static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE)),
                      "what this machine has"};
    const auto lower = [&least](double bytes, std::string_view whose) {
        if (bytes < least.bytes) least = {bytes, whose};
    };
    rlimit space{};
    if (getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY) {
        lower(static_cast<double>(space.rlim_cur), "what this process may take (ulimit -v)");
    }
    std::ifstream group("/sys/fs/cgroup/memory.max");
    std::string word;
    if (group >> word) {
        if (const auto bytes = parse_real(word)) lower(*bytes, "what this process's control group may take");
    }
    return least;
}

std::string bytes_text(double bytes) {
    constexpr double mega = 1e6, giga = 1e9;
    return bytes < giga ? real_text(bytes / mega, 3) + " MB" : real_text(bytes / giga, 3) + " GB";
}

}  // namespace drape
