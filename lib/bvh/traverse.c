#include "bvh/traverse.h"

#include "base/simd.h"

static inline float greater(float a, float b) { return a > b ? a : b; }
static inline float lesser(float a, float b) { return a < b ? a : b; }

/* Key of the first child in the mask; removes it from the mask. */
static inline uint64_t take_key(const bvh_node *node, uint32_t *mask, const float *entry)
{
    uint32_t i = first_of(*mask);

    *mask &= *mask - 1;
    return key_of(entry[i], node->child[i]);
}

static inline void put_greater_first(uint64_t *a, uint64_t *b)
{
    uint64_t less = *a < *b ? *a : *b, more = *a < *b ? *b : *a;

    *a = more;
    *b = less;
}

/* The stack of nodes to visit holds keys; in traversals of any order these are children alone. */

/* Push the children that were hit, the nearest on top, and return the new top. Exchanges sort the first four, because
 * they cost fewer mispredicted branches than a loop. */
static inline uint32_t push(const bvh_node *node, uint32_t mask, const float *entry, uint64_t *stack, uint32_t top)
{
    uint64_t a = take_key(node, &mask, entry), b = take_key(node, &mask, entry), c, d;
    uint32_t base = top, at;

    put_greater_first(&a, &b);
    if (!mask) {
        stack[top++] = a;
        stack[top++] = b;
        return top;
    }
    c = take_key(node, &mask, entry);
    put_greater_first(&b, &c);
    put_greater_first(&a, &b);
    if (!mask) {
        stack[top++] = a;
        stack[top++] = b;
        stack[top++] = c;
        return top;
    }
    d = take_key(node, &mask, entry);
    put_greater_first(&c, &d);
    put_greater_first(&b, &c);
    put_greater_first(&a, &b);
    stack[top++] = a;
    stack[top++] = b;
    stack[top++] = c;
    stack[top++] = d;
    while (mask) {
        a = take_key(node, &mask, entry);
        for (at = top++; at > base && stack[at - 1] < a; at--)
            stack[at] = stack[at - 1];
        stack[at] = a;
    }
    return top;
}

/* Push the children that were hit, except the last, which is returned. */
static inline uint32_t push_any(const bvh_node *node, uint32_t mask, uint64_t *stack, uint32_t *top)
{
    for (; mask & (mask - 1); mask &= mask - 1)
        stack[(*top)++] = node->child[first_of(mask)];
    return node->child[first_of(mask)];
}

/* A ray as the node test needs it. */
typedef struct lanes_portable {
    float inverse[3], near_offset[3], far_offset[3], limit;
    uint32_t near_row[3]; /* rows of a node's bounds: where the ray enters; row ^ 1 is where it leaves */
} lanes_portable;

static inline void spread_axis(lanes_portable *lanes, int k, double o, double d, double slack)
{
    double a = fabs(d), inverse = 1.0 / copysign(a > BVH_LEAST ? a : BVH_LEAST, d);

    slack *= fabs(inverse) * (1.0 + fabs(o));
    lanes->inverse[k] = (float)inverse;
    lanes->near_offset[k] = (float)(o * inverse + slack);
    lanes->far_offset[k] = (float)(o * inverse - slack);
    lanes->near_row[k] = 2u * (uint32_t)k + (inverse < 0.0);
}

static inline void spread_portable(const bvh_local *l, float limit, lanes_portable *lanes)
{
    spread_axis(lanes, 0, l->org.x, l->dir.x, l->slack);
    spread_axis(lanes, 1, l->org.y, l->dir.y, l->slack);
    spread_axis(lanes, 2, l->org.z, l->dir.z, l->slack);
    lanes->limit = limit;
}

static inline void limit_portable(lanes_portable *lanes, float limit)
{
    lanes->limit = limit;
}

/* Mask of the node's boxes that the ray may hit, and its entry distances. */
static inline uint32_t hit_mask_portable(const bvh_node *node, const lanes_portable *s, float entry[BVH_WIDTH])
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

#define TRAVERSE_LANES lanes_portable
#define TRAVERSE_SPREAD spread_portable
#define TRAVERSE_LIMIT limit_portable
#define TRAVERSE_HIT hit_mask_portable
#define TRAVERSE_NAME(name) name##_portable
#define TRAVERSE_TARGET
#include "bvh/traverse_body.h"
#undef TRAVERSE_LANES
#undef TRAVERSE_SPREAD
#undef TRAVERSE_LIMIT
#undef TRAVERSE_HIT
#undef TRAVERSE_NAME
#undef TRAVERSE_TARGET

const bvh_kernels bvh_kernels_portable = { "portable", bvh_nearest_packet_portable, bvh_any_packet_portable,
                                           nearest_single_portable, any_single_portable, NULL, NULL };

bool bvh_go_single(bvh_traversal *traversal, uint32_t lane, uint32_t frame, uint32_t at)
{
    return traverse_portable(traversal, lane, frame, at, true);
}

#if defined(__x86_64__) && defined(__GNUC__) && !defined(POV_PORTABLE)

#include "bvh/avx2.h"

#define TRAVERSE_TARGET BVH_AVX2

/* Each number of the ray in all lanes, and the rows of a node as byte offsets. */
typedef struct lanes_avx2 {
    __m256 inverse[3], near_offset[3], far_offset[3], limit;
    size_t near_row[3], far_row[3];
} lanes_avx2;

TRAVERSE_TARGET static inline void spread_axis_avx2(lanes_avx2 *lanes, int k, __m128 inverse, __m128 near, __m128 far,
                                                int backward)
{
    lanes->inverse[k] = _mm256_broadcastss_ps(inverse);
    lanes->near_offset[k] = _mm256_broadcastss_ps(near);
    lanes->far_offset[k] = _mm256_broadcastss_ps(far);
    lanes->near_row[k] = (2u * (size_t)k + (size_t)(backward >> k & 1)) * sizeof(float[BVH_WIDTH]);
    lanes->far_row[k] = lanes->near_row[k] ^ sizeof(float[BVH_WIDTH]);
}

TRAVERSE_TARGET static inline void spread_avx2(const bvh_local *l, float limit, lanes_avx2 *lanes)
{
    /* The fourth lane is unused. */
    __m256d o = _mm256_set_pd(l->org.z, l->org.z, l->org.y, l->org.x);
    __m256d d = _mm256_set_pd(l->dir.z, l->dir.z, l->dir.y, l->dir.x);
    __m256d sign = _mm256_set1_pd(-0.0), one = _mm256_set1_pd(1.0), inverse, at, slack;
    __m128 r, near, far;
    int backward = _mm256_movemask_pd(d);

    inverse = _mm256_or_pd(_mm256_max_pd(_mm256_andnot_pd(sign, d), _mm256_set1_pd(BVH_LEAST)), _mm256_and_pd(sign, d));
    inverse = _mm256_div_pd(one, inverse);
    at = _mm256_mul_pd(o, inverse);
    slack = _mm256_mul_pd(_mm256_add_pd(_mm256_andnot_pd(sign, o), one), _mm256_set1_pd(l->slack));
    slack = _mm256_mul_pd(slack, _mm256_andnot_pd(sign, inverse));
    r = _mm256_cvtpd_ps(inverse);
    near = _mm256_cvtpd_ps(_mm256_add_pd(at, slack));
    far = _mm256_cvtpd_ps(_mm256_sub_pd(at, slack));
    spread_axis_avx2(lanes, 0, r, near, far, backward);
    spread_axis_avx2(lanes, 1, _mm_movehdup_ps(r), _mm_movehdup_ps(near), _mm_movehdup_ps(far), backward);
    spread_axis_avx2(lanes, 2, _mm_movehl_ps(r, r), _mm_movehl_ps(near, near), _mm_movehl_ps(far, far), backward);
    lanes->limit = _mm256_set1_ps(limit);
}

TRAVERSE_TARGET static inline void limit_avx2(lanes_avx2 *lanes, float limit)
{
    lanes->limit = _mm256_set1_ps(limit);
}

TRAVERSE_TARGET static inline __m256 row_avx2(const bvh_node *node, size_t row)
{
    return _mm256_load_ps((const float *)(const void *)((const char *)node + row));
}

/* Fused multiply-subtract rounds less often, so the slack in the offsets covers it too. */
TRAVERSE_TARGET static inline uint32_t hit_mask_avx2(const bvh_node *node, const lanes_avx2 *r, float entry[BVH_WIDTH])
{
    __m256 x = _mm256_fmsub_ps(row_avx2(node, r->near_row[0]), r->inverse[0], r->near_offset[0]);
    __m256 y = _mm256_fmsub_ps(row_avx2(node, r->near_row[1]), r->inverse[1], r->near_offset[1]);
    __m256 z = _mm256_fmsub_ps(row_avx2(node, r->near_row[2]), r->inverse[2], r->near_offset[2]);
    __m256 in = later(later(x, y), later(z, _mm256_setzero_ps())), out;

    x = _mm256_fmsub_ps(row_avx2(node, r->far_row[0]), r->inverse[0], r->far_offset[0]);
    y = _mm256_fmsub_ps(row_avx2(node, r->far_row[1]), r->inverse[1], r->far_offset[1]);
    z = _mm256_fmsub_ps(row_avx2(node, r->far_row[2]), r->inverse[2], r->far_offset[2]);
    out = sooner(sooner(x, y), sooner(z, r->limit));
    _mm256_storeu_ps(entry, in);
    return (uint32_t)_mm256_movemask_ps(_mm256_cmp_ps(in, out, _CMP_LE_OQ));
}

#ifdef __AVX512VL__
#define INTERLEAVED bvh_nearest_interleaved, bvh_any_interleaved
#else
#define INTERLEAVED NULL, NULL
#endif

#define TRAVERSE_LANES lanes_avx2
#define TRAVERSE_SPREAD spread_avx2
#define TRAVERSE_LIMIT limit_avx2
#define TRAVERSE_HIT hit_mask_avx2
#define TRAVERSE_NAME(name) name##_avx2
#include "bvh/traverse_body.h"

const bvh_kernels bvh_kernels_avx2 = { "AVX2", bvh_nearest_packet_avx2, bvh_any_packet_avx2,
                                       nearest_single_avx2, any_single_avx2, INTERLEAVED };

const bvh_kernels *bvh_kernels_best(void)
{
#if defined(__AVX2__) && defined(__FMA__)   /* in a virtual machine each question to the processor takes 8 us */
    return &bvh_kernels_avx2;
#else
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? &bvh_kernels_avx2 : &bvh_kernels_portable;
#endif
}

#else

const bvh_kernels *bvh_kernels_best(void)
{
    return &bvh_kernels_portable;
}

#endif
