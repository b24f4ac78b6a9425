#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <cstddef>
#include <fstream>

// Sanitizers reserve terabytes of addresses: what limits them cannot be tested there.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define DRAPE_CAN_LIMIT_ADDRESS_SPACE
#endif

namespace drape::test {

/// Lets this program take so much more of its address space, and no more [bytes].
inline void limit_address_space(std::size_t more) {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlim_t limit = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + more;
    const rlimit both{limit, limit};
    setrlimit(RLIMIT_AS, &both);
}

}  // namespace drape::test
