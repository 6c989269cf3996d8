#pragma once

/// Marks a hot loop to be compiled for AVX2 as well and chosen when the program starts. Results do not depend on the choice: products
/// and sums are never fused. Sanitizers cannot run such functions' resolvers, so they get the plain version.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define BIOTOPE_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define BIOTOPE_VECTOR_CLONES
#endif
