#pragma once

namespace drape::test {

/// Whether the address sanitizer watches: the same steps take ten to thirty times as long, and long runs are cut short.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace drape::test
