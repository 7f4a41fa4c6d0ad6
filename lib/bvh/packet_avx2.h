/* packet_avx2.h - the node tests of packet.c for processors with AVX2, and replacements of some with AVX-512. No guard:
 * it is included there, once. */

#include "bvh/avx2.h"

#define PACKET_TARGET BVH_AVX2

/* Horizontal minimum of each of three vectors. */
PACKET_TARGET static inline __m128 least_of_avx2(const __m256 v[3])
{
    __m128 x = _mm_min_ps(_mm256_castps256_ps128(v[0]), _mm256_extractf128_ps(v[0], 1));
    __m128 y = _mm_min_ps(_mm256_castps256_ps128(v[1]), _mm256_extractf128_ps(v[1], 1));
    __m128 z = _mm_min_ps(_mm256_castps256_ps128(v[2]), _mm256_extractf128_ps(v[2], 1));

    x = _mm_min_ps(_mm_unpacklo_ps(x, y), _mm_unpackhi_ps(x, y));
    z = _mm_min_ps(_mm_unpacklo_ps(z, z), _mm_unpackhi_ps(z, z));
    return _mm_min_ps(_mm_movelh_ps(x, z), _mm_movehl_ps(z, x));
}

PACKET_TARGET static inline __m128 greatest_of_avx2(const __m256 v[3])
{
    __m128 x = _mm_max_ps(_mm256_castps256_ps128(v[0]), _mm256_extractf128_ps(v[0], 1));
    __m128 y = _mm_max_ps(_mm256_castps256_ps128(v[1]), _mm256_extractf128_ps(v[1], 1));
    __m128 z = _mm_max_ps(_mm256_castps256_ps128(v[2]), _mm256_extractf128_ps(v[2], 1));

    x = _mm_max_ps(_mm_unpacklo_ps(x, y), _mm_unpackhi_ps(x, y));
    z = _mm_max_ps(_mm_unpacklo_ps(z, z), _mm_unpackhi_ps(z, z));
    return _mm_max_ps(_mm_movelh_ps(x, z), _mm_movehl_ps(z, x));
}

PACKET_TARGET static inline void bound_all_avx2(packet_state *c)
{
    __m256 less[3], more[3], low[3], high[3];
    float lo[4], hi[4], first[4], last[4];
    uint32_t i;
    int k;

    for (k = 0; k < 3; k++) {
        const float *org = c->traversal->soa.local.org[k];

        less[k] = more[k] = _mm256_load_ps(c->inverse[k]);
        low[k] = high[k] = _mm256_loadu_ps(org);
        for (i = 8; i < c->width; i += 8) {
            __m256 inverse = _mm256_load_ps(c->inverse[k] + i), o = _mm256_loadu_ps(org + i);

            less[k] = _mm256_min_ps(inverse, less[k]);
            more[k] = _mm256_max_ps(inverse, more[k]);
            low[k] = _mm256_min_ps(o, low[k]);
            high[k] = _mm256_max_ps(o, high[k]);
        }
    }
    _mm_storeu_ps(lo, least_of_avx2(less));
    _mm_storeu_ps(hi, greatest_of_avx2(more));
    _mm_storeu_ps(first, least_of_avx2(low));
    _mm_storeu_ps(last, greatest_of_avx2(high));
    c->near = true;
    for (k = 0; k < 3; k++)
        bound(c, k, lo[k], hi[k], first[k], last[k]);
}

/* near * r - offset by axis, at both ends. */
PACKET_TARGET static inline void ends_avx2(__m256 plane, const float r[2][4], const float offset[2][4], int k,
                                            __m256 *x, __m256 *y)
{
    *x = _mm256_fmsub_ps(plane, _mm256_broadcast_ss(&r[0][k]), _mm256_broadcast_ss(&offset[0][k]));
    *y = _mm256_fmsub_ps(plane, _mm256_broadcast_ss(&r[1][k]), _mm256_broadcast_ss(&offset[1][k]));
}

PACKET_TARGET static inline uint32_t group_avx2(const bvh_node *node, const packet_state *c, float entry[BVH_WIDTH],
                                                 uint32_t *all)
{
    const packet_bounds *b = &c->bounds;
    __m256 in = _mm256_setzero_ps(), out = _mm256_set1_ps(HUGE_VALF), x, y;
    __m256 last_in = in, first_out = _mm256_broadcast_ss(&c->least);
    int k;

    for (k = 0; k < 3; k++) {
        const __m256 near = _mm256_load_ps(node->bounds[c->near_row[k]]);
        const __m256 far = _mm256_load_ps(node->bounds[c->near_row[k] ^ 1]);

        ends_avx2(near, b->inverse, b->near_offset, k, &x, &y);
        in = later(in, sooner(x, y));
        ends_avx2(far, b->inverse, b->far_offset, k, &x, &y);
        out = sooner(out, later(x, y));
        ends_avx2(near, b->inverse, b->far_offset, k, &x, &y);
        last_in = later(last_in, later(x, y));
        ends_avx2(far, b->inverse, b->near_offset, k, &x, &y);
        first_out = sooner(first_out, sooner(x, y));
    }
    _mm256_storeu_ps(entry, in);
    *all = (uint32_t)_mm256_movemask_ps(_mm256_cmp_ps(last_in, first_out, _CMP_LE_OQ));
    return (uint32_t)_mm256_movemask_ps(_mm256_cmp_ps(in, out, _CMP_LE_OQ));
}

PACKET_TARGET static inline uint64_t lanes_avx2(const bvh_node *node, uint32_t child, const packet_state *c, uint64_t lanes,
                                                 uint64_t eights)
{
    __m256 near[3], far[3];
    uint64_t hit_mask = 0;
    int k;

    for (k = 0; k < 3; k++) {
        near[k] = _mm256_broadcast_ss(&node->bounds[c->near_row[k]][child]);
        far[k] = _mm256_broadcast_ss(&node->bounds[c->near_row[k] ^ 1][child]);
    }
    for (; eights; eights &= eights - 1) {
        const uint32_t i = first_of64(eights) & 56;
        __m256 in = _mm256_setzero_ps(), out = _mm256_load_ps(c->limit + i);
        for (k = 0; k < 3; k++) {
            __m256 inverse = _mm256_load_ps(c->inverse[k] + i);
            in = later(in, _mm256_fmsub_ps(near[k], inverse, _mm256_load_ps(c->near_offset[k] + i)));
            out = sooner(out, _mm256_fmsub_ps(far[k], inverse, _mm256_load_ps(c->far_offset[k] + i)));
        }
        hit_mask |= (uint64_t)(uint32_t)_mm256_movemask_ps(_mm256_cmp_ps(in, out, _CMP_LE_OQ)) << i;
    }
    return hit_mask & lanes;
}

PACKET_TARGET static inline uint64_t within_avx2(const packet_state *c, float entry, uint64_t lanes)
{
    __m256 at = _mm256_set1_ps(entry);
    uint64_t in = 0;
    uint32_t i;

    for (i = 0; i < c->width; i += 8) {
        __m256 within = _mm256_cmp_ps(at, _mm256_load_ps(c->limit + i), _CMP_LE_OQ);
        in |= (uint64_t)(uint32_t)_mm256_movemask_ps(within) << i;
    }
    return in & lanes;
}

/* As bvh_limit. */
PACKET_TARGET static inline __m128 four_limits_avx2(const packet_state *c, uint32_t i)
{
    const __m256d scale = _mm256_loadu_pd(c->scale + i), shift = _mm256_loadu_pd(c->traversal->soa.local.shift + i);
    const __m256d limit = _mm256_loadu_pd(c->traversal->limit + i), sign = _mm256_set1_pd(-0.0);
    const __m256d all = _mm256_add_pd(_mm256_andnot_pd(sign, limit), _mm256_andnot_pd(sign, shift));
    __m256d u = _mm256_mul_pd(_mm256_sub_pd(limit, shift), scale);

    u = _mm256_add_pd(u, _mm256_mul_pd(_mm256_mul_pd(all, scale), _mm256_set1_pd(0x1p-46)));
    u = _mm256_add_pd(u, _mm256_mul_pd(_mm256_andnot_pd(sign, u), _mm256_set1_pd(0x1p-22)));
    u = _mm256_blendv_pd(_mm256_set1_pd(HUGE_VAL), u, _mm256_cmp_pd(u, _mm256_set1_pd(1e38), _CMP_LT_OQ));
    return _mm256_cvtpd_ps(u);
}

/* As lower_limits, in groups of eight: most are lowered together. */
PACKET_TARGET static inline void lower_avx2(packet_state *c)
{
    const __m256i bits = _mm256_set_epi32(128, 64, 32, 16, 8, 4, 2, 1);
    const uint64_t lanes = c->traversal->lowered & c->open;
    __m256 least = _mm256_set1_ps(c->least);
    uint64_t eights;
    __m128 low;

    c->traversal->lowered = 0;
    if (!lanes)
        return;
    for (eights = eights_of(lanes); eights; eights &= eights - 1) {
        const uint32_t i = first_of64(eights) & 56;
        const __m256i in = _mm256_and_si256(bits, _mm256_set1_epi32((int)(lanes >> i)));
        const __m256 which = _mm256_castsi256_ps(_mm256_cmpeq_epi32(in, bits)), old = _mm256_load_ps(c->limit + i);
        __m256 limit = _mm256_set_m128(four_limits_avx2(c, i + 4), four_limits_avx2(c, i));

        limit = _mm256_blendv_ps(old, limit, which);
        least = _mm256_min_ps(least, _mm256_blendv_ps(least, limit, which));
        _mm256_store_ps(c->limit + i, limit);
        _mm256_storeu_ps(c->traversal->soa.local.smax + i, limit);
    }
    low = _mm_min_ps(_mm256_castps256_ps128(least), _mm256_extractf128_ps(least, 1));
    low = _mm_min_ps(low, _mm_movehl_ps(low, low));
    c->least = _mm_cvtss_f32(_mm_min_ss(low, _mm_movehdup_ps(low)));
}

#ifndef __AVX512VL__

/* Masks of four comparisons, for lanes of 64 bits. */
PACKET_TARGET static inline __m256i wide_avx2(__m128 hit)
{
    return _mm256_cvtepi32_epi64(_mm_castps_si128(hit));
}

PACKET_TARGET static inline uint32_t few_avx2(const bvh_node *node, const packet_state *c, uint64_t lanes,
                                               float entry[BVH_WIDTH], uint64_t hit_mask[BVH_WIDTH])
{
    __m256i low = _mm256_setzero_si256(), high = low;
    __m256 first = _mm256_set1_ps(HUGE_VALF), any = _mm256_setzero_ps();
    int k;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t lane = first_of64(lanes);
        const __m256i bit = _mm256_set1_epi64x((long long)((uint64_t)1 << lane));
        __m256 in = _mm256_setzero_ps(), out = _mm256_broadcast_ss(&c->limit[lane]), hit;

        for (k = 0; k < 3; k++) {
            __m256 near = _mm256_load_ps(node->bounds[c->near_row[k]]);
            __m256 far = _mm256_load_ps(node->bounds[c->near_row[k] ^ 1]);
            __m256 r = _mm256_broadcast_ss(&c->inverse[k][lane]);
            in = later(in, _mm256_fmsub_ps(near, r, _mm256_broadcast_ss(&c->near_offset[k][lane])));
            out = sooner(out, _mm256_fmsub_ps(far, r, _mm256_broadcast_ss(&c->far_offset[k][lane])));
        }
        hit = _mm256_cmp_ps(in, out, _CMP_LE_OQ);
        first = _mm256_blendv_ps(first, sooner(first, in), hit);
        any = _mm256_or_ps(any, hit);
        low = _mm256_or_si256(low, _mm256_and_si256(bit, wide_avx2(_mm256_castps256_ps128(hit))));
        high = _mm256_or_si256(high, _mm256_and_si256(bit, wide_avx2(_mm256_extractf128_ps(hit, 1))));
    }
    _mm256_storeu_ps(entry, first);
    _mm256_storeu_si256((__m256i *)(void *)hit_mask, low);
    _mm256_storeu_si256((__m256i *)(void *)(hit_mask + 4), high);
    return (uint32_t)_mm256_movemask_ps(any);
}

#else

/* Lanes that hit each child: the lower and the upper half of the lanes. */
typedef struct packet_masks { __m256i low, high; } packet_masks;

/* As few_avx2, in registers. */
PACKET_TARGET static inline __m256 few_avx512(const bvh_node *node, const packet_state *c, uint64_t lanes,
                                               packet_masks *hit_masks)
{
    __m256i low = _mm256_setzero_si256(), high = low;
    __m256 first = _mm256_set1_ps(HUGE_VALF), near[3], far[3];
    int k;

    for (k = 0; k < 3; k++) {
        near[k] = _mm256_load_ps(node->bounds[c->near_row[k]]);
        far[k] = _mm256_load_ps(node->bounds[c->near_row[k] ^ 1]);
    }
    for (; lanes; lanes &= lanes - 1) {
        const uint32_t lane = first_of64(lanes);
        const uint64_t bit = lanes & -lanes;
        __m256 in = _mm256_setzero_ps(), out = _mm256_broadcast_ss(&c->limit[lane]);
        __mmask8 hit;

        for (k = 0; k < 3; k++) {
            __m256 r = _mm256_broadcast_ss(&c->inverse[k][lane]);
            in = later(in, _mm256_fmsub_ps(near[k], r, _mm256_broadcast_ss(&c->near_offset[k][lane])));
            out = sooner(out, _mm256_fmsub_ps(far[k], r, _mm256_broadcast_ss(&c->far_offset[k][lane])));
        }
        hit = _mm256_cmp_ps_mask(in, out, _CMP_LE_OQ);
        first = _mm256_mask_min_ps(first, hit, first, in);
        low = _mm256_mask_or_epi32(low, hit, low, _mm256_set1_epi32((int)(uint32_t)bit));
        high = _mm256_mask_or_epi32(high, hit, high, _mm256_set1_epi32((int)(uint32_t)(bit >> 32)));
    }
    hit_masks->low = low;
    hit_masks->high = high;
    return first;
}

/* As push_few, without a branch for each child. */
PACKET_TARGET static inline uint32_t push_few_avx512(const packet_state *c, const bvh_node *node, uint64_t lanes,
                                                      bool sorted, packet_stack *stack, uint32_t top)
{
    const __m256i child = _mm256_load_si256((const __m256i *)(const void *)node->child);
    packet_masks hit_masks;
    const __m256 entry = few_avx512(node, c, lanes, &hit_masks);
    const __m256i any = _mm256_or_si256(hit_masks.low, hit_masks.high);
    const __mmask8 hit = _mm256_test_epi32_mask(any, any);
    const uint32_t count = (uint32_t)__builtin_popcount(hit);
    __m256i order = slot_entries_avx512(entry, hit);

    if (sorted)
        order = sort_avx512(order, count);
    _mm256_storeu_ps(stack->entry + top, entries_avx512(order));
    store_avx512(stack->at + top, _mm256_permutevar8x32_epi32(child, order));
    store_avx512(stack->low + top, _mm256_permutevar8x32_epi32(hit_masks.low, order));
    store_avx512(stack->high + top, _mm256_permutevar8x32_epi32(hit_masks.high, order));
    return top + count;
}
#define PACKET_PUSH_FEW push_few_avx512

#endif
