#pragma once

namespace drape {

/// Prints the broken condition with its file and line, and aborts; called by `DRAPE_ASSERT` only.
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);

}  // namespace drape

/// A broken condition is a bug in Drape, never bad input. Kept in every build type but Release.
#ifdef DRAPE_NO_ASSERT
#define DRAPE_ASSERT(condition) static_cast<void>(sizeof(!(condition)))
#else
#define DRAPE_ASSERT(condition) \
    ((condition) ? static_cast<void>(0) : ::drape::assertion_failed(#condition, __FILE__, __LINE__))
#endif
