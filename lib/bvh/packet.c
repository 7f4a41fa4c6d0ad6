/* Packet traversal.
 *
 * Rays of similar origin and direction hit nearly the same boxes. So the whole packet is tested against the eight
 * children of a node first, with the intervals of 1/d and o: a plane at b is hit no earlier than the minimum of (b - o)
 * r at both ends r of the first interval, with the end o of the second that makes it least. Floats lose at most 4 + 5
 * |o| there in the units of traverse.h: twice |b - o| for r, |b| for the product, |o| twice for o and the offset, |b| +
 * |o| for the difference. Twice the single ray's slack covers it.
 *
 * Each remaining box is tested against eight rays at once, with the single ray's formula. With the other end of o, and
 * the minimum of all limits, the same products tell which boxes all rays definitely hit; these are not tested again. A
 * wrong answer there would only test one box too many. The packet test's order of boxes is a hint; it does not affect
 * the result. */
#include "base/simd.h"
#include "bvh/traverse.h"

#include <string.h>

/* Bounds of all rays of a packet, by axis: ends of the interval of 1/d, and the offsets for each end. The fourth
 * element is unused. */
typedef struct packet_bounds { float inverse[2][4], near_offset[2][4], far_offset[2][4]; } packet_bounds;

/* Arrays by lane; eight lanes are loaded at once. */
typedef struct SIMD_ALIGNED packet_state {
    float inverse[3][BVH_LANES], near_offset[3][BVH_LANES], far_offset[3][BVH_LANES], limit[BVH_LANES];
    double scale[BVH_LANES];
    packet_bounds bounds;
    uint32_t near_row[4];        /* rows of a node's bounds: where rays enter; row ^ 1 is where they leave */
    float least;                 /* minimum of all limits */
    bool near;                   /* all origins are near the frame */
    const bvh *tree;
    bvh_traversal *traversal;
    uint64_t open, ended;        /* active lanes; lanes that a leaf ended */
    uint32_t width;              /* lanes, a multiple of eight */
    uint32_t frame;
} packet_state;

/* Slack of rays transformed to a frame in floats. In the units of traverse.h: twice |b - o| for 1/d, of a rounded d;
 * |b| for the product, |o| three times for o and the offset, |b| + |o| for the difference, together at most 4 + 6
 * |o|. */
#define PACKET_SLACK 0x1p-21f

/* Stack of nodes to visit, with their lanes as a lower and an upper half. Entries may be too small by a few units in
 * the last place. Eight of each may be stored at once. */
typedef struct packet_stack {
    float entry[BVH_STACK + BVH_WIDTH];
    uint32_t at[BVH_STACK + BVH_WIDTH], low[BVH_STACK + BVH_WIDTH], high[BVH_STACK + BVH_WIDTH];
} packet_stack;

static inline void push_entry(packet_stack *s, uint32_t top, float entry, uint32_t at, uint64_t lanes)
{
    s->entry[top] = entry;
    s->at[top] = at;
    s->low[top] = (uint32_t)lanes;
    s->high[top] = (uint32_t)(lanes >> 32);
}

static inline uint64_t lanes_on(const packet_stack *s, uint32_t top)
{
    return (uint64_t)s->high[top] << 32 | s->low[top];
}

/* Insert above the entries from base on that are nearer. */
static inline void insert_entry(packet_stack *s, uint32_t base, uint32_t top, float entry, uint32_t at, uint64_t lanes)
{
    for (; top > base && s->entry[top - 1] < entry; top--)
        push_entry(s, top, s->entry[top - 1], s->at[top - 1], lanes_on(s, top - 1));
    push_entry(s, top, entry, at, lanes);
}

#if defined(__AVX512VL__) && defined(__GNUC__)

/* Up to so many lanes are tested one by one against all children. */
enum { PACKET_FEW_LANES = 12 };

static inline bool is_few(uint64_t lanes) { return __builtin_popcountll(lanes) <= PACKET_FEW_LANES; }

/* Is testing lane by lane cheaper than testing the children, eight lanes at a time? */
static inline bool are_less(uint64_t lanes, uint64_t eights, uint32_t children)
{
    return __builtin_popcountll(lanes) <= __builtin_popcountll(eights) * __builtin_popcount(children);
}

#else

/* Up to four lanes: testing each against all children costs less than testing all against each child. */
static inline bool is_few(uint64_t lanes)
{
    lanes &= lanes - 1;
    lanes &= lanes - 1;
    lanes &= lanes - 1;
    return (lanes & (lanes - 1)) == 0;
}

static inline bool are_less(uint64_t lanes, uint64_t eights, uint32_t children)
{
    (void)lanes, (void)eights, (void)children;
    return false;
}

#endif

/* One bit for each group of eight lanes with a set bit, at the group's last lane. */
static inline uint64_t eights_of(uint64_t lanes)
{
    const uint64_t low = 0x7f7f7f7f7f7f7f7fu;

    return (((lanes & low) + low) | lanes) & ~low;
}

/* Filters may process sixteen lanes at a time: lanes past the width must not hold values that are slow to compute with,
 * such as denormals. */
static void zero_past(pov_rays *soa, uint32_t width)
{
    const size_t bytes = 8 * sizeof(float);
    int k;

    for (k = 0; k < 3; k++) {
        memset(soa->local.org[k] + width, 0, bytes);
        memset(soa->local.dir[k] + width, 0, bytes);
    }
    memset(soa->local.size + width, 0, bytes);
    memset(soa->local.smax + width, 0, bytes);
}

static void begin(packet_state *c, bvh_traversal *traversal)
{
    c->tree = traversal->tree;
    c->traversal = traversal;
    c->open = traversal->lanes;
    c->ended = 0;
    c->width = (traversal->count + 7) & ~7u;
    if (c->width & 8)
        zero_past(&traversal->soa, c->width);
    c->frame = 0;
}

static inline void end_lanes(packet_state *c, uint64_t lanes)
{
    c->open &= ~lanes;
    c->ended |= lanes;
}

static inline void lower_limit(packet_state *c, uint32_t i)
{
    pov_rays *soa = &c->traversal->soa;

    c->limit[i] = soa->local.smax[i] = bvh_limit(c->scale[i], soa->local.shift[i], c->traversal->limit[i]);
    c->least = c->limit[i] < c->least ? c->limit[i] : c->least;
}

static inline void lower_limits(packet_state *c)
{
    uint64_t lanes = c->traversal->lowered & c->open;

    for (; lanes; lanes &= lanes - 1)
        lower_limit(c, first_of64(lanes));
    c->traversal->lowered = 0;
}

/* Set one axis of a lane. */
static inline void put_axis(packet_state *c, uint32_t i, int k, double o, double d)
{
    const double a = fabs(d), inverse = 1.0 / copysign(a > BVH_LEAST ? a : BVH_LEAST, d);
    const double slack = fabs(inverse) * (1.0 + fabs(o)) * BVH_SLACK;

    c->inverse[k][i] = (float)inverse;
    c->near_offset[k][i] = (float)(o * inverse + slack);
    c->far_offset[k][i] = (float)(o * inverse - slack);
}

static inline void put_lane(packet_state *c, uint32_t i, const bvh_local *l)
{
    put_axis(c, i, 0, l->org.x, l->dir.x);
    put_axis(c, i, 1, l->org.y, l->dir.y);
    put_axis(c, i, 2, l->org.z, l->dir.z);
    c->scale[i] = l->scale;
    bvh_to_frame(&c->traversal->soa, i, l, 0.0f);
}

/* Inactive lanes are filled with a copy of an active ray, so that they do not widen the packet's bounds, and with a
 * limit below every hit. */
static void fill_others(packet_state *c, uint64_t in)
{
    const uint32_t some = first_of64(in);
    pov_rays *soa = &c->traversal->soa;
    uint32_t i;
    int k;

    for (i = 0; i < c->width; i++) {
        if (in >> i & 1)
            continue;
        for (k = 0; k < 3; k++) {
            c->inverse[k][i] = c->inverse[k][some];
            soa->local.org[k][i] = soa->local.org[k][some];
        }
        c->limit[i] = -1.0f;
    }
}

/* Transform each lane to the frame; returns the lanes that do not miss it. */
static uint64_t enter_each(packet_state *c, uint32_t frame, uint64_t lanes, uint64_t *blind)
{
    bvh_traversal *traversal = c->traversal;
    uint64_t in = 0;
    bvh_local l;
    uint32_t i;

    for (; lanes; lanes &= lanes - 1) {
        i = first_of64(lanes);
        if (!bvh_enter(&c->tree->frames[frame], bvh_ray(traversal, i), traversal->length[i], traversal->soa.per_length[i], &l))
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

/* Lanes continue as single rays from a reference in the frame. */
static void go_single(packet_state *c, uint64_t lanes, uint32_t at)
{
    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = first_of64(lanes);

        if (bvh_go_single(c->traversal, i, c->frame, at))
            end_lanes(c, (uint64_t)1 << i);
    }
    c->traversal->in = &c->tree->frames[c->frame];
    lower_limits(c);
}

/* Bounds along one axis: 1/d lies in lo .. hi, o in first .. last. */
static inline void bound(packet_state *c, int k, float lo, float hi, float first, float last)
{
    packet_bounds *b = &c->bounds;
    bool backward = lo < 0.0f;
    double near = (double)(backward ? first : last), far = (double)(backward ? last : first);
    double size = fabs(near) > fabs(far) ? fabs(near) : fabs(far), slack = 2.0 * BVH_SLACK * (1.0 + size);
    int end;

    c->near = c->near && size <= BVH_NEAR;
    c->near_row[k] = 2u * (uint32_t)k + backward;
    b->inverse[0][k] = lo;
    b->inverse[1][k] = hi;
    for (end = 0; end < 2; end++) {
        double r = (double)b->inverse[end][k];
        b->near_offset[end][k] = (float)(near * r + fabs(r) * slack);
        b->far_offset[end][k] = (float)(far * r - fabs(r) * slack);
    }
}

static inline float greater(float a, float b) { return a > b ? a : b; }
static inline float lesser(float a, float b) { return a < b ? a : b; }

/* ---- for every processor ---- */

/* Bounds of 1/d and o on one axis, by eight columns. Inactive lanes hold another lane's values. */
static inline void bound_axis(packet_state *c, int k)
{
    const float *inverse = c->inverse[k], *o = c->traversal->soa.local.org[k];
    float lo[8], hi[8], first[8], last[8];
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
    for (j = 1; j < 8; j++) {
        lo[0] = lesser(lo[j], lo[0]);
        hi[0] = greater(hi[j], hi[0]);
        first[0] = lesser(first[j], first[0]);
        last[0] = greater(last[j], last[0]);
    }
    bound(c, k, lo[0], hi[0], first[0], last[0]);
}

static inline void bound_all_portable(packet_state *c)
{
    int k;

    c->near = true;
    for (k = 0; k < 3; k++)
        bound_axis(c, k);
}

/* Children that any lane may hit, and lower bounds of their entries. */
static inline uint32_t group_portable(const bvh_node *node, const packet_state *c, float entry[BVH_WIDTH], uint32_t *all)
{
    float leave[BVH_WIDTH];
    const packet_bounds *b = &c->bounds;
    uint32_t mask = 0;
    int i, k;

    *all = 0;
    for (i = 0; i < BVH_WIDTH; i++) {
        entry[i] = 0.0f;
        leave[i] = HUGE_VALF;
    }
    for (k = 0; k < 3; k++) {
        const float *near = node->bounds[c->near_row[k]], *far = node->bounds[c->near_row[k] ^ 1];
        for (i = 0; i < BVH_WIDTH; i++) {
            float x = near[i] * b->inverse[0][k] - b->near_offset[0][k];
            float y = near[i] * b->inverse[1][k] - b->near_offset[1][k];
            entry[i] = greater(entry[i], lesser(x, y));
        }
        for (i = 0; i < BVH_WIDTH; i++) {
            float x = far[i] * b->inverse[0][k] - b->far_offset[0][k];
            float y = far[i] * b->inverse[1][k] - b->far_offset[1][k];
            leave[i] = lesser(leave[i], greater(x, y));
        }
    }
    for (i = 0; i < BVH_WIDTH; i++)
        mask |= (uint32_t)(entry[i] <= leave[i]) << i;
    return mask;
}

/* Children that any of a few lanes may hit, the lanes of each child, and its first entry. */
static inline uint32_t few_portable(const bvh_node *node, const packet_state *c, uint64_t lanes, float entry[BVH_WIDTH],
                                    uint64_t hit_mask[BVH_WIDTH])
{
    uint32_t mask = 0;
    int i, k;

    for (i = 0; i < BVH_WIDTH; i++) {
        entry[i] = HUGE_VALF;
        hit_mask[i] = 0;
    }
    for (; lanes; lanes &= lanes - 1) {
        const uint32_t lane = first_of64(lanes);
        float in[BVH_WIDTH], out[BVH_WIDTH];

        for (i = 0; i < BVH_WIDTH; i++) {
            in[i] = 0.0f;
            out[i] = c->limit[lane];
        }
        for (k = 0; k < 3; k++) {
            const float *near = node->bounds[c->near_row[k]], *far = node->bounds[c->near_row[k] ^ 1];
            const float r = c->inverse[k][lane], first = c->near_offset[k][lane], last = c->far_offset[k][lane];
            for (i = 0; i < BVH_WIDTH; i++)
                in[i] = greater(in[i], near[i] * r - first);
            for (i = 0; i < BVH_WIDTH; i++)
                out[i] = lesser(out[i], far[i] * r - last);
        }
        for (i = 0; i < BVH_WIDTH; i++)
            if (in[i] <= out[i]) {
                entry[i] = lesser(entry[i], in[i]);
                hit_mask[i] |= (uint64_t)1 << lane;
                mask |= 1u << i;
            }
    }
    return mask;
}

/* Lanes that may hit a child. */
static inline uint64_t lanes_portable(const bvh_node *node, uint32_t child, const packet_state *c, uint64_t lanes,
                                      uint64_t eights)
{
    uint64_t hit_mask = 0;
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
            uint32_t row = c->near_row[k];
            float near = node->bounds[row][child], far = node->bounds[row ^ 1][child];
            for (j = 0; j < 8; j++) {
                float x = near * c->inverse[k][i + j] - c->near_offset[k][i + j];
                float y = far * c->inverse[k][i + j] - c->far_offset[k][i + j];
                entry[j] = greater(entry[j], x);
                leave[j] = lesser(leave[j], y);
            }
        }
        for (j = 0; j < 8; j++)
            hit_mask |= (uint64_t)(entry[j] <= leave[j]) << (i + j);
    }
    return hit_mask & lanes;
}

/* Lanes whose limit is not before an entry. */
static inline uint64_t within_portable(const packet_state *c, float entry, uint64_t lanes)
{
    uint64_t in = 0;
    uint32_t i;

    for (i = 0; i < c->width; i++)
        in |= (uint64_t)(entry <= c->limit[i]) << i;
    return in & lanes;
}

#define PACKET_TARGET
#define PACKET_NAME(name) name##_portable
#define PACKET_BOUND_ALL bound_all_portable
#define PACKET_GROUP group_portable
#define PACKET_FEW few_portable
#define PACKET_LANES lanes_portable
#define PACKET_WITHIN within_portable
#define PACKET_LOWER lower_limits
#include "bvh/packet_body.h"
#undef PACKET_TARGET
#undef PACKET_NAME
#undef PACKET_BOUND_ALL
#undef PACKET_GROUP
#undef PACKET_FEW
#undef PACKET_LANES
#undef PACKET_WITHIN
#undef PACKET_LOWER
#undef PACKET_PUSH_FEW

/* ---- for those with AVX2 ---- */

#if defined(__x86_64__) && defined(__GNUC__) && !defined(POV_PORTABLE)

#include "bvh/packet_avx2.h"

#define PACKET_NAME(name) name##_avx2
#define PACKET_BOUND_ALL bound_all_avx2
#define PACKET_GROUP group_avx2
#define PACKET_FEW few_avx2
#define PACKET_LANES lanes_avx2
#define PACKET_WITHIN within_avx2
#define PACKET_LOWER lower_avx2
#include "bvh/packet_body.h"

#ifdef __AVX512VL__
#include "bvh/interleaved.h"
#endif

#endif
