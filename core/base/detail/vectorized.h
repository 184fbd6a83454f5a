/// For loops whose passes are alike and independent: the compiler lays several of them side by side.
#pragma once

/// Before a function: compiled once for every width of vectors that processors of this kind have, and chosen when the
/// program starts. Its source is compiled with -ffp-contract=off, so that all of them round alike. Not with sanitizers,
/// which are not ready when the choice is made.
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define BATTEN_VECTORIZED __attribute__((target_clones("default", "avx2", "arch=skylake-avx512")))
#else
#define BATTEN_VECTORIZED
#endif

/// Before a loop: no pass writes what another one reads.
#if defined(__clang__)
#define BATTEN_INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define BATTEN_INDEPENDENT _Pragma("GCC ivdep")
#else
#define BATTEN_INDEPENDENT
#endif
