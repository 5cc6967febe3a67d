// SPDX-License-Identifier: Apache-2.0
// One build that uses AVX2 where the machine has it. Sanitizers cannot run the resolvers this needs, and Clang 16
// leaves out templates that only a clone calls.
#pragma once

#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__) && !defined(__clang__)
/// A function that is compiled for each kind of machine.
#define STEREO_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
/// A function that becomes part of those.
#define STEREO_INTO_CLONES inline __attribute__((always_inline))
#else
#define STEREO_VECTOR_CLONES
#define STEREO_INTO_CLONES inline
#endif
