#pragma once

/// Compiles a loop several times, for the baseline processor and for wider vectors, and picks one when the program
/// starts. The clones give the same bits: only element-wise arithmetic is widened, and nothing is contracted or
/// reassociated. Sanitizer builds keep the baseline alone (their runtime is not up yet when the choice is made).
#if defined(__x86_64__) && !defined(DRAPE_NO_CLONES)
#define DRAPE_VECTORISE __attribute__((target_clones("default", "avx2", "arch=skylake-avx512")))
#else
#define DRAPE_VECTORISE
#endif

/// A helper that must be part of each clone of its caller.
#define DRAPE_INLINE __attribute__((always_inline)) inline
