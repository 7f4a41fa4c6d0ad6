/* simd.h - plain loops over lanes, compiled for several instruction sets; the loader picks one. None of them contracts
 * products and sums, so all give the same bits. */
#ifndef BASE_SIMD_H
#define BASE_SIMD_H

/* Sanitizers cannot run in the resolvers that pick a clone. */
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(undefined_behavior_sanitizer)
#define SIMD_ONE_CLONE 1
#endif
#endif
/* What is compiled for AVX2 as a whole needs no clone for it, and POV_PORTABLE asks for plain C alone. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(__AVX2__) || defined(POV_PORTABLE)
#define SIMD_ONE_CLONE 1
#endif

#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(SIMD_ONE_CLONE)
#define SIMD_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define SIMD_CLONES
#endif

/* What such a loop calls: it must not stay a call. */
#if defined(__GNUC__)
#define SIMD_INLINE __attribute__((always_inline)) static inline
#else
#define SIMD_INLINE static inline
#endif

/* What will be read soon, where the processor cannot guess it. The address need not be one. */
#if defined(__GNUC__)
#define SIMD_EXPECT(address) __builtin_prefetch(address)
#else
#define SIMD_EXPECT(address) ((void)(address))
#endif

#endif
