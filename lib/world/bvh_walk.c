#include "world/bvh_walk.h"

#include <string.h>

/* What the entries of the stack are: the entry's distance, a float that is not negative and so sorts as its bits do,
 * above the reference. */
static inline uint64_t key_of(float entry, uint32_t child)
{
    uint32_t bits;

    memcpy(&bits, &entry, sizeof bits);
    return (uint64_t)bits << 32 | child;
}

static inline float entry_of(uint64_t key)
{
    uint32_t bits = (uint32_t)(key >> 32);
    float entry;

    memcpy(&entry, &bits, sizeof entry);
    return entry;
}

static inline float greater(float a, float b) { return a > b ? a : b; }
static inline float lesser(float a, float b) { return a < b ? a : b; }

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

/* The boxes of a node that the ray may meet, and where it enters them. */
static inline uint32_t meet_portable(const bvh_node *node, const bvh_slabs *s, float entry[BVH_WIDTH])
{
    const float *nx = node->bounds[s->near_row[0]], *fx = node->bounds[s->near_row[0] ^ 1];
    const float *ny = node->bounds[s->near_row[1]], *fy = node->bounds[s->near_row[1] ^ 1];
    const float *nz = node->bounds[s->near_row[2]], *fz = node->bounds[s->near_row[2] ^ 1];
    float leave[BVH_WIDTH];
    uint32_t mask = 0;
    int i;

    for (i = 0; i < BVH_WIDTH; i++) {
        float x = nx[i] * s->inverse[0] - s->near_offset[0];
        float y = ny[i] * s->inverse[1] - s->near_offset[1];
        float z = nz[i] * s->inverse[2] - s->near_offset[2];
        entry[i] = greater(greater(x, y), greater(z, 0.0f));
    }
    for (i = 0; i < BVH_WIDTH; i++) {
        float x = fx[i] * s->inverse[0] - s->far_offset[0];
        float y = fy[i] * s->inverse[1] - s->far_offset[1];
        float z = fz[i] * s->inverse[2] - s->far_offset[2];
        leave[i] = lesser(lesser(x, y), lesser(z, s->limit));
    }
    for (i = 0; i < BVH_WIDTH; i++)
        mask |= (uint32_t)(entry[i] <= leave[i]) << i;
    return mask;
}

#define WALK_MEET meet_portable
#define WALK_NAME(name) name##_portable
#define WALK_TARGET
#include "world/bvh_walk_body.h"
#undef WALK_MEET
#undef WALK_NAME
#undef WALK_TARGET

const bvh_walks bvh_walks_portable = { "portable", nearest_first_portable, any_order_portable };

#if defined(__x86_64__) && defined(__GNUC__)

#include <immintrin.h>

#define WALK_TARGET __attribute__((target("avx2,fma")))

/* A fused product and difference round less often, so that the slack in the offsets covers them too. */
WALK_TARGET static inline uint32_t meet_avx2(const bvh_node *node, const bvh_slabs *s, float entry[BVH_WIDTH])
{
    const float *nx = node->bounds[s->near_row[0]], *fx = node->bounds[s->near_row[0] ^ 1];
    const float *ny = node->bounds[s->near_row[1]], *fy = node->bounds[s->near_row[1] ^ 1];
    const float *nz = node->bounds[s->near_row[2]], *fz = node->bounds[s->near_row[2] ^ 1];
    __m256 ix = _mm256_set1_ps(s->inverse[0]), iy = _mm256_set1_ps(s->inverse[1]), iz = _mm256_set1_ps(s->inverse[2]);
    __m256 x = _mm256_fmsub_ps(_mm256_load_ps(nx), ix, _mm256_set1_ps(s->near_offset[0]));
    __m256 y = _mm256_fmsub_ps(_mm256_load_ps(ny), iy, _mm256_set1_ps(s->near_offset[1]));
    __m256 z = _mm256_fmsub_ps(_mm256_load_ps(nz), iz, _mm256_set1_ps(s->near_offset[2]));
    __m256 in = _mm256_max_ps(_mm256_max_ps(x, y), _mm256_max_ps(z, _mm256_setzero_ps())), out;

    x = _mm256_fmsub_ps(_mm256_load_ps(fx), ix, _mm256_set1_ps(s->far_offset[0]));
    y = _mm256_fmsub_ps(_mm256_load_ps(fy), iy, _mm256_set1_ps(s->far_offset[1]));
    z = _mm256_fmsub_ps(_mm256_load_ps(fz), iz, _mm256_set1_ps(s->far_offset[2]));
    out = _mm256_min_ps(_mm256_min_ps(x, y), _mm256_min_ps(z, _mm256_set1_ps(s->limit)));
    _mm256_storeu_ps(entry, in);
    return (uint32_t)_mm256_movemask_ps(_mm256_cmp_ps(in, out, _CMP_LE_OQ));
}

#define WALK_MEET meet_avx2
#define WALK_NAME(name) name##_avx2
#include "world/bvh_walk_body.h"

static const bvh_walks bvh_walks_avx2 = { "AVX2", nearest_first_avx2, any_order_avx2 };

const bvh_walks *bvh_walks_best(void)
{
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? &bvh_walks_avx2 : &bvh_walks_portable;
}

#else

const bvh_walks *bvh_walks_best(void)
{
    return &bvh_walks_portable;
}

#endif
