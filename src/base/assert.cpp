#include "drape/base/assert.h"

#include <cstdio>
#include <cstdlib>

namespace drape {

void assertion_failed(const char* condition, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: this is a bug in Drape: expected %s\n", file, line, condition);
    std::abort();
}

}  // namespace drape
