/* simd.h - plain loops over lanes, compiled for several instruction sets; the loader picks one. None of them contracts
 * products and sums, so all give the same bits. */
#ifndef BASE_SIMD_H
#define BASE_SIMD_H

#include <stdint.h>
#include <string.h>

/* Sanitizers cannot run in the resolvers that choose a clone. */
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(undefined_behavior_sanitizer)
#define SIMD_ONE_CLONE 1
#endif
#endif
/* Code that is compiled for AVX2 as a whole needs no clone for it, and POV_PORTABLE asks for plain C only. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(__AVX2__) || defined(POV_PORTABLE)
#define SIMD_ONE_CLONE 1
#endif

/* SIMD_NOINLINE: a function that must not be inlined either. Clones never are, and not every compiler accepts both
 * attributes. */
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(SIMD_ONE_CLONE)
#define SIMD_CLONES __attribute__((target_clones("avx2", "default")))
#define SIMD_NOINLINE
#elif defined(__GNUC__)
#define SIMD_CLONES
#define SIMD_NOINLINE __attribute__((noinline))
#else
#define SIMD_CLONES
#define SIMD_NOINLINE
#endif

/* SIMD_INLINE: a function that such a loop calls: it must be inlined. SIMD_RARE: one that is hardly ever called. SIMD_APART: one
 * that is not inlined, for its caller would save registers for it where it is not called. */
#if defined(__GNUC__)
#define SIMD_RARE __attribute__((cold))
#define SIMD_APART __attribute__((noinline))
#define SIMD_INLINE __attribute__((always_inline)) static inline
#else
#define SIMD_RARE
#define SIMD_APART
#define SIMD_INLINE static inline
#endif

/* Before a loop over a few lanes, which is to become vectors and not first be unrolled. */
#if defined(__GNUC__) && !defined(__clang__)
#define SIMD_LOOP _Pragma("GCC unroll 1")
#else
#define SIMD_LOOP
#endif

/* A type or member that begins at a cache line, so that no vector load crosses two lines: that costs as much as two
 * loads. Allocate it with env_alloc_aligned(). */
enum { SIMD_LINE = 64 };
#if defined(__GNUC__)
#define SIMD_ALIGNED __attribute__((aligned(SIMD_LINE)))
#else
#define SIMD_ALIGNED
#endif

/* Prefetch memory that will be read soon, where the processor cannot predict it. The address may be invalid. Compilers
 * drop calls of functions that do nothing but prefetch: such a function must be SIMD_INLINE. */
#if defined(__GNUC__)
#define SIMD_PREFETCH(address) __builtin_prefetch(address)
#else
#define SIMD_PREFETCH(address) ((void)(address))
#endif

/* Transpose doubles of four structures. Stored one by one, they would stall the vector loads that follow (no store
 * forwarding). */
#if defined(__AVX__) && defined(__GNUC__)
#include <immintrin.h>

/* Two doubles of each of two structures: the load inserts the upper half at no cost. */
SIMD_INLINE __m256d simd_load_pairs(const void *low, const void *high, size_t offset)
{
    const double *const l = (const double *)(const void *)((const char *)low + offset);
    const double *const h = (const double *)(const void *)((const char *)high + offset);

    return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(l)), _mm_loadu_pd(h), 1);
}

/* Four doubles from each of `from`: the first ones to `w`, the second ones to `x`, and so on. */
SIMD_INLINE void simd_transpose(const void *const from[4], size_t offset, double *w, double *x, double *y, double *z)
{
    const size_t behind = offset + 2 * sizeof(double);
    const __m256d ac = simd_load_pairs(from[0], from[2], offset), bd = simd_load_pairs(from[1], from[3], offset);
    const __m256d more_ac = simd_load_pairs(from[0], from[2], behind);
    const __m256d more_bd = simd_load_pairs(from[1], from[3], behind);

    _mm256_storeu_pd(w, _mm256_unpacklo_pd(ac, bd));
    _mm256_storeu_pd(x, _mm256_unpackhi_pd(ac, bd));
    _mm256_storeu_pd(y, _mm256_unpacklo_pd(more_ac, more_bd));
    _mm256_storeu_pd(z, _mm256_unpackhi_pd(more_ac, more_bd));
}

/* Copy a multiple of 16 bytes, a constant, in the widest pieces: compilers copy structures by 16 bytes. */
SIMD_INLINE void simd_copy(void *to, const void *from, size_t size)
{
    size_t i;

    for (i = 0; i + 32 <= size; i += 32)
        _mm256_storeu_si256((__m256i *)(void *)((char *)to + i), _mm256_loadu_si256((const __m256i *)(const void *)((const char *)from + i)));
    memcpy((char *)to + i, (const char *)from + i, size % 32);
}
#else
SIMD_INLINE void simd_copy(void *to, const void *from, size_t size) { memcpy(to, from, size); }

SIMD_INLINE void simd_transpose(const void *const from[4], size_t offset, double *w, double *x, double *y, double *z)
{
    int i;

    for (i = 0; i < 4; i++) {
        const char *at = (const char *)from[i] + offset;

        memcpy(w + i, at, sizeof *w);
        memcpy(x + i, at + sizeof *w, sizeof *x);
        memcpy(y + i, at + 2 * sizeof *w, sizeof *y);
        memcpy(z + i, at + 3 * sizeof *w, sizeof *z);
    }
}
#endif

/* ---- masks of lanes ---- */

/* Index of the lowest set bit; the mask must not be zero. */
static inline uint32_t first_of(uint32_t mask)
{
#ifdef __GNUC__
    return (uint32_t)__builtin_ctz(mask);
#else
    uint32_t i = 0;
    while (!(mask >> i & 1))
        i++;
    return i;
#endif
}

static inline uint32_t first_of64(uint64_t mask)
{
#ifdef __GNUC__
    return (uint32_t)__builtin_ctzll(mask);
#else
    return (uint32_t)mask ? first_of((uint32_t)mask) : 32 + first_of((uint32_t)(mask >> 32));
#endif
}

#endif
