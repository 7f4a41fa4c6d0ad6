/* corner.h - boxes as pairs of corner vectors, for the steps of a build. */
#ifndef BVH_CORNER_H
#define BVH_CORNER_H

#include "bvh/build.h"

#include <float.h>
#include <string.h>

/* A corner of a box, as a vector. The fourth lane is unused, and is not a number in a reference. (gcc 12 does not
 * vectorise plain loops over these lanes.) */
#if defined(__GNUC__)
typedef float corner __attribute__((vector_size(16)));
typedef float corner_anywhere __attribute__((vector_size(16), aligned(4), may_alias));
typedef int32_t corner_mask __attribute__((vector_size(16)));
#define LANE(c, k) ((c)[k])
static inline corner corner_at(const void *at) { return *(const corner_anywhere *)at; }
static inline corner sum_of(corner a, corner b) { return a + b; }
static inline corner where(corner_mask m, corner a, corner b)
{
    return (corner)(((corner_mask)a & m) | ((corner_mask)b & ~m));
}
#if defined(__SSE__)
/* gcc 12 compiles the other forms to four instructions. */
static inline corner lesser(corner a, corner b) { return __builtin_ia32_minps(a, b); }
static inline corner greater(corner a, corner b) { return __builtin_ia32_maxps(a, b); }
#else
static inline corner lesser(corner a, corner b) { return where(a < b, a, b); }
static inline corner greater(corner a, corner b) { return where(a > b, a, b); }
#endif
#else
typedef struct corner { float lane[4]; } corner;
#define LANE(c, k) ((c).lane[k])
static inline corner corner_at(const void *at)
{
    corner c;

    memcpy(&c, at, sizeof c);
    return c;
}
static inline corner combine(corner a, corner b, float (*of)(float, float))
{
    const corner c = { { of(a.lane[0], b.lane[0]), of(a.lane[1], b.lane[1]), of(a.lane[2], b.lane[2]), a.lane[3] } };

    return c;
}
static inline float plus(float a, float b) { return a + b; }
static inline float less_of(float a, float b) { return a < b ? a : b; }
static inline float more_of(float a, float b) { return a > b ? a : b; }
static inline corner sum_of(corner a, corner b) { return combine(a, b, plus); }
static inline corner lesser(corner a, corner b) { return combine(a, b, less_of); }
static inline corner greater(corner a, corner b) { return combine(a, b, more_of); }
#endif

typedef struct box { corner lo, hi; } box;

static const box no_box = { { FLT_MAX, FLT_MAX, FLT_MAX, FLT_MAX }, { -FLT_MAX, -FLT_MAX, -FLT_MAX, -FLT_MAX } };

static inline box add(box b, corner lo, corner hi)
{
    const box sum = { lesser(lo, b.lo), greater(hi, b.hi) };

    return sum;
}

/* Half the surface. */
static inline float area_of(const box *b)
{
    const float x = LANE(b->hi, 0) - LANE(b->lo, 0), y = LANE(b->hi, 1) - LANE(b->lo, 1);
    const float z = LANE(b->hi, 2) - LANE(b->lo, 2);

    return x * y + y * z + z * x;
}

#endif
