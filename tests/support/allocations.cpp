#include "support/allocations.h"

#include <malloc.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>

// Eigen allocates with malloc and aligned_alloc, the standard library through operator new, which calls malloc:
// counting in these and their kin sees all of it. Sanitizers bring their own: there the counts stay at zero.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* __libc_calloc(std::size_t count, std::size_t size);
extern "C" void* __libc_realloc(void* block, std::size_t size);
extern "C" void* __libc_memalign(std::size_t alignment, std::size_t size);
extern "C" void __libc_free(void* block);

namespace {

std::atomic<long long> calls{0}, held{0}, peak{0};

void* taken(void* block) {
    ++calls;
    const long long now = held += static_cast<long long>(malloc_usable_size(block));
    for (long long before = peak; before < now && !peak.compare_exchange_weak(before, now);) {
    }
    return block;
}

void given_back(void* block) { held -= static_cast<long long>(malloc_usable_size(block)); }

}  // namespace

extern "C" void* malloc(std::size_t size) { return taken(__libc_malloc(size)); }

extern "C" void* calloc(std::size_t count, std::size_t size) { return taken(__libc_calloc(count, size)); }

extern "C" void* aligned_alloc(std::size_t alignment, std::size_t size) {
    return taken(__libc_memalign(alignment, size));
}

extern "C" void* realloc(void* block, std::size_t size) {
    given_back(block);
    return taken(__libc_realloc(block, size));
}

extern "C" void free(void* block) {
    given_back(block);
    __libc_free(block);
}
#else
namespace {
constexpr long long calls = 0, held = 0;
long long peak = 0;
}  // namespace
#endif

namespace drape::test {

long long allocations() { return calls; }

long long bytes_held() { return held; }

long long most_bytes_held() { return peak; }

void forget_most_bytes_held() { peak = static_cast<long long>(held); }

}  // namespace drape::test
