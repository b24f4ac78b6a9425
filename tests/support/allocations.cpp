#include "support/allocations.h"

#include <atomic>
#include <cstddef>
#include <cstdlib>

// Eigen allocates with malloc and aligned_alloc, the standard library through operator new, which calls malloc:
// counting in these three sees all of it. Sanitizers bring their own: there the count stays at zero.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* __libc_memalign(std::size_t alignment, std::size_t size);

namespace {
std::atomic<long long> calls{0};
}

extern "C" void* malloc(std::size_t size) {
    ++calls;
    return __libc_malloc(size);
}

extern "C" void* aligned_alloc(std::size_t alignment, std::size_t size) {
    ++calls;
    return __libc_memalign(alignment, size);
}
#else
namespace {
constexpr long long calls = 0;
}
#endif

namespace drape::testing {

long long allocations() { return calls; }

}  // namespace drape::testing
