/* simd.h - plain loops over lanes, compiled for several instruction sets; the loader picks one. None of them contracts
 * products and sums, so all give the same bits. */
#ifndef BASE_SIMD_H
#define BASE_SIMD_H

#include <stdint.h>
#include <string.h>

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

/* SIMD_APART: what must stay a call besides. Clones do anyway, and not every compiler takes both words. */
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(SIMD_ONE_CLONE)
#define SIMD_CLONES __attribute__((target_clones("avx2", "default")))
#define SIMD_APART
#elif defined(__GNUC__)
#define SIMD_CLONES
#define SIMD_APART __attribute__((noinline))
#else
#define SIMD_CLONES
#define SIMD_APART
#endif

/* What such a loop calls: it must not stay a call. */
#if defined(__GNUC__)
#define SIMD_INLINE __attribute__((always_inline)) static inline
#else
#define SIMD_INLINE static inline
#endif

/* A type or member that begins with a line of memory, so that no vector of it lies across two: that costs as much as two.
 * Memory for it is to be had from env_alloc_aligned(). */
enum { SIMD_LINE = 64 };
#if defined(__GNUC__)
#define SIMD_ALIGNED __attribute__((aligned(SIMD_LINE)))
#else
#define SIMD_ALIGNED
#endif

/* What will be read soon, where the processor cannot guess it. The address need not be one. Compilers leave out calls of
 * functions that do nothing else: such a function must be SIMD_INLINE. */
#if defined(__GNUC__)
#define SIMD_EXPECT(address) __builtin_prefetch(address)
#else
#define SIMD_EXPECT(address) ((void)(address))
#endif

/* Four structures' doubles by place. Stored one by one they would be waited for when vectors of them are loaded. */
#if defined(__AVX__) && defined(__GNUC__)
typedef double simd_four __attribute__((vector_size(32)));
typedef int64_t simd_places __attribute__((vector_size(32)));
#ifdef __clang__
#define SIMD_PICK(a, b, i, j, k, l) __builtin_shufflevector(a, b, i, j, k, l)
#else
#define SIMD_PICK(a, b, i, j, k, l) __builtin_shuffle(a, b, (simd_places){ i, j, k, l })
#endif

SIMD_INLINE simd_four simd_load_four(const void *from, size_t offset)
{
    simd_four v;

    memcpy(&v, (const char *)from + offset, sizeof v);
    return v;
}

SIMD_INLINE void simd_store_four(double *to, simd_four v) { memcpy(to, &v, sizeof v); }

/* The four doubles at each of `from`: those that come first to `w`, and so on. */
SIMD_INLINE void simd_transpose(const void *const from[4], size_t offset, double *w, double *x, double *y, double *z)
{
    const simd_four a = simd_load_four(from[0], offset), b = simd_load_four(from[1], offset);
    const simd_four c = simd_load_four(from[2], offset), d = simd_load_four(from[3], offset);
    const simd_four ab = SIMD_PICK(a, b, 0, 4, 2, 6), cd = SIMD_PICK(c, d, 0, 4, 2, 6);
    const simd_four more_ab = SIMD_PICK(a, b, 1, 5, 3, 7), more_cd = SIMD_PICK(c, d, 1, 5, 3, 7);

    simd_store_four(w, SIMD_PICK(ab, cd, 0, 1, 4, 5));
    simd_store_four(x, SIMD_PICK(more_ab, more_cd, 0, 1, 4, 5));
    simd_store_four(y, SIMD_PICK(ab, cd, 2, 3, 6, 7));
    simd_store_four(z, SIMD_PICK(more_ab, more_cd, 2, 3, 6, 7));
}
#else
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

#endif
