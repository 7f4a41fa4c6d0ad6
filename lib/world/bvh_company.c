#include "world/bvh_company.h"

#include "world/bits.h"

#include <string.h>

/* What all rays of a company share on one axis: ends of the interval of 1/d, and by end the offsets. */
typedef struct company_axis {
    float inverse[2], near_offset[2], far_offset[2];
    uint32_t near_row;           /* rows of a node's bounds: where rays enter; row ^ 1 is where they leave */
} company_axis;

/* Arrays by lane; eight lanes are loaded at once. */
#ifdef __GNUC__
#define COMPANY_ALIGNED __attribute__((aligned(64)))
#else
#define COMPANY_ALIGNED
#endif

typedef struct company {
    float inverse[3][BVH_COMPANY], near_offset[3][BVH_COMPANY], far_offset[3][BVH_COMPANY], limit[BVH_COMPANY];
    double scale[BVH_COMPANY];
    company_axis axis[3];
    bool near;                   /* all origins are near the frame */
    const bvh *tree;
    bvh_party *party;
    uint64_t open, ended;        /* lanes that still walk; those that a leaf ended */
    uint32_t width;              /* lanes, a multiple of eight */
    uint32_t frame;
} COMPANY_ALIGNED company;

/* Of rays that are taken into a frame in floats. In the units of bvh_walk.h: twice |b - o| for 1/d, of a rounded d; |b|
 * for the product, |o| three times for o and the offset, |b| + |o| for the difference, together at most 4 + 6 |o|. */
#define COMPANY_SLACK 0x1p-21f

/* What is still to be visited, and by whom. Eight entries may be stored at once. */
typedef struct company_stack { uint64_t key[BVH_STACK + BVH_WIDTH], lanes[BVH_STACK + BVH_WIDTH]; } company_stack;

/* Up to four: to take each of them to all children costs less than to take all to each child. */
static inline bool is_few(uint64_t lanes)
{
    lanes &= lanes - 1;
    lanes &= lanes - 1;
    lanes &= lanes - 1;
    return (lanes & (lanes - 1)) == 0;
}

/* A bit for each eight lanes of which there is one, at the last of them. */
static inline uint64_t eights_of(uint64_t lanes)
{
    const uint64_t low = 0x7f7f7f7f7f7f7f7fu;

    return (((lanes & low) + low) | lanes) & ~low;
}

/* Filters may take sixteen at a time: places past the width hold nothing then that is slow to compute with, as denormal
 * floats are. */
static void clear_past(pov_rays *side, uint32_t width)
{
    const size_t bytes = 8 * sizeof(float);
    int k;

    for (k = 0; k < 3; k++) {
        memset(side->framed.org[k] + width, 0, bytes);
        memset(side->framed.dir[k] + width, 0, bytes);
    }
    memset(side->framed.size + width, 0, bytes);
    memset(side->framed.smax + width, 0, bytes);
}

static void begin(company *c, bvh_party *party)
{
    c->tree = party->tree;
    c->party = party;
    c->open = party->lanes;
    c->ended = 0;
    c->width = (party->count + 7) & ~7u;
    if (c->width & 8)
        clear_past(&party->side, c->width);
    c->frame = 0;
}

static inline void end_lanes(company *c, uint64_t lanes)
{
    c->open &= ~lanes;
    c->ended |= lanes;
}

static inline void lower_limit(company *c, uint32_t i)
{
    pov_rays *side = &c->party->side;

    c->limit[i] = side->framed.smax[i] = bvh_limit(c->scale[i], side->framed.shift[i], c->party->limit[i]);
}

static inline void lower_limits(company *c)
{
    uint64_t lanes = c->party->lowered & c->open;

    for (; lanes; lanes &= lanes - 1)
        lower_limit(c, first_of64(lanes));
    c->party->lowered = 0;
}

static inline void visit(company *c, uint64_t lanes, uint32_t leaf)
{
    end_lanes(c, c->party->leaf(c->party, c->tree->leaves + (size_t)leaf * BVH_UNIT, lanes));
    lower_limits(c);
}

/* The lane of one axis. */
static inline void put_axis(company *c, uint32_t i, int k, double o, double d)
{
    const double a = fabs(d), inverse = 1.0 / copysign(a > BVH_LEAST ? a : BVH_LEAST, d);
    const double slack = fabs(inverse) * (1.0 + fabs(o)) * BVH_SLACK;

    c->inverse[k][i] = (float)inverse;
    c->near_offset[k][i] = (float)(o * inverse + slack);
    c->far_offset[k][i] = (float)(o * inverse - slack);
}

static inline void put_lane(company *c, uint32_t i, const bvh_local *l)
{
    put_axis(c, i, 0, l->org.x, l->dir.x);
    put_axis(c, i, 1, l->org.y, l->dir.y);
    put_axis(c, i, 2, l->org.z, l->dir.z);
    c->scale[i] = l->scale;
    bvh_stand(&c->party->side, i, l, 0.0f);
}

/* The places of lanes that are not in the frame hold one that is, so that bounds are not widened, and a limit that nothing
 * is within. */
static void fill_others(company *c, uint64_t in)
{
    const uint32_t some = first_of64(in);
    pov_rays *side = &c->party->side;
    uint32_t i;
    int k;

    for (i = 0; i < c->width; i++) {
        if (in >> i & 1)
            continue;
        for (k = 0; k < 3; k++) {
            c->inverse[k][i] = c->inverse[k][some];
            side->framed.org[k][i] = side->framed.org[k][some];
        }
        c->limit[i] = -1.0f;
    }
}

/* Lanes that are in the frame. */
static uint64_t enter_each(company *c, uint32_t frame, uint64_t lanes, uint64_t *blind)
{
    const bvh_party *party = c->party;
    uint64_t in = 0;
    bvh_local l;
    uint32_t i;

    for (; lanes; lanes &= lanes - 1) {
        i = first_of64(lanes);
        bvh_write(party, i);
        if (!bvh_enter(&c->tree->frames[frame], party->rays[i], party->length[i], party->side.per_length[i], &l))
            continue;
        if (l.slack > BVH_SLACK) {
            *blind |= (uint64_t)1 << i;
            continue;
        }
        put_lane(c, i, &l);
        lower_limit(c, i);
        in |= (uint64_t)1 << i;
    }
    return in;
}

/* Bounds of one axis: of 1/d in lo .. hi, of o in first .. last. */
static inline void bound(company *c, int k, float lo, float hi, float first, float last)
{
    company_axis *a = &c->axis[k];
    bool backward = lo < 0.0f;
    double near = (double)(backward ? first : last), far = (double)(backward ? last : first);
    double size = fabs(near) > fabs(far) ? fabs(near) : fabs(far), slack = 2.0 * BVH_SLACK * (1.0 + size);
    int end;

    c->near = c->near && size <= BVH_NEAR;

    a->inverse[0] = lo;
    a->inverse[1] = hi;
    a->near_row = 2u * (uint32_t)k + backward;
    for (end = 0; end < 2; end++) {
        double r = (double)a->inverse[end];
        a->near_offset[end] = (float)(near * r + fabs(r) * slack);
        a->far_offset[end] = (float)(far * r - fabs(r) * slack);
    }
}

static inline float greater(float a, float b) { return a > b ? a : b; }
static inline float lesser(float a, float b) { return a < b ? a : b; }

/* ---- for every processor ---- */

/* Of 1/d and o on one axis. Lanes that take no part hold another's values. */
static inline void bounds_portable(const company *c, int k, float lo[8], float hi[8], float first[8], float last[8])
{
    const float *inverse = c->inverse[k], *o = c->party->side.framed.org[k];
    uint32_t i, j;

    for (j = 0; j < 8; j++) {
        lo[j] = hi[j] = inverse[j];
        first[j] = last[j] = o[j];
    }
    for (i = 8; i < c->width; i += 8)
        for (j = 0; j < 8; j++) {
            lo[j] = lesser(inverse[i + j], lo[j]);
            hi[j] = greater(inverse[i + j], hi[j]);
            first[j] = lesser(o[i + j], first[j]);
            last[j] = greater(o[i + j], last[j]);
        }
}

/* Boxes that any lane may meet, and what no lane enters them before. */
static inline uint32_t group_portable(const bvh_node *node, const company *c, float entry[BVH_WIDTH])
{
    float leave[BVH_WIDTH];
    uint32_t mask = 0;
    int i, k;

    for (i = 0; i < BVH_WIDTH; i++) {
        entry[i] = 0.0f;
        leave[i] = HUGE_VALF;
    }
    for (k = 0; k < 3; k++) {
        const company_axis *a = &c->axis[k];
        const float *near = node->bounds[a->near_row], *far = node->bounds[a->near_row ^ 1];
        for (i = 0; i < BVH_WIDTH; i++) {
            float x = near[i] * a->inverse[0] - a->near_offset[0], y = near[i] * a->inverse[1] - a->near_offset[1];
            entry[i] = greater(entry[i], lesser(x, y));
        }
        for (i = 0; i < BVH_WIDTH; i++) {
            float x = far[i] * a->inverse[0] - a->far_offset[0], y = far[i] * a->inverse[1] - a->far_offset[1];
            leave[i] = lesser(leave[i], greater(x, y));
        }
    }
    for (i = 0; i < BVH_WIDTH; i++)
        mask |= (uint32_t)(entry[i] <= leave[i]) << i;
    return mask;
}

/* Boxes that any of a few lanes may meet, by child which of them, and where the first of these enters it. */
static inline uint32_t few_portable(const bvh_node *node, const company *c, uint64_t lanes, float entry[BVH_WIDTH],
                                    uint64_t meet[BVH_WIDTH])
{
    uint32_t mask = 0;
    int i, k;

    for (i = 0; i < BVH_WIDTH; i++) {
        entry[i] = HUGE_VALF;
        meet[i] = 0;
    }
    for (; lanes; lanes &= lanes - 1) {
        const uint32_t lane = first_of64(lanes);
        float in[BVH_WIDTH], out[BVH_WIDTH];

        for (i = 0; i < BVH_WIDTH; i++) {
            in[i] = 0.0f;
            out[i] = c->limit[lane];
        }
        for (k = 0; k < 3; k++) {
            const float *near = node->bounds[c->axis[k].near_row], *far = node->bounds[c->axis[k].near_row ^ 1];
            const float r = c->inverse[k][lane], first = c->near_offset[k][lane], last = c->far_offset[k][lane];
            for (i = 0; i < BVH_WIDTH; i++)
                in[i] = greater(in[i], near[i] * r - first);
            for (i = 0; i < BVH_WIDTH; i++)
                out[i] = lesser(out[i], far[i] * r - last);
        }
        for (i = 0; i < BVH_WIDTH; i++)
            if (in[i] <= out[i]) {
                entry[i] = lesser(entry[i], in[i]);
                meet[i] |= (uint64_t)1 << lane;
                mask |= 1u << i;
            }
    }
    return mask;
}

/* The lanes that may meet a child. */
static inline uint64_t lanes_portable(const bvh_node *node, uint32_t child, const company *c, uint64_t lanes,
                                      uint64_t eights)
{
    uint64_t meet = 0;
    uint32_t j;
    int k;

    for (; eights; eights &= eights - 1) {
        const uint32_t i = first_of64(eights) & 56;
        float entry[8], leave[8];
        for (j = 0; j < 8; j++) {
            entry[j] = 0.0f;
            leave[j] = c->limit[i + j];
        }
        for (k = 0; k < 3; k++) {
            uint32_t row = c->axis[k].near_row;
            float near = node->bounds[row][child], far = node->bounds[row ^ 1][child];
            for (j = 0; j < 8; j++) {
                float x = near * c->inverse[k][i + j] - c->near_offset[k][i + j];
                float y = far * c->inverse[k][i + j] - c->far_offset[k][i + j];
                entry[j] = greater(entry[j], x);
                leave[j] = lesser(leave[j], y);
            }
        }
        for (j = 0; j < 8; j++)
            meet |= (uint64_t)(entry[j] <= leave[j]) << (i + j);
    }
    return meet & lanes;
}

/* The lanes whose limit is not before an entry. */
static inline uint64_t within_portable(const company *c, float entry, uint64_t lanes)
{
    uint64_t in = 0;
    uint32_t i;

    for (i = 0; i < c->width; i++)
        in |= (uint64_t)(entry <= c->limit[i]) << i;
    return in & lanes;
}

#define COMPANY_TARGET
#define COMPANY_NAME(name) name##_portable
#define COMPANY_BOUNDS bounds_portable
#define COMPANY_GROUP group_portable
#define COMPANY_FEW few_portable
#define COMPANY_LANES lanes_portable
#define COMPANY_WITHIN within_portable
#include "world/bvh_company_body.h"
#undef COMPANY_TARGET
#undef COMPANY_NAME
#undef COMPANY_BOUNDS
#undef COMPANY_GROUP
#undef COMPANY_FEW
#undef COMPANY_LANES
#undef COMPANY_WITHIN
#undef COMPANY_PUSH

/* ---- for those with AVX2 ---- */

#if defined(__x86_64__) && defined(__GNUC__) && !defined(POV_PORTABLE)

#include "world/bvh_avx2.h"

#define COMPANY_TARGET BVH_AVX2

COMPANY_TARGET static inline void bounds_avx2(const company *c, int k, float lo[8], float hi[8], float first[8],
                                              float last[8])
{
    const float *org = c->party->side.framed.org[k];
    __m256 less = _mm256_load_ps(c->inverse[k]), more = less, low = _mm256_loadu_ps(org), high = low;
    uint32_t i;

    for (i = 8; i < c->width; i += 8) {
        __m256 inverse = _mm256_load_ps(c->inverse[k] + i), o = _mm256_loadu_ps(org + i);
        less = _mm256_min_ps(inverse, less);
        more = _mm256_max_ps(inverse, more);
        low = _mm256_min_ps(o, low);
        high = _mm256_max_ps(o, high);
    }
    _mm256_storeu_ps(lo, less);
    _mm256_storeu_ps(hi, more);
    _mm256_storeu_ps(first, low);
    _mm256_storeu_ps(last, high);
}

COMPANY_TARGET static inline uint32_t group_avx2(const bvh_node *node, const company *c, float entry[BVH_WIDTH])
{
    __m256 in = _mm256_setzero_ps(), out = _mm256_set1_ps(HUGE_VALF);
    int k;

    for (k = 0; k < 3; k++) {
        const company_axis *a = &c->axis[k];
        __m256 near = _mm256_load_ps(node->bounds[a->near_row]), far = _mm256_load_ps(node->bounds[a->near_row ^ 1]);
        __m256 r0 = _mm256_broadcast_ss(&a->inverse[0]), r1 = _mm256_broadcast_ss(&a->inverse[1]);
        __m256 x = _mm256_fmsub_ps(near, r0, _mm256_broadcast_ss(&a->near_offset[0]));
        __m256 y = _mm256_fmsub_ps(near, r1, _mm256_broadcast_ss(&a->near_offset[1]));
        in = later(in, sooner(x, y));
        x = _mm256_fmsub_ps(far, r0, _mm256_broadcast_ss(&a->far_offset[0]));
        y = _mm256_fmsub_ps(far, r1, _mm256_broadcast_ss(&a->far_offset[1]));
        out = sooner(out, later(x, y));
    }
    _mm256_storeu_ps(entry, in);
    return (uint32_t)_mm256_movemask_ps(_mm256_cmp_ps(in, out, _CMP_LE_OQ));
}

COMPANY_TARGET static inline uint64_t lanes_avx2(const bvh_node *node, uint32_t child, const company *c, uint64_t lanes,
                                                 uint64_t eights)
{
    __m256 near[3], far[3];
    uint64_t meet = 0;
    int k;

    for (k = 0; k < 3; k++) {
        near[k] = _mm256_broadcast_ss(&node->bounds[c->axis[k].near_row][child]);
        far[k] = _mm256_broadcast_ss(&node->bounds[c->axis[k].near_row ^ 1][child]);
    }
    for (; eights; eights &= eights - 1) {
        const uint32_t i = first_of64(eights) & 56;
        __m256 in = _mm256_setzero_ps(), out = _mm256_load_ps(c->limit + i);
        for (k = 0; k < 3; k++) {
            __m256 inverse = _mm256_load_ps(c->inverse[k] + i);
            in = later(in, _mm256_fmsub_ps(near[k], inverse, _mm256_load_ps(c->near_offset[k] + i)));
            out = sooner(out, _mm256_fmsub_ps(far[k], inverse, _mm256_load_ps(c->far_offset[k] + i)));
        }
        meet |= (uint64_t)(uint32_t)_mm256_movemask_ps(_mm256_cmp_ps(in, out, _CMP_LE_OQ)) << i;
    }
    return meet & lanes;
}

COMPANY_TARGET static inline uint64_t within_avx2(const company *c, float entry, uint64_t lanes)
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

#ifndef __AVX512VL__

/* Four comparisons' outcomes, for lanes of 64 bits. */
COMPANY_TARGET static inline __m256i wide_avx2(__m128 met)
{
    return _mm256_cvtepi32_epi64(_mm_castps_si128(met));
}

COMPANY_TARGET static inline uint32_t few_avx2(const bvh_node *node, const company *c, uint64_t lanes,
                                               float entry[BVH_WIDTH], uint64_t meet[BVH_WIDTH])
{
    __m256i low = _mm256_setzero_si256(), high = low;
    __m256 first = _mm256_set1_ps(HUGE_VALF), any = _mm256_setzero_ps();
    int k;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t lane = first_of64(lanes);
        const __m256i bit = _mm256_set1_epi64x((long long)((uint64_t)1 << lane));
        __m256 in = _mm256_setzero_ps(), out = _mm256_broadcast_ss(&c->limit[lane]), met;

        for (k = 0; k < 3; k++) {
            __m256 near = _mm256_load_ps(node->bounds[c->axis[k].near_row]);
            __m256 far = _mm256_load_ps(node->bounds[c->axis[k].near_row ^ 1]);
            __m256 r = _mm256_broadcast_ss(&c->inverse[k][lane]);
            in = later(in, _mm256_fmsub_ps(near, r, _mm256_broadcast_ss(&c->near_offset[k][lane])));
            out = sooner(out, _mm256_fmsub_ps(far, r, _mm256_broadcast_ss(&c->far_offset[k][lane])));
        }
        met = _mm256_cmp_ps(in, out, _CMP_LE_OQ);
        first = _mm256_blendv_ps(first, sooner(first, in), met);
        any = _mm256_or_ps(any, met);
        low = _mm256_or_si256(low, _mm256_and_si256(bit, wide_avx2(_mm256_castps256_ps128(met))));
        high = _mm256_or_si256(high, _mm256_and_si256(bit, wide_avx2(_mm256_extractf128_ps(met, 1))));
    }
    _mm256_storeu_ps(entry, first);
    _mm256_storeu_si256((__m256i *)(void *)meet, low);
    _mm256_storeu_si256((__m256i *)(void *)(meet + 4), high);
    return (uint32_t)_mm256_movemask_ps(any);
}

#else

/* Up to so many are always held against all children, one by one. */
enum { COMPANY_FEW_LANES = 12 };

/* As few_avx2, in registers. */
COMPANY_TARGET static inline __m256 few_avx512(const bvh_node *node, const company *c, uint64_t lanes, __m512i *meets)
{
    __m512i meet = _mm512_setzero_si512();
    __m256 first = _mm256_set1_ps(HUGE_VALF), near[3], far[3];
    int k;

    for (k = 0; k < 3; k++) {
        near[k] = _mm256_load_ps(node->bounds[c->axis[k].near_row]);
        far[k] = _mm256_load_ps(node->bounds[c->axis[k].near_row ^ 1]);
    }
    for (; lanes; lanes &= lanes - 1) {
        const uint32_t lane = first_of64(lanes);
        __m256 in = _mm256_setzero_ps(), out = _mm256_broadcast_ss(&c->limit[lane]);
        __mmask8 met;

        for (k = 0; k < 3; k++) {
            __m256 r = _mm256_broadcast_ss(&c->inverse[k][lane]);
            in = later(in, _mm256_fmsub_ps(near[k], r, _mm256_broadcast_ss(&c->near_offset[k][lane])));
            out = sooner(out, _mm256_fmsub_ps(far[k], r, _mm256_broadcast_ss(&c->far_offset[k][lane])));
        }
        met = _mm256_cmp_ps_mask(in, out, _CMP_LE_OQ);
        first = _mm256_mask_min_ps(first, met, first, in);
        meet = _mm512_mask_or_epi64(meet, met, meet, _mm512_set1_epi64((long long)(lanes & -lanes)));
    }
    *meets = meet;
    return first;
}

/* Of all children, whom lanes meet and what they do not enter them before. */
COMPANY_TARGET static inline __m256 meet_avx512(const bvh_node *node, const company *c, uint64_t lanes, __m512i *meets)
{
    const uint32_t count = (uint32_t)__builtin_popcountll(lanes);
    bool few = count <= COMPANY_FEW_LANES;
    float entry[BVH_WIDTH];
    uint64_t eights = 0;
    uint32_t mask = 0;
    __m512i meet = _mm512_setzero_si512();

    if (!few) {
        mask = group_avx2(node, c, entry);
        eights = eights_of(lanes);
        few = count <= (uint32_t)__builtin_popcountll(eights) * (uint32_t)__builtin_popcount(mask);
    }
    if (few)
        return few_avx512(node, c, lanes, meets);
    for (; mask; mask &= mask - 1) {
        uint64_t by = lanes_avx2(node, first_of(mask), c, lanes, eights);
        meet = _mm512_mask_set1_epi64(meet, (__mmask8)(mask & -mask), (long long)by);
    }
    *meets = meet;
    return _mm256_loadu_ps(entry);
}

/* The greatest first, by bitonic sorting: by stage, whom each is held against, and who keeps the greater. */
COMPANY_TARGET static inline __m512i sort_avx512(__m512i v, uint32_t count)
{
#define STAGE(other, greater) v = _mm512_mask_max_epu64(_mm512_min_epu64(v, other), greater, v, other)
    STAGE(_mm512_shuffle_epi32(v, _MM_PERM_BADC), 0x99);
    STAGE(_mm512_permutex_epi64(v, 0x4e), 0xc3);
    STAGE(_mm512_shuffle_epi32(v, _MM_PERM_BADC), 0xa5);
    if (count > 4) {
        STAGE(_mm512_shuffle_i64x2(v, v, 0x4e), 0x0f);
        STAGE(_mm512_permutex_epi64(v, 0x4e), 0x33);
        STAGE(_mm512_shuffle_epi32(v, _MM_PERM_BADC), 0x55);
    }
#undef STAGE
    return v;
}

/* As push, without a branch for each child. Children are sorted by distance and place in the node. */
COMPANY_TARGET static inline uint32_t push_avx512(const company *c, const bvh_node *node, uint64_t lanes, bool sorted,
                                                  company_stack *stack, uint32_t top)
{
    const __m512i places = _mm512_set_epi64(7, 6, 5, 4, 3, 2, 1, 0);
    __m512i keys = _mm512_cvtepu32_epi64(_mm256_load_si256((const __m256i *)(const void *)node->child)), meets;
    const __m256 entry = meet_avx512(node, c, lanes, &meets);
    const __m512i high = _mm512_slli_epi64(_mm512_cvtepu32_epi64(_mm256_castps_si256(entry)), 32);
    const __mmask8 met = _mm512_test_epi64_mask(meets, meets);
    const uint32_t count = (uint32_t)__builtin_popcount(met);

    keys = _mm512_or_si512(high, keys);
    if (sorted) {
        /* Only the three lowest bits say where from. */
        __m512i order = sort_avx512(_mm512_maskz_compress_epi64(met, _mm512_or_si512(high, places)), count);
        keys = _mm512_permutexvar_epi64(order, keys);
        meets = _mm512_permutexvar_epi64(order, meets);
    } else {
        keys = _mm512_maskz_compress_epi64(met, keys);
        meets = _mm512_maskz_compress_epi64(met, meets);
    }
    _mm512_storeu_si512(stack->key + top, keys);
    _mm512_storeu_si512(stack->lanes + top, meets);
    return top + count;
}
#define COMPANY_PUSH push_avx512

#endif

#define COMPANY_NAME(name) name##_avx2
#define COMPANY_BOUNDS bounds_avx2
#define COMPANY_GROUP group_avx2
#define COMPANY_FEW few_avx2
#define COMPANY_LANES lanes_avx2
#define COMPANY_WITHIN within_avx2
#include "world/bvh_company_body.h"

#endif
